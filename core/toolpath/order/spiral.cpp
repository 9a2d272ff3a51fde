#include "toolpath/order/spiral.h"

#include "base/error.h"
#include "geometry/polyline.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_volume.h"
#include "toolpath/order/outer_loops.h"
#include "toolpath/unsupported/bead_tip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;
using plan::ToolPath;
using plan::ToolPlan;

// [layer heights]: where a turn begins or ends on another turn of the same height, its height is
// not less than this.
constexpr double kThinnest = 0.1;
// [bead widths]: a bead further away from the bead below does not continue it.
constexpr double kFar = 1.0;
// [bead widths]: how far the nearest place on the bead below may run ahead per point.
constexpr double kAhead = 4.0;

struct LoopPoint {
  Vector3d position, direction, clearDirection;
  double widthMm = 0.0, heightMm = 0.0, speedMmPerS = 0.0;
};

LoopPoint between(const LoopPoint& a, const LoopPoint& b, double share) {
  const auto mean = [&](const auto& x, const auto& y) { return (1.0 - share) * x + share * y; };
  return {mean(a.position, b.position),
          mean(a.direction, b.direction).normalized(),
          mean(a.clearDirection, b.clearDirection).normalized(),
          mean(a.widthMm, b.widthMm),
          mean(a.heightMm, b.heightMm),
          std::min(a.speedMmPerS, b.speedMmPerS)};
}

// A closed bead; the first point is repeated at the end.
class Loop {
public:
  explicit Loop(std::vector<LoopPoint> points) : points_(std::move(points)) {
    lengthMm_ =
        geometry::arcLengths(points_.size(), [&](std::size_t i) { return points_[i].position; });
  }

  const std::vector<LoopPoint>& points() const { return points_; }
  double lengthMm() const { return lengthMm_.back(); }
  double shareAt(std::size_t i) const { return lengthMm_[i] / lengthMm(); }

  struct Place {
    std::size_t segment = 0;
    double share = 0.0; // of the segment
    double alongMm = 0.0, distanceMm = std::numeric_limits<double>::infinity();
  };

  // Returns the nearest place between two lengths from the start.
  Place nearest(const Vector3d& to, double fromMm = 0.0,
                double untilMm = std::numeric_limits<double>::infinity()) const {
    Place best;
    const auto after = std::ranges::upper_bound(lengthMm_, fromMm);
    for (std::size_t i = static_cast<std::size_t>(
             std::max<std::ptrdiff_t>(1, std::min(after, lengthMm_.end() - 1) - lengthMm_.begin()));
         i < points_.size() && lengthMm_[i - 1] <= untilMm; ++i) {
      const Vector3d a = points_[i - 1].position, along = points_[i].position - a;
      const double length = lengthMm_[i] - lengthMm_[i - 1];
      if (!(length > 0.0))
        continue;
      const double minimum = std::clamp((fromMm - lengthMm_[i - 1]) / length, 0.0, 1.0),
                   maximum = std::clamp((untilMm - lengthMm_[i - 1]) / length, minimum, 1.0);
      const double share = std::clamp((to - a).dot(along) / along.squaredNorm(), minimum, maximum);
      if (const double d = (a + share * along - to).norm(); d < best.distanceMm)
        best = {i - 1, share, lengthMm_[i - 1] + share * length, d};
    }
    return best;
  }

  LoopPoint at(const Place& place) const {
    return between(points_[place.segment], points_[place.segment + 1], place.share);
  }
  Vector3d tangent(const Place& place) const {
    return (points_[place.segment + 1].position - points_[place.segment].position).normalized();
  }

  // Returns the same bead, begun at the place, and backwards on request.
  Loop begunAt(const Place& place, bool backwards) const {
    std::vector<LoopPoint> points{at(place)};
    const std::size_t n = points_.size() - 1;
    for (std::size_t k = 1; k <= n; ++k)
      points.push_back(points_[(place.segment + k) % n]);
    points.push_back(points.front());
    constexpr double kSameMm = 1e-3;
    const auto same = [&](const LoopPoint& a, const LoopPoint& b) {
      return (a.position - b.position).norm() < kSameMm;
    };
    if (same(points[1], points[0]))
      points.erase(points.begin() + 1);
    if (same(points[points.size() - 2], points.back()))
      points.erase(points.end() - 2);
    if (backwards)
      std::ranges::reverse(points);
    return Loop(std::move(points));
  }

private:
  std::vector<LoopPoint> points_;
  std::vector<double> lengthMm_; // from the start, per point
};

Loop loopOf(const Assembled& assembled, const ToolPath& path) {
  const ToolPlan& plan = assembled.plan;
  std::vector<LoopPoint> points;
  for (std::size_t i = path.first; i < path.first + path.count; ++i)
    points.push_back({plan.position[i], plan.direction[i], assembled.clearDirection[i],
                      plan.widthMm[i], plan.heightMm[i], plan.speedMmPerS[i]});
  return Loop(std::move(points));
}

// Returns the loop begun beside the start of the loop below, in the same direction; nullopt if it
// does not continue it.
std::optional<Loop> continued(const Loop& below, const Loop& loop) {
  double same = 0.0;
  for (std::size_t i = 0; i + 1 < loop.points().size(); ++i) {
    const LoopPoint& p = loop.points()[i];
    const Loop::Place place = below.nearest(p.position);
    if (place.distanceMm > kFar * p.widthMm + p.heightMm)
      return std::nullopt;
    const Vector3d along = loop.points()[i + 1].position - p.position;
    same += along.dot(below.tangent(place));
  }
  return loop.begunAt(loop.nearest(below.points().front().position), same < 0.0);
}

// Appends the turn that rises from one loop to the next.
void appendRevolution(const Loop& below, const Loop& loop, bool isFirst,
                      std::vector<LoopPoint>& spiral) {
  double alongMm = 0.0;
  const std::size_t last = loop.points().size() - 1;
  for (std::size_t i = 1; i <= last; ++i) {
    const LoopPoint& p = loop.points()[i];
    const double share = loop.shareAt(i);
    const Loop::Place place = below.nearest(p.position, alongMm, alongMm + kAhead * p.widthMm);
    alongMm = place.alongMm;
    LoopPoint q = i == last ? p : between(below.at(place), p, share);
    if (isFirst)
      q.heightMm = std::max(share, kThinnest) * p.heightMm;
    spiral.push_back(q);
  }
}

// Appends the level turn above the last one.
void appendEnd(const Loop& loop, std::vector<LoopPoint>& spiral) {
  for (std::size_t i = 1; i < loop.points().size(); ++i) {
    const double height = 1.0 - loop.shareAt(i);
    LoopPoint q = loop.points()[i];
    q.heightMm *= std::max(height, kThinnest);
    spiral.push_back(q);
    if (height <= kThinnest)
      return;
  }
}

std::vector<LoopPoint> spiralOf(const std::vector<Loop>& loops) {
  std::vector<LoopPoint> spiral = loops.front().points();
  for (std::size_t k = 1; k < loops.size(); ++k)
    appendRevolution(loops[k - 1], loops[k], k == 1, spiral);
  appendEnd(loops.back(), spiral);
  return spiral;
}

// Paths [first, end) of one layer.
struct LayerPaths {
  std::size_t first = 0, end = 0;
  std::size_t count() const { return end - first; }
};

std::vector<LayerPaths> layersOf(const std::vector<ToolPath>& paths) {
  std::vector<LayerPaths> layers;
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const bool begins =
        p == 0 || paths[p].layer != paths[p - 1].layer || paths[p].item != paths[p - 1].item;
    if (begins)
      layers.push_back({p, p + 1});
    else
      layers.back().end = p + 1;
  }
  return layers;
}

bool isLoop(const std::vector<ToolPath>& paths, const LayerPaths& layer) {
  const ToolPath& path = paths[layer.first];
  constexpr std::size_t kFewest = 4; // A triangle
  // The centreline of a ring of one bead is a gap fill; infill may be one closed bead too.
  const bool isWall =
      (path.kind == PathKind::Wall && path.ring == 0) || path.kind == PathKind::GapFill;
  return layer.count() == 1 && path.closed && path.count >= kFewest && isWall;
}

// `layer`: the first that the spiral does not contain; `isApart`: it is one loop.
plan::Finding spiralEnds(const ToolPlan& plan, const LayerPaths& layer, int layers, bool isApart) {
  const plan::NamedValue at{"layer", plan.paths[layer.first].layer + 1}, of{"layers", layers};
  const Vector3d& where = plan.position[plan.paths[layer.first].first];
  return isApart ? plan::makeFinding(plan::FindingKind::SpiralInterrupted, {at, of}, where)
                 : plan::makeFinding(plan::FindingKind::SpiralEnds,
                                     {{"beads", layer.count()}, at, of}, where);
}

// Layers [first, end) of one closed bead each, begun beside each other and in one direction.
struct LoopRun {
  std::size_t first = 0, end = 0;
  std::vector<Loop> loops;
};

// Returns the first run from layer `from` on; without loops at the end.
LoopRun loopRunFrom(std::size_t from, const Assembled& assembled,
                    const std::vector<LayerPaths>& layers) {
  const std::vector<ToolPath>& paths = assembled.plan.paths;
  LoopRun run;
  run.first = from;
  while (run.first < layers.size() && !isLoop(paths, layers[run.first]))
    ++run.first;
  for (run.end = run.first; run.end < layers.size() && isLoop(paths, layers[run.end]); ++run.end) {
    const ToolPath &path = paths[layers[run.end].first], &begin = paths[layers[run.first].first];
    Loop loop = loopOf(assembled, path);
    if (run.loops.empty()) {
      run.loops.push_back(std::move(loop));
      continue;
    }
    if (path.item != begin.item || path.tool != begin.tool)
      break;
    std::optional<Loop> next = continued(run.loops.back(), loop);
    if (!next)
      break;
    run.loops.push_back(std::move(*next));
  }
  return run;
}

class Rebuilt {
public:
  explicit Rebuilt(const Assembled& from) : from_(from) {
    out_.plan.fill = from.plan.fill;
    out_.travelMm = from.travelMm;
  }

  void copy(std::size_t firstPath, std::size_t endPath) {
    for (std::size_t p = firstPath; p < endPath; ++p)
      add(from_.plan.paths[p], loopOf(from_, from_.plan.paths[p]).points());
  }

  void add(ToolPath path, std::span<const LoopPoint> points) {
    path.first = out_.plan.waypointCount();
    path.count = points.size();
    for (const LoopPoint& p : points) {
      out_.plan.position.push_back(p.position);
      out_.plan.direction.push_back(p.direction);
      out_.plan.widthMm.push_back(static_cast<float>(p.widthMm));
      out_.plan.heightMm.push_back(static_cast<float>(p.heightMm));
      out_.plan.speedMmPerS.push_back(static_cast<float>(p.speedMmPerS));
      out_.clearDirection.push_back(p.clearDirection);
    }
    out_.plan.paths.push_back(path);
  }

  Assembled take() { return std::move(out_); }

private:
  const Assembled& from_;
  Assembled out_;
};
} // namespace

ToolpathOptions spiralOptions(ToolpathOptions options) {
  options.walls = 1;
  options.infillDensity = 1.0;
  options.rimSupports = false;
  return options;
}

namespace {
// Leaves one wall in a layer where its walls can be joined, or where only the largest is asked for.
// `patches`: those of the layer with outer walls alone.
void joinWalls(const layers::LayerStack& stack, const std::vector<std::size_t>& patches,
               bool outerAlone, std::vector<PatchCover>& covers) {
  std::vector<OuterLoop> loops;
  for (const std::size_t i : patches) {
    for (Bead& bead : covers[i].beads)
      loops.push_back({std::move(bead), i});
    covers[i].beads.clear();
  }
  if (outerAlone)
    loops = {std::move(loops[largestLoop(loops)])};
  else
    loops = joinedWhereTouching(std::move(loops), stack.patches);
  for (OuterLoop& loop : loops)
    covers[loop.patch].beads.push_back(std::move(loop.bead));
}
} // namespace

std::vector<plan::FillIntent> keepOuterWalls(const layers::LayerStack& stack, int bottomLayers,
                                             bool outerAlone, std::vector<PatchCover>& covers) {
  base::require(covers.size() == stack.patches.size(), "one cover a patch");
  const auto isOuterWall = [](const Bead& bead) {
    return bead.kind == PathKind::Wall && bead.ring == 0 && bead.closed;
  };
  std::map<std::pair<int, int>, std::vector<std::size_t>> layers; // by item and layer
  for (std::size_t i = 0; i < covers.size(); ++i) {
    std::vector<Bead>& beads = covers[i].beads;
    if (stack.patches[i].layer < bottomLayers || stack.patches[i].group == layers::kSupportGroup ||
        std::ranges::none_of(beads, isOuterWall))
      continue;
    std::erase_if(beads, [&](const Bead& bead) { return !isOuterWall(bead); });
    layers[{stack.patches[i].item, stack.patches[i].layer}].push_back(i);
  }
  double openMm3 = 0.0;
  for (const auto& [layer, patches] : layers) {
    std::size_t walls = 0;
    for (const std::size_t i : patches)
      walls += covers[i].beads.size();
    if (walls > 1)
      joinWalls(stack, patches, outerAlone, covers);
    for (const std::size_t i : patches) {
      const double left = volumeOf(covers[i].beads);
      openMm3 += covers[i].beadVolumeMm3 - left;
      covers[i].beadVolumeMm3 = left;
    }
  }
  constexpr double kRoundingMm3 = 1e-6;
  openMm3 = openMm3 > kRoundingMm3 ? openMm3 : 0.0;
  return openMm3 > 0.0 ? std::vector<plan::FillIntent>{{0.0, openMm3}}
                       : std::vector<plan::FillIntent>{};
}

std::optional<plan::Finding> joinSpiral(Assembled& assembled, int bottomLayers) {
  const std::vector<ToolPath>& paths = assembled.plan.paths;
  const std::vector<LayerPaths> layers = layersOf(paths);
  Rebuilt rebuilt(assembled);
  std::size_t copied = 0; // layers
  std::optional<std::size_t> left;
  const auto copyUntil = [&](std::size_t end) {
    for (; copied < end; ++copied) {
      rebuilt.copy(layers[copied].first, layers[copied].end);
      if (!left && paths[layers[copied].first].layer >= bottomLayers)
        left = copied;
    }
  };
  while (copied < layers.size()) {
    const LoopRun run = loopRunFrom(copied, assembled, layers);
    copyUntil(run.first);
    if (run.loops.size() < 2) {
      copyUntil(run.end);
      continue;
    }
    ToolPath path = paths[layers[run.first].first];
    // Settings of the first layer hold for the first layer only.
    path.patch = paths[layers[run.first + 1].first].patch;
    path.kind = PathKind::Wall;
    path.ring = 0;
    path.closed = false;
    rebuilt.add(path, spiralOf(run.loops));
    copied = run.end;
    if (!left && run.end < layers.size())
      left = run.end;
  }
  std::optional<plan::Finding> finding;
  if (left)
    finding = spiralEnds(assembled.plan, layers[*left], static_cast<int>(layers.size()),
                         isLoop(paths, layers[*left]));
  assembled = rebuilt.take();
  return finding;
}

} // namespace voluta::toolpath
