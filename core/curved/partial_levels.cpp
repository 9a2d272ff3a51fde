#include "curved/partial_levels.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr std::size_t kGrain = 4096;
constexpr int kSmoothing = 2;
// Tolerance on the limits: around a place beyond them, this much more is changed with it.
constexpr double kSlack = 0.08;
constexpr double kSteepest = 1e-3;

// Visits the neighbours that share a face with a cell.
template <typename F> void besideCell(const voxel::VoxelGrid& grid, std::size_t cell, F&& f) {
  const Eigen::Vector3i c = grid.cell(cell);
  for (int axis = 0; axis < 3; ++axis)
    for (int step : {-1, 1}) {
      Eigen::Vector3i n = c;
      n[axis] += step;
      if (grid.contains(n.x(), n.y(), n.z()))
        f(grid.index(n.x(), n.y(), n.z()));
    }
}

} // namespace

PartialLevels::PartialLevels(const LevelField& field, const Options& options,
                             const base::RunContext& ctx)
    : field_(field), options_(options) {
  const double minimum = options.heightMinMm, maximum = options.heightMaxMm;
  base::require(options.spacingMm > 0.0 && minimum > 0.0 && minimum <= maximum,
                "a positive spacing and height limits in order");
  // Halving and doubling keep thicknesses within the limits if these differ by a factor of two or
  // more. Otherwise a changed slab is as far beyond one limit as it was beyond the other.
  const double even = 0.5 * std::log2(2.0 * minimum * maximum);
  const bool wide = 2.0 * minimum <= maximum;
  splitAt_ = wide ? std::max(std::log2((1.0 - kSlack) * maximum), std::log2(2.0 * minimum)) : even;
  mergeAt_ =
      wide ? std::min(std::log2((1.0 + kSlack) * minimum), std::log2(0.5 * maximum)) : even - 1.0;
  measure(ctx);
  leaveSmallPlaces(ctx);
  markBlocks();
}

double PartialLevels::widthMm(int scale) const {
  return std::ldexp(options_.spacingMm, scale);
}

double PartialLevels::cutAbove(int scale) const {
  return scale <= 0 ? splitAt_ - scale : mergeAt_ - (scale - 1);
}

void PartialLevels::measure(const base::RunContext& ctx) {
  const voxel::VoxelGrid& grid = field_.grid();
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  thickness_.assign(grid.cellCount(), kNone);
  const double spacing = options_.spacingMm;
  base::parallelChunks(ctx, thickness_.size(), kGrain, [&](std::size_t b, std::size_t e) {
    for (std::size_t c = b; c < e; ++c) {
      const Eigen::Vector3i at = grid.cell(c);
      const int node = field_.voxelNode(at.x(), at.y(), at.z());
      if (field_.printed(node))
        thickness_[c] = static_cast<float>(
            std::log2(spacing / std::max(field_.gradient(node).norm(), kSteepest)));
    }
  });
  std::vector<float> next(thickness_.size());
  for (int round = 0; round < kSmoothing; ++round) {
    base::parallelChunks(ctx, thickness_.size(), kGrain, [&](std::size_t b, std::size_t e) {
      for (std::size_t c = b; c < e; ++c) {
        next[c] = thickness_[c];
        if (std::isnan(thickness_[c]))
          continue;
        float sum = 2.0f * thickness_[c], weight = 2.0f;
        besideCell(grid, c, [&](std::size_t n) {
          if (std::isnan(thickness_[n]))
            return;
          sum += thickness_[n];
          weight += 1.0f;
        });
        next[c] = sum / weight;
      }
    });
    thickness_.swap(next);
  }
}

void PartialLevels::leaveSmallPlaces(const base::RunContext& ctx) {
  const voxel::VoxelGrid& grid = field_.grid();
  const double cell = grid.pitch * grid.pitch * grid.pitch;
  std::vector<std::size_t> place;
  std::vector<std::uint8_t> seen;
  // beyond(t) returns whether a thickness is past the value `changeAt` at which a change begins,
  // and strictly(t) whether it is past the printable limit.
  const auto visit = [&](float changeAt, auto&& beyond, auto&& strictly) {
    seen.assign(thickness_.size(), 0);
    for (std::size_t seed = 0; seed < thickness_.size(); ++seed) {
      if (seed % 65536 == 0)
        ctx.checkpoint();
      if (seen[seed] || !beyond(thickness_[seed]))
        continue;
      place.assign(1, seed);
      seen[seed] = 1;
      std::size_t past = 0;
      for (std::size_t k = 0; k < place.size(); ++k) {
        past += strictly(thickness_[place[k]]) ? 1 : 0;
        besideCell(grid, place[k], [&](std::size_t n) {
          if (!seen[n] && beyond(thickness_[n])) {
            seen[n] = 1;
            place.push_back(n);
          }
        });
      }
      if (static_cast<double>(past) * cell >= options_.minVolumeMm3)
        continue;
      for (std::size_t c : place)
        thickness_[c] = changeAt;
    }
  };
  for (int scale = 0; scale > kFinest; --scale) {
    const auto at = static_cast<float>(cutAbove(scale)),
               limit = static_cast<float>(std::log2(options_.heightMaxMm) - scale);
    visit(
        at, [&](float t) { return t > at; }, [&](float t) { return t > limit; });
  }
  for (int scale = 1; scale <= kCoarsest; ++scale) {
    const auto at = static_cast<float>(cutAbove(scale)),
               limit = static_cast<float>(std::log2(options_.heightMinMm) - (scale - 1));
    // Slightly above, so that unchanged places count as cut.
    visit(
        at + 1e-4f, [&](float t) { return t <= at; }, [&](float t) { return t < limit; });
  }
}

std::size_t PartialLevels::blockOf(int i, int j, int k) const {
  const auto along = [&](int x, int axis) {
    return static_cast<std::size_t>(std::clamp(x / kBlock, 0, blocks_[axis] - 1));
  };
  return along(i, 0) + static_cast<std::size_t>(blocks_.x()) *
                           (along(j, 1) + static_cast<std::size_t>(blocks_.y()) * along(k, 2));
}

void PartialLevels::markBlocks() {
  const voxel::VoxelGrid& grid = field_.grid();
  blocks_ = (grid.size.array() + kBlock - 1) / kBlock;
  std::vector<Mask> own(static_cast<std::size_t>(blocks_.x()) *
                            static_cast<std::size_t>(blocks_.y()) *
                            static_cast<std::size_t>(blocks_.z()),
                        0);
  for (std::size_t c = 0; c < thickness_.size(); ++c) {
    if (std::isnan(thickness_[c]))
      continue;
    int scale = kCoarsest;
    while (scale > kFinest && static_cast<double>(thickness_[c]) > cutAbove(scale))
      --scale;
    const Eigen::Vector3i at = grid.cell(c);
    own[blockOf(at.x(), at.y(), at.z())] |= bit(scale);
    used_ |= bit(scale);
  }
  near_.assign(own.size(), 0);
  for (int k = 0; k < blocks_.z(); ++k)
    for (int j = 0; j < blocks_.y(); ++j)
      for (int i = 0; i < blocks_.x(); ++i) {
        Mask mask = 0;
        for (int n = 0; n < 27; ++n)
          mask |= own[blockOf((i + n % 3 - 1) * kBlock, (j + n / 3 % 3 - 1) * kBlock,
                              (k + n / 9 - 1) * kBlock)];
        near_[blockOf(i * kBlock, j * kBlock, k * kBlock)] = mask;
      }
}

bool PartialLevels::mayHold(int scale, int i, int j, int k) const {
  return scale == 0 || (near_[blockOf(i, j, k)] & bit(scale)) != 0;
}

double PartialLevels::thicknessAt(const Eigen::Vector3d& point) const {
  const voxel::VoxelGrid& grid = field_.grid();
  const Eigen::Vector3d q = (point - grid.origin) / grid.pitch - Eigen::Vector3d::Constant(0.5);
  const Eigen::Vector3d low = q.array().floor().matrix(), local = q - low;
  double sum = 0.0, weight = 0.0;
  for (int c = 0; c < 8; ++c) {
    const int i = static_cast<int>(low.x()) + (c & 1), j = static_cast<int>(low.y()) + (c >> 1 & 1),
              k = static_cast<int>(low.z()) + (c >> 2);
    if (!grid.contains(i, j, k))
      continue;
    const auto t = static_cast<double>(thickness_[grid.index(i, j, k)]);
    if (std::isnan(t))
      continue;
    const double w = 1e-6 + (c & 1 ? local.x() : 1.0 - local.x()) *
                                (c & 2 ? local.y() : 1.0 - local.y()) *
                                (c & 4 ? local.z() : 1.0 - local.z());
    sum += w * t;
    weight += w;
  }
  return weight > 0.0 ? sum / weight : std::numeric_limits<double>::quiet_NaN();
}

double PartialLevels::margin(const Slab& slab, const Eigen::Vector3d& point,
                             const Eigen::Vector3d& gradient) const {
  const double here = thicknessAt(point);
  const double own = std::isnan(here) ? std::log2(options_.heightMaxMm) : here;
  double margin = slab.scale > kFinest ? cutAbove(slab.scale) - own : 1e3;
  const double slope2 = std::max(gradient.squaredNorm(), kSteepest * kSteepest);
  const double mid = midOf(slab);
  for (Slab outer = slab; outer.scale < kCoarsest;) {
    outer = {outer.scale + 1, outer.index >> 1};
    // Larger slabs that are used nowhere are cut everywhere.
    if (outer.scale > 0 && (used_ & ~(bit(outer.scale) - 1)) == 0)
      break;
    const Eigen::Vector3d there = point + (midOf(outer) - mid) / slope2 * gradient;
    const double t = thicknessAt(there);
    margin = std::min(margin, (std::isnan(t) ? own : t) - cutAbove(outer.scale));
  }
  return margin;
}

} // namespace voluta::curved
