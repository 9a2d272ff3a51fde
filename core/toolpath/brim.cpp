#include "toolpath/brim.h"

#include "base/index.h"
#include "geometry/boundary.h"
#include "geometry/polygon_paths.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "toolpath/first_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::toolpath {

using ClipperLib::Path;
using ClipperLib::Paths;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {
using base::at;

constexpr double kArcMm = 0.01;   // Chord error of round corners
constexpr double kCrackMm = 0.05; // Narrower cracks between polygons are closed
// [brim heights]: material with its underside below this would be inside the brim's beads
constexpr double kLow = 0.75;
// [bead widths]: half the width of the narrowest islands; narrower ones get no bead
constexpr double kNarrowest = 0.25;
constexpr double kShortestLoop = 3.0; // [bead widths]: shorter pieces do not stick
// [hatches]: least distance of loops in a hole from its wall, so that they do not stick to it
constexpr double kFromHoleWall = 1.5;

Path pathOf(const Polygon2d& polygon) {
  Path path;
  for (const Vector2d& p : polygon)
    path.push_back(geometry::pathPoint(p));
  return path;
}

Paths grown(const Paths& paths, double byMm, ClipperLib::JoinType corners = ClipperLib::jtRound,
            ClipperLib::EndType ends = ClipperLib::etClosedPolygon) {
  return geometry::offsetPaths(paths, byMm, {kArcMm, corners, ends});
}

double lengthOf(const Path& path, bool closed) {
  double length = 0.0;
  for (std::size_t i = closed ? 0 : 1; i < path.size(); ++i)
    length +=
        (geometry::pointMm(path[i]) - geometry::pointMm(path[i > 0 ? i - 1 : path.size() - 1]))
            .norm();
  return length;
}

// Joins pieces of one closed contour that meet where the contour begins.
void joinAtBegin(Paths& pieces, const ClipperLib::IntPoint& begin) {
  const auto starts =
      std::ranges::find_if(pieces, [&](const Path& p) { return p.front() == begin; });
  const auto ends = std::ranges::find_if(pieces, [&](const Path& p) { return p.back() == begin; });
  if (starts == pieces.end() || ends == pieces.end() || starts == ends)
    return;
  ends->insert(ends->end(), starts->begin() + 1, starts->end());
  pieces.erase(starts);
}

// Returns the pieces of a closed contour inside an area; one closed path if all of it is.
std::vector<std::pair<Path, bool>> piecesInside(const Path& contour, const Paths& area) {
  Path line = contour;
  line.push_back(contour.front());
  ClipperLib::Clipper clipper;
  clipper.AddPath(line, ClipperLib::ptSubject, false);
  clipper.AddPaths(area, ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctIntersection, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  Paths pieces;
  ClipperLib::OpenPathsFromPolyTree(tree, pieces);
  double left = 0.0;
  for (const Path& piece : pieces)
    left += lengthOf(piece, false);
  constexpr double kSameMm = 1e-2;
  if (left > lengthOf(contour, true) - kSameMm)
    return {{contour, true}};
  joinAtBegin(pieces, contour.front());
  std::vector<std::pair<Path, bool>> out;
  for (Path& piece : pieces)
    out.emplace_back(std::move(piece), false);
  return out;
}

// Outlines with a common surrounding: those on the plate, or those in one hole.
struct Islands {
  Paths outlines;
  Paths hole; // Empty: on the plate
};

bool meet(const Path& outline, const Paths& paths) {
  return !geometry::combined({outline}, paths, ClipperLib::ctIntersection).empty();
}

// `part`: the material without supports.
std::vector<Islands> islandsOf(const Paths& material, const Paths& part, double beadWidthMm) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(material, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<Islands> out;
  const auto add = [&](const ClipperLib::PolyNode& around, Paths hole) {
    Islands islands{{}, std::move(hole)};
    for (const ClipperLib::PolyNode* outline : around.Childs)
      if (!grown({outline->Contour}, -kNarrowest * beadWidthMm).empty() &&
          (islands.hole.empty() || meet(outline->Contour, part)))
        islands.outlines.push_back(outline->Contour);
    if (!islands.outlines.empty())
      out.push_back(std::move(islands));
  };
  add(tree, {});
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext())
    if (node->IsHole()) {
      Path wall = node->Contour;
      ClipperLib::ReversePath(wall);
      add(*node, {wall});
    }
  return out;
}

// Moves the loop whose start is nearest to `here` to the front, starting there.
void takeNearest(std::vector<BrimLoop>::iterator first, std::vector<BrimLoop>::iterator end,
                 const Vector2d& here) {
  auto best = first;
  std::size_t start = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (auto loop = first; loop != end; ++loop)
    for (std::size_t i = 0; i < loop->points.size(); ++i) {
      if (!loop->closed && i > 0 && i + 1 < loop->points.size())
        continue;
      if (const double d = (loop->points[i] - here).norm(); d < minimum) {
        minimum = d;
        best = loop;
        start = i;
      }
    }
  if (best->closed)
    std::ranges::rotate(best->points, best->points.begin() + static_cast<std::ptrdiff_t>(start));
  else if (start > 0)
    std::ranges::reverse(best->points);
  std::iter_swap(first, best);
}

void orderNearest(std::vector<BrimLoop>& loops, std::size_t first) {
  for (std::size_t k = std::max<std::size_t>(first, 1); k < loops.size(); ++k) {
    const BrimLoop& last = loops[k - 1];
    takeNearest(loops.begin() + static_cast<std::ptrdiff_t>(k), loops.end(),
                last.closed ? last.points.front() : last.points.back());
  }
}

// Returns the outlines of a patch where its underside is below this height.
std::vector<Polygon2d> outlinesOf(const layers::Patch& patch, double belowMm) {
  geometry::TriangleMesh low;
  low.vertices = patch.surface.vertices;
  const auto isLow = [&](int v) { return undersideOf(patch, at(v)) < belowMm; };
  for (const auto& t : patch.surface.triangles)
    if (std::ranges::any_of(t, isLow))
      low.triangles.push_back(t);
  std::vector<Polygon2d> outlines;
  for (const std::vector<int>& loop : geometry::boundaryLoops(low)) {
    Polygon2d outline;
    for (std::size_t i = loop.size(); i-- > 0;)
      outline.emplace_back(low.vertices[at(loop[i])].head<2>());
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

// Returns the outlines of a bead where its underside is below this height.
std::vector<Polygon2d> outlinesOf(const plan::ToolPlan& plan, const plan::ToolPath& path,
                                  double belowMm) {
  std::vector<Polygon2d> outlines;
  Path line;
  double width = 0.0;
  const auto finish = [&] {
    if (!line.empty())
      for (const Path& outline :
           grown({line}, 0.5 * width, ClipperLib::jtRound, ClipperLib::etOpenRound)) {
        outlines.emplace_back();
        for (const ClipperLib::IntPoint& p : outline)
          outlines.back().push_back(geometry::pointMm(p));
      }
    line.clear();
    width = 0.0;
  };
  for (std::size_t i = path.first; i < path.first + path.count; ++i) {
    if (plan.position[i].z() - static_cast<double>(plan.heightMm[i]) >= belowMm) {
      finish();
      continue;
    }
    line.push_back(geometry::pathPoint(Vector2d(plan.position[i].head<2>())));
    width = std::max(width, static_cast<double>(plan.widthMm[i]));
  }
  finish();
  return outlines;
}

// Returns the height of the first layer [mm]: the median at the vertices on the plate.
double firstHeight(const layers::LayerStack& stack, const process::Process& process) {
  std::vector<double> heights;
  for (const layers::Patch& patch : stack.patches)
    for (std::size_t v = 0; v < patch.thicknessMm.size(); ++v)
      if (touchesPlate(patch, v))
        heights.push_back(patch.thicknessMm[v]);
  if (heights.empty())
    return process.layerHeightMm;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::ranges::nth_element(heights, middle);
  return std::clamp(*middle, process.layerHeightMinMm, process.layerHeightMaxMm);
}

// Appends a loop to a plan, with waypoints at most a step apart.
void append(plan::ToolPlan& to, BrimLoop loop, double stepMm, double widthMm, double heightMm,
            double speedMmPerS) {
  plan::ToolPath path;
  path.first = to.waypointCount();
  path.kind = plan::PathKind::Skirt;
  path.closed = loop.closed;
  if (loop.closed)
    loop.points.push_back(loop.points.front());
  for (std::size_t c = 0; c + 1 < loop.points.size(); ++c) {
    const Vector2d step = loop.points[c + 1] - loop.points[c];
    const int n = std::max(1, static_cast<int>(std::ceil(step.norm() / stepMm - 1e-9)));
    for (int i = c == 0 ? 0 : 1; i <= n; ++i) {
      // Exact corners, so that a closed path ends where it begins.
      const Vector2d at = i == n ? loop.points[c + 1] : Vector2d(loop.points[c] + step * i / n);
      to.position.emplace_back(at.x(), at.y(), heightMm);
    }
  }
  path.count = to.waypointCount() - path.first;
  to.direction.resize(to.waypointCount(), Vector3d::UnitZ());
  to.widthMm.resize(to.waypointCount(), static_cast<float>(widthMm));
  to.heightMm.resize(to.waypointCount(), static_cast<float>(heightMm));
  to.speedMmPerS.resize(to.waypointCount(), static_cast<float>(speedMmPerS));
  to.paths.push_back(path);
}

// Puts the paths of a plan before those of another, as paths of its first patch.
void prepend(plan::ToolPlan& plan, const plan::ToolPlan& front) {
  const auto insert = [](auto& list, const auto& before) {
    list.insert(list.begin(), before.begin(), before.end());
  };
  plan::ToolPath owner = plan.paths.front();
  for (plan::ToolPath& path : plan.paths)
    path.first += front.waypointCount();
  std::vector<plan::ToolPath> paths = front.paths;
  for (plan::ToolPath& path : paths) {
    path.layer = owner.layer;
    path.patch = owner.patch;
    path.group = owner.group;
    path.item = owner.item;
  }
  insert(plan.paths, paths);
  insert(plan.position, front.position);
  insert(plan.direction, front.direction);
  insert(plan.widthMm, front.widthMm);
  insert(plan.heightMm, front.heightMm);
  insert(plan.speedMmPerS, front.speedMmPerS);
}

} // namespace

Brim brimAround(const std::vector<Polygon2d>& polygons, const Polygon2d& plate, double brimWidthMm,
                const BrimBead& bead, const std::vector<Polygon2d>& supports) {
  Paths part;
  for (const Polygon2d& polygon : polygons)
    part.push_back(pathOf(polygon));
  Paths material = part;
  for (const Polygon2d& support : supports)
    material.push_back(pathOf(support));
  material = grown(grown(geometry::united(material), kCrackMm, ClipperLib::jtMiter), -kCrackMm,
                   ClipperLib::jtMiter);
  const Paths onPlate = grown({pathOf(plate)}, -0.5 * bead.widthMm);
  const std::vector<Islands> all = islandsOf(material, part, bead.widthMm);
  const int count = std::max(1, static_cast<int>(std::lround(brimWidthMm / bead.hatchMm)));
  Brim brim;
  for (int k = count - 1; k >= 0; --k) {
    const std::size_t first = brim.loops.size();
    for (const Islands& islands : all) {
      const bool inHole = !islands.hole.empty();
      const Paths room = inHole ? grown(islands.hole, -kFromHoleWall * bead.hatchMm) : onPlate;
      for (const Path& contour : grown(islands.outlines, (k + 0.5) * bead.hatchMm)) {
        if (!ClipperLib::Orientation(contour))
          continue; // Around a pocket between islands
        double left = 0.0;
        for (const auto& [piece, closed] : piecesInside(contour, room)) {
          const double length = lengthOf(piece, closed);
          if (length < kShortestLoop * bead.widthMm)
            continue;
          left += length;
          BrimLoop loop{{}, closed};
          for (const ClipperLib::IntPoint& p : piece)
            loop.points.push_back(geometry::pointMm(p));
          brim.loops.push_back(std::move(loop));
        }
        brim.lengthMm += left;
        if (const double cut = lengthOf(contour, true) - left; !inHole && cut > bead.widthMm) {
          brim.cutMm += cut;
          for (const ClipperLib::IntPoint& p : contour)
            if (!brim.cutAt &&
                !ClipperLib::PointInPolygon(p, onPlate.empty() ? Path() : onPlate[0]))
              brim.cutAt = geometry::pointMm(p);
        }
      }
    }
    orderNearest(brim.loops, first);
  }
  return brim;
}

std::optional<plan::Finding> addBrim(plan::ToolPlan& plan, const layers::LayerStack& stack,
                                     const process::Tooling& tooling,
                                     const ToolpathOptions& options) {
  const platform::PlatformSolid& platform = options.platform;
  if (!(options.brimWidthMm > 0.0) || plan.paths.empty() || platform.polygon.size() < 3 ||
      platform.mesh || platform.rod)
    return std::nullopt;
  const int tool = plan.paths.front().tool; // that prints first
  const process::Process& process = tooling.at(tool).process;
  const double first = process.features.of(process::Feature::FirstLayer).widthMm;
  const double width = first > 0.0 ? first : process.beadWidthMm;
  const double height = std::min(firstHeight(stack, process), width);
  std::vector<Polygon2d> outlines, supports;
  for (const layers::Patch& patch : stack.patches)
    std::ranges::move(
        outlinesOf(patch, kLow * height),
        std::back_inserter(patch.group == layers::kSupportGroup ? supports : outlines));
  for (const plan::ToolPath& path : plan.paths)
    if (path.kind == plan::PathKind::Support)
      std::ranges::move(outlinesOf(plan, path, kLow * height), std::back_inserter(supports));
  const Brim brim = brimAround(outlines, platform.polygon, options.brimWidthMm,
                               {process::hatchOf(width, height), width}, supports);
  plan::ToolPlan front;
  const double speed =
      std::min(process.speedMmPerS, process::flowLimit(process) / process::beadArea(width, height));
  for (const BrimLoop& loop : brim.loops)
    append(front, loop, options.stepMm, width, height, speed);
  for (plan::ToolPath& path : front.paths)
    path.tool = tool;
  if (!front.paths.empty())
    prepend(plan, front);
  if (!brim.cutAt)
    return std::nullopt;
  return plan::makeFinding(
      plan::FindingKind::BrimCut,
      {{"share", base::percent(100.0 * brim.cutMm / (brim.cutMm + brim.lengthMm))},
       {"width", base::mm(options.brimWidthMm)}},
      Vector3d(brim.cutAt->x(), brim.cutAt->y(), 0.0));
}

} // namespace voluta::toolpath
