#include "toolpath/unsupported/bridge_direction.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/boundary.h"
#include "process/bead_model.h"
#include "toolpath/plane/scan_lines.h"

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

std::vector<ContourEdge> outlineOf(const layers::Patch& patch) {
  std::vector<ContourEdge> edges;
  const auto at = [&](int v) -> Vector2d {
    return patch.surface.vertices[static_cast<std::size_t>(v)].head<2>();
  };
  for (const std::vector<int>& loop : geometry::boundaryLoops(patch.surface))
    for (std::size_t i = 0; i < loop.size(); ++i)
      edges.push_back({at(loop[i]), at(loop[(i + 1) % loop.size()])});
  return edges;
}

class Gaps {
public:
  Gaps(const std::vector<ContourEdge>& patch, std::vector<const std::vector<ContourEdge>*> below,
       const process::Process& process, double insetMm)
      : patch_(patch), below_(std::move(below)), process_(process), insetMm_(insetMm),
        spacing_(process::hatchOf(process.beadWidthMm, process.layerHeightMm)) {}

  // Returns the length of lines that nothing holds [mm], with a share of the held spans.
  double cost(double angleRad) const {
    const Vector2d across(-std::sin(angleRad), std::cos(angleRad));
    double low = INFINITY, high = -INFINITY;
    for (const ContourEdge& edge : patch_) {
      low = std::min(low, across.dot(edge.from));
      high = std::max(high, across.dot(edge.from));
    }
    const auto count = static_cast<std::size_t>(std::max(0.0, (high - low) / spacing_));
    const ScanLines scan(angleRad, low + 0.5 * spacing_, spacing_, count);
    const auto inside = scan.inside(patch_);
    std::vector<std::vector<Interval>> held(count);
    for (const std::vector<ContourEdge>* outline : below_) {
      const auto more = scan.inside(*outline);
      for (std::size_t i = 0; i < count; ++i)
        held[i].insert(held[i].end(), more[i].begin(), more[i].end());
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<Interval> holds = mergedIntervals(std::move(held[i]));
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

  const std::vector<ContourEdge>& patch_;
  const std::vector<const std::vector<ContourEdge>*> below_;
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
  std::vector<ContourEdge> outline;
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

std::vector<std::optional<Level>>
levelsOf(std::size_t count, const std::function<const layers::Patch&(std::size_t)>& patch,
         const base::RunContext& ctx) {
  std::vector<std::optional<Level>> levels(count);
  base::parallelChunks(ctx, levels.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      levels[i] = levelOf(patch(i));
  });
  return levels;
}

} // namespace

std::vector<std::optional<double>>
bridgeDirections(std::span<const layers::Patch* const> patches, const layers::LayerStack& whole,
                 const std::function<process::Process(std::size_t)>& processOf,
                 const UsualLines& usual, const base::RunContext& ctx) {
  const std::vector<std::optional<Level>> own = levelsOf(
      patches.size(), [&](std::size_t i) -> const layers::Patch& { return *patches[i]; }, ctx);
  const std::vector<std::optional<Level>> all = levelsOf(
      whole.patches.size(), [&](std::size_t i) -> const layers::Patch& { return whole.patches[i]; },
      ctx);
  std::vector<std::size_t> byHeight;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i])
      byHeight.push_back(i);
  std::ranges::sort(byHeight, {}, [&](std::size_t i) { return all[i]->z; });
  std::vector<std::optional<double>> directions(patches.size());
  base::parallelChunks(ctx, directions.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!own[i])
        continue;
      const Level& level = *own[i];
      std::vector<const std::vector<ContourEdge>*> below;
      auto at = std::ranges::lower_bound(byHeight, level.z - kGap * level.thicknessMm, {},
                                         [&](std::size_t k) { return all[k]->z; });
      for (; at != byHeight.end() && all[*at]->z < level.z - kNearest * level.thicknessMm; ++at)
        below.push_back(&all[*at]->outline);
      if (below.empty())
        continue; // on the ground, or in the air altogether
      const process::Process process = processOf(i);
      const double inset =
          usual.walls * process::hatchOf(process.beadWidthMm, process.layerHeightMm);
      const double degrees = usual.angleDeg + patches[i]->layer * usual.rotationDeg;
      directions[i] = directionOver(Gaps(level.outline, std::move(below), process, inset), process,
                                    base::degreesToRadians(std::remainder(degrees, 180.0)));
    }
  });
  return directions;
}

} // namespace voluta::toolpath
