#include "toolpath/unsupported/bridge_direction.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/boundary.h"
#include "process/bead_model.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;

constexpr double kStepDeg = 5.0;
constexpr double kLevel = 0.999; // cosine of a direction that counts as upright
// A held span costs this share of one that nothing holds: shorter ones are better.
constexpr double kHeldCost = 0.1;
// Another direction is taken only if it saves this share of the cost.
constexpr double kWorthwhile = 0.1;
// [thicknesses] between two layers that follow each other
constexpr double kNearest = 0.3, kGap = 1.7;

struct Edge {
  Vector2d from, to;
};

std::vector<Edge> outlineOf(const layers::Patch& patch) {
  std::vector<Edge> edges;
  const auto at = [&](int v) -> Vector2d {
    return patch.surface.vertices[static_cast<std::size_t>(v)].head<2>();
  };
  for (const std::vector<int>& loop : geometry::boundaryLoops(patch.surface))
    for (std::size_t i = 0; i < loop.size(); ++i)
      edges.push_back({at(loop[i]), at(loop[(i + 1) % loop.size()])});
  return edges;
}

using Interval = std::pair<double, double>;

// Where parallel lines cross outlines.
class Scan {
public:
  Scan(double angleRad, double from, double spacing, std::size_t count)
      : along_(std::cos(angleRad), std::sin(angleRad)), across_(-along_.y(), along_.x()),
        from_(from), spacing_(spacing), count_(count) {}

  // Returns the stretches of each line inside an outline, ascending.
  std::vector<std::vector<Interval>> inside(const std::vector<Edge>& outline) const {
    std::vector<std::vector<double>> crossings(count_);
    for (const Edge& edge : outline) {
      const double a = (across_.dot(edge.from) - from_) / spacing_,
                   b = (across_.dot(edge.to) - from_) / spacing_;
      const double low = std::ceil(std::max(0.0, std::min(a, b))),
                   high = std::min(std::max(a, b), static_cast<double>(count_));
      for (double line = low; line < high; line += 1.0)
        crossings[static_cast<std::size_t>(line)].push_back(
            along_.dot(edge.from + (line - a) / (b - a) * (edge.to - edge.from)));
    }
    std::vector<std::vector<Interval>> stretches(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      std::ranges::sort(crossings[i]);
      for (std::size_t k = 0; k + 1 < crossings[i].size(); k += 2)
        stretches[i].emplace_back(crossings[i][k], crossings[i][k + 1]);
    }
    return stretches;
  }

private:
  Vector2d along_, across_;
  double from_, spacing_;
  std::size_t count_;
};

// Returns the union of the stretches of one line.
std::vector<Interval> merged(std::vector<Interval> stretches) {
  std::ranges::sort(stretches);
  std::vector<Interval> all;
  for (const Interval& one : stretches)
    if (all.empty() || one.first > all.back().second)
      all.push_back(one);
    else
      all.back().second = std::max(all.back().second, one.second);
  return all;
}

class Gaps {
public:
  Gaps(const std::vector<Edge>& patch, std::vector<const std::vector<Edge>*> below,
       const process::Process& process, double insetMm)
      : patch_(patch), below_(std::move(below)), process_(process), insetMm_(insetMm),
        spacing_(process::hatchOf(process.beadWidthMm, process.layerHeightMm)) {}

  // Returns the length of lines that nothing holds [mm], with a share of the held spans.
  double cost(double angleRad) const {
    const Vector2d across(-std::sin(angleRad), std::cos(angleRad));
    double low = INFINITY, high = -INFINITY;
    for (const Edge& edge : patch_) {
      low = std::min(low, across.dot(edge.from));
      high = std::max(high, across.dot(edge.from));
    }
    const auto count = static_cast<std::size_t>(std::max(0.0, (high - low) / spacing_));
    const Scan scan(angleRad, low + 0.5 * spacing_, spacing_, count);
    const auto inside = scan.inside(patch_);
    std::vector<std::vector<Interval>> held(count);
    for (const std::vector<Edge>* outline : below_) {
      const auto more = scan.inside(*outline);
      for (std::size_t i = 0; i < count; ++i)
        held[i].insert(held[i].end(), more[i].begin(), more[i].end());
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<Interval> holds = merged(std::move(held[i]));
      for (const auto& [from, to] : inside[i])
        sum += costOf(from + insetMm_, to - insetMm_, holds);
    }
    return sum;
  }

private:
  // Of a line between two places.
  double costOf(double from, double to, const std::vector<Interval>& holds) const {
    double sum = 0.0, end = from;
    bool isHeld = false; // at `end`
    for (const auto& [low, high] : holds) {
      if (high <= from || low >= to)
        continue;
      if (low > end)
        sum += costOf(low - end, isHeld);
      end = std::max(end, high);
      isHeld = true;
    }
    return end < to ? sum + costOf(to - end, false) : sum;
  }
  double costOf(double lengthMm, bool isHeld) const {
    if (lengthMm < process_.beadWidthMm)
      return 0.0;
    return isHeld && lengthMm <= process::saggingBridgeMm(process_) ? kHeldCost * lengthMm
                                                                    : lengthMm;
  }

  const std::vector<Edge>& patch_;
  const std::vector<const std::vector<Edge>*> below_;
  const process::Process& process_;
  double insetMm_, spacing_;
};

std::optional<double> directionOver(const Gaps& gaps, const process::Process& process,
                                    double usualRad) {
  const double usual = gaps.cost(usualRad);
  if (usual < process.beadWidthMm)
    return std::nullopt;
  double best = (1.0 - kWorthwhile) * usual;
  std::optional<double> direction;
  for (double degrees = 0.0; degrees < 180.0; degrees += kStepDeg) {
    const double radians = base::degreesToRadians(degrees);
    if (const double cost = gaps.cost(radians); cost < best) {
      best = cost;
      direction = radians;
    }
  }
  return direction;
}

// A patch of a plane layer that is parallel to the plate.
struct Level {
  double z = 0.0, thicknessMm = 0.0;
  std::vector<Edge> outline;
};

std::optional<Level> levelOf(const layers::Patch& patch) {
  if (patch.surface.vertices.empty())
    return std::nullopt;
  constexpr double kSameMm = 1e-6;
  const double z = patch.surface.vertices.front().z();
  for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v)
    if (std::abs(patch.surface.vertices[v].z() - z) > kSameMm || patch.direction[v].z() < kLevel)
      return std::nullopt;
  return Level{z, patch.thicknessMm.front(), outlineOf(patch)};
}

std::vector<std::optional<Level>> levelsOf(const layers::LayerStack& stack,
                                           const base::RunContext& ctx) {
  std::vector<std::optional<Level>> levels(stack.patches.size());
  base::parallelChunks(ctx, levels.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      levels[i] = levelOf(stack.patches[i]);
  });
  return levels;
}

} // namespace

std::vector<std::optional<double>>
bridgeDirections(const layers::LayerStack& stack, const layers::LayerStack& whole,
                 const std::function<process::Process(std::size_t)>& processOf,
                 const UsualLines& usual, const base::RunContext& ctx) {
  const std::vector<std::optional<Level>> own = levelsOf(stack, ctx), all = levelsOf(whole, ctx);
  std::vector<std::size_t> byHeight;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i])
      byHeight.push_back(i);
  std::ranges::sort(byHeight, {}, [&](std::size_t i) { return all[i]->z; });
  std::vector<std::optional<double>> directions(stack.patches.size());
  base::parallelChunks(ctx, directions.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!own[i])
        continue;
      const Level& level = *own[i];
      std::vector<const std::vector<Edge>*> below;
      auto at = std::ranges::lower_bound(byHeight, level.z - kGap * level.thicknessMm, {},
                                         [&](std::size_t k) { return all[k]->z; });
      for (; at != byHeight.end() && all[*at]->z < level.z - kNearest * level.thicknessMm; ++at)
        below.push_back(&all[*at]->outline);
      if (below.empty())
        continue; // on the ground, or in the air altogether
      const process::Process process = processOf(i);
      const double inset =
          usual.walls * process::hatchOf(process.beadWidthMm, process.layerHeightMm);
      const double degrees = usual.angleDeg + stack.patches[i].layer * usual.rotationDeg;
      directions[i] = directionOver(Gaps(level.outline, std::move(below), process, inset), process,
                                    base::degreesToRadians(std::remainder(degrees, 180.0)));
    }
  });
  return directions;
}

} // namespace voluta::toolpath
