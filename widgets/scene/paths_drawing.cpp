#include "scene/bead_shader.h"
#include "scene/coarse_beads.h"
#include "scene/drawing_data.h"
#include "scene/feature_edges.h"
#include "scene/fill_order.h"
#include "scene/mesh_buffers.h"
#include "scene/surface.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "plan/arrival_times.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace voluta::scene {

namespace {

// distance from the bead's middle relative to its height: above the surface
constexpr double kLineOverBead = 0.62;

constexpr std::size_t kChunk = 12; // segments

// The arrays that the beads' shader reads (bead_shader.h).
struct BeadArrays {
  std::vector<float> tangent, direction, shape, open;
};

Eigen::Vector3d tangentAt(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i) {
  const std::size_t last = path.first + path.count - 1;
  std::size_t before = i > path.first ? i - 1 : i, after = i < last ? i + 1 : i;
  if (path.closed && path.count > 2) {
    if (i == path.first)
      before = last - 1;
    if (i == last)
      after = path.first + 1;
  }
  const Eigen::Vector3d along = plan.position[after] - plan.position[before];
  return along.norm() > 0 ? Eigen::Vector3d(along.normalized()) : Eigen::Vector3d::UnitX();
}

void addThree(std::vector<float>& to, double x, double y, double z) {
  to.insert(to.end(), {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
}

// Adds the points on both sides of every waypoint's bead, in waypoint order.
void addPoints(const plan::ToolPlan& plan, MeshBuffers& buffers, BeadArrays& arrays) {
  std::vector<const plan::ToolPath*> pathAt(plan.waypointCount(), nullptr);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      pathAt[i] = &path;
  for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
    base::require(pathAt[i] != nullptr, "paths cover all waypoints");
    const plan::ToolPath& path = *pathAt[i];
    const Eigen::Vector3d tangent = tangentAt(plan, path, i), d = plan.direction[i];
    const double width = plan.widthMm[i], height = plan.heightMm[i];
    Eigen::Vector3d centre = plan.position[i] - 0.5 * height * d;
    // An open bead has a round end about half a width beyond its last waypoint.
    const bool first = i == path.first, last = i == path.first + path.count - 1;
    if (!path.closed && (first || last))
      centre += (first ? -0.35 : 0.35) * width * tangent;
    for (const double side : {-1.0, 1.0}) {
      buffers.addPoint(centre);
      addThree(arrays.tangent, tangent.x(), tangent.y(), tangent.z());
      addThree(arrays.direction, d.x(), d.y(), d.z());
      addThree(arrays.shape, kBeadFuller[0] * 0.5 * width, kBeadFuller[1] * 0.5 * height, side);
    }
  }
}

// Returns the paths by layer, in print order within each.
std::vector<std::size_t> pathsByLayer(const plan::ToolPlan& plan) {
  std::vector<std::size_t> order(plan.paths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return plan.paths[a].layer < plan.paths[b].layer;
  });
  return order;
}

std::vector<std::size_t> startsOf(const std::vector<std::size_t>& counts) {
  std::vector<std::size_t> starts{0};
  for (const std::size_t n : counts)
    starts.push_back(starts.back() + n);
  return starts;
}

// Computes the box around the waypoints [first, last] of a chunk.
void measure(const plan::ToolPlan& plan, std::size_t first, std::size_t last, BeadChunk& chunk) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = first; i <= last; ++i)
    box.extend(plan.position[i]);
  chunk.centre = box.center();
  chunk.half = 0.5 * box.sizes() + Eigen::Vector3d::Constant(double(plan.widthMm[first]));
}

void addSegments(const plan::ToolPlan& plan, PathsDrawing& drawing, MeshBuffers& buffers,
                 BeadArrays& arrays) {
  const FillOrder fill(plan);
  std::vector<std::uint32_t> surrounded(plan.waypointCount(), kNeverFilled);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      surrounded[i] = fill.surroundedAt(plan, i);
  const auto hidden = [&](std::size_t i) { return surrounded[i] != kNeverFilled; };

  const std::vector<std::size_t> order = pathsByLayer(plan);
  const std::size_t layers = drawing.waypointsOfLayer.size();
  std::vector<std::size_t> counts(layers, 0);
  for (const std::size_t p : order) {
    const plan::ToolPath& path = plan.paths[p];
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      if (!hidden(i)) {
        addBeadSegment(buffers, i - 1, i);
        drawing.arrival.push_back(static_cast<std::uint32_t>(i));
        ++counts[static_cast<std::size_t>(path.layer)];
      }
  }
  drawing.outerStart = startsOf(counts);

  // The side direction of the arriving segment, for both of the waypoint's points.
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      const std::size_t arrival = std::max(i, path.first + 1);
      const Eigen::Vector3d open =
          hidden(arrival) ? Eigen::Vector3d::Zero() : fill.openSide(plan, arrival);
      for (std::size_t k = 0; k < 2; ++k)
        for (int axis = 0; axis < 3; ++axis)
          arrays.open[3 * (2 * i + k) + static_cast<std::size_t>(axis)] =
              static_cast<float>(open[axis]);
    }

  std::vector<std::size_t> chunkCounts(layers, 0);
  for (const std::size_t p : order) {
    const plan::ToolPath& path = plan.paths[p];
    bool open = false;
    std::size_t chunkFirst = 0;
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      if (!hidden(i))
        continue;
      if (!open || drawing.chunks.back().count >= kChunk) {
        BeadChunk next;
        next.first = drawing.arrival.size();
        next.layer = path.layer;
        drawing.chunks.push_back(next);
        ++chunkCounts[static_cast<std::size_t>(path.layer)];
        open = true;
        chunkFirst = i - 1;
      }
      BeadChunk& chunk = drawing.chunks.back();
      measure(plan, chunkFirst, i, chunk);
      ++chunk.count;
      chunk.hidingWaypoint = std::max(chunk.hidingWaypoint, surrounded[i]);
      chunk.hidingLayer =
          std::max(chunk.hidingLayer, plan.paths[drawing.pathOf[surrounded[i]]].layer);
      addBeadSegment(buffers, i - 1, i);
      drawing.arrival.push_back(static_cast<std::uint32_t>(i));
    }
  }
  drawing.chunkStart = startsOf(chunkCounts);

  std::vector<BeadSight> sight(plan.waypointCount(), BeadSight::Buried);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      if (!hidden(i))
        sight[i] = fill.reachesOutside(plan, i) ? BeadSight::Open : BeadSight::Enclosed;
  addCoarseBeads(plan, order, sight, drawing, buffers);
}

void addTravels(const plan::ToolPlan& plan, PathsDrawing& drawing) {
  MeshBuffers buffers;
  std::vector<std::size_t> counts(drawing.waypointsOfLayer.size(), 0);
  for (const std::size_t p : pathsByLayer(plan)) {
    const std::size_t first = plan.paths[p].first;
    if (p == 0)
      continue;
    const plan::ToolPath& before = plan.paths[p - 1];
    buffers.addLine(plan.position[before.first + before.count - 1], plan.position[first]);
    drawing.travelArrival.push_back(static_cast<std::uint32_t>(first));
    ++counts[static_cast<std::size_t>(plan.paths[p].layer)];
  }
  drawing.travels = polyDataOf(buffers);
  drawing.travelStart = startsOf(counts);
}

void addInserts(const plan::ToolPlan& plan, PathsDrawing& drawing) {
  constexpr double kRimAngleDeg = 30.0; // round bodies consist of flat faces
  for (const plan::Insert& insert : plan.inserts) {
    drawing.box.extend(geometry::bounds(*insert.body));
    InsertDrawing drawn;
    drawn.surface = plainSurface(*insert.body);
    drawn.edges = featureEdges(drawn.surface, kRimAngleDeg, false);
    drawn.layer = insert.layer;
    drawn.first = plan.firstAfter(insert);
    drawing.inserts.push_back(std::move(drawn));
  }
}

void addValues(const plan::ToolPlan& plan, const plan::Trajectory* trajectory,
               PathsDrawing& drawing) {
  ColourValues& values = drawing.values;
  const std::size_t n = plan.waypointCount();
  values.layer.resize(n);
  values.group.resize(n);
  values.item.resize(n);
  values.tool.resize(n);
  values.kind.resize(n);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      values.layer[i] = path.layer;
      values.group[i] = path.group;
      values.item[i] = path.item;
      values.tool[i] = path.tool;
      values.kind[i] = static_cast<std::int32_t>(path.kind);
    }
  values.height = plan.heightMm;
  values.width = plan.widthMm;
  values.speed = plan.speedMmPerS;
  for (const Eigen::Vector3d& d : plan.direction)
    values.tiltDeg.push_back(
        static_cast<float>(base::radiansToDegrees(std::acos(std::clamp(d.z(), -1.0, 1.0)))));
  if (!trajectory)
    return;
  values.minutes.assign(n, 0.0f);
  const std::vector<double> times = plan::arrivalTimes(*trajectory);
  for (std::size_t i = 0; i < trajectory->pointCount(); ++i)
    if (const std::size_t w = trajectory->waypoint[i]; w < n)
      values.minutes[w] = static_cast<float>(times[i] / 60.0);
}

} // namespace

std::shared_ptr<const PathsDrawing> drawPaths(const plan::ToolPlan& plan,
                                              const plan::Trajectory* trajectory,
                                              std::vector<float> layerTimeS) {
  // A bead with none below has no time: it looks like the oldest.
  const float longest =
      layerTimeS.empty() ? 0.0F : std::max(0.0F, *std::ranges::max_element(layerTimeS));
  std::ranges::replace_if(
      layerTimeS, [](float time) { return time < 0.0F; }, longest);
  auto drawing = std::make_shared<PathsDrawing>();
  drawing->pathOf.resize(plan.waypointCount());
  for (std::size_t p = 0; p < plan.paths.size(); ++p) {
    const plan::ToolPath& path = plan.paths[p];
    base::require(path.layer >= 0, "layers count from 0");
    const auto layer = static_cast<std::size_t>(path.layer);
    drawing->layerOfPath.push_back(path.layer);
    if (drawing->waypointsOfLayer.size() <= layer)
      drawing->waypointsOfLayer.resize(layer + 1);
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      drawing->pathOf[i] = static_cast<std::uint32_t>(p);
      drawing->waypointsOfLayer[layer].push_back(static_cast<std::uint32_t>(i));
      drawing->box.extend(plan.position[i]);
    }
  }
  MeshBuffers buffers;
  BeadArrays arrays;
  addPoints(plan, buffers, arrays);
  arrays.open.resize(arrays.shape.size());
  addSegments(plan, *drawing, buffers, arrays);
  drawing->beads = polyDataOf(buffers);
  addPointArray(drawing->beads, "beadTangent", 3, arrays.tangent);
  addPointArray(drawing->beads, "beadDirection", 3, arrays.direction);
  addPointArray(drawing->beads, "beadShape", 3, arrays.shape);
  addPointArray(drawing->beads, "beadOpen", 3, arrays.open);
  addTravels(plan, *drawing);
  addInserts(plan, *drawing);
  drawing->values.layerTimeS = std::move(layerTimeS);
  addValues(plan, trajectory, *drawing);
  return drawing;
}

vtkSmartPointer<vtkPolyData> pathLine(const PathsDrawing& paths, std::size_t path) {
  MeshBuffers line;
  vtkDataArray* directions = paths.beads->GetPointData()->GetArray("beadDirection");
  const auto range = std::equal_range(paths.pathOf.begin(), paths.pathOf.end(), path);
  const auto first = range.first - paths.pathOf.begin(), end = range.second - paths.pathOf.begin();
  for (auto i = first; i < end; ++i) {
    double centre[3], direction[3];
    paths.beads->GetPoint(2 * i, centre);
    directions->GetTuple(2 * i, direction);
    const double over = kLineOverBead * double(paths.values.height[static_cast<std::size_t>(i)]);
    line.addPoint(Eigen::Vector3d(centre) + over * Eigen::Vector3d(direction));
    if (i > first)
      line.lineEnds.insert(line.lineEnds.end(), {static_cast<std::int32_t>(i - first - 1),
                                                 static_cast<std::int32_t>(i - first)});
  }
  return polyDataOf(line);
}

int layerCount(const PathsDrawing& drawing) {
  return static_cast<int>(drawing.waypointsOfLayer.size());
}

const std::vector<std::uint32_t>& waypointsOfLayer(const PathsDrawing& drawing, int layer) {
  static const std::vector<std::uint32_t> none;
  return layer >= 0 && layer < layerCount(drawing)
             ? drawing.waypointsOfLayer[static_cast<std::size_t>(layer)]
             : none;
}

} // namespace voluta::scene
