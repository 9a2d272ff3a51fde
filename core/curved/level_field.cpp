#include "curved/level_field.h"

#include "base/error.h"
#include "base/parallel.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr int kCentre = 13;
// Maximum slope of the field (a layer is at least 0.4 of 0.8 mm); steeper fits come from voxels
// with very few neighbours and would throw the outer ring far off.
constexpr double kMaxSlope = 3.0;
constexpr std::size_t kGrain = 4096;

Eigen::Vector3i offsetOf(int bit) {
  return {bit % 3 - 1, bit / 3 % 3 - 1, bit / 9 - 1};
}

// Returns, for each of the 27 voxels of a block, the voxels of the block that touch it.
const std::array<std::uint32_t, 27>& touching() {
  static const std::array<std::uint32_t, 27> masks = [] {
    std::array<std::uint32_t, 27> m{};
    for (int a = 0; a < 27; ++a)
      for (int b = 0; b < 27; ++b)
        if ((offsetOf(a) - offsetOf(b)).cwiseAbs().maxCoeff() <= 1)
          m[static_cast<std::size_t>(a)] |= 1u << b;
    return m;
  }();
  return masks;
}

// Returns the part of `mask` connected to its lowest bit.
std::uint32_t connectedGroup(std::uint32_t mask) {
  std::uint32_t group = mask & (~mask + 1), front = group;
  while (front != 0) {
    std::uint32_t reached = 0;
    for (std::uint32_t f = front; f != 0; f &= f - 1)
      reached |= touching()[static_cast<std::size_t>(std::countr_zero(f))];
    front = reached & mask & ~group;
    group |= front;
  }
  return group;
}

// Computes levels from ranks: a few rounds of averaging over pairs of opposite neighbours remove
// the steps and preserve linear regions, at the rim too.
void smoothRanks(std::vector<double>& value, const std::vector<int>& printed,
                 const std::vector<std::uint8_t>& isPrinted, const std::array<int, 27>& neighbour,
                 const base::RunContext& ctx) {
  constexpr std::array<std::size_t, 3> ahead = {14, 16, 22};
  std::vector<double> next(value);
  for (int round = 0; round < 4; ++round) {
    base::parallelChunks(ctx, printed.size(), kGrain, [&](std::size_t b, std::size_t e) {
      for (std::size_t p = b; p < e; ++p) {
        const int v = printed[p];
        double sum = 2.0 * value[static_cast<std::size_t>(v)], weight = 2.0;
        for (std::size_t f : ahead) {
          const auto u = static_cast<std::size_t>(v + neighbour[f]);
          const auto w = static_cast<std::size_t>(v - neighbour[f]);
          if (isPrinted[u] && isPrinted[w]) {
            sum += value[u] + value[w];
            weight += 2.0;
          }
        }
        next[static_cast<std::size_t>(v)] = sum / weight;
      }
    });
    value.swap(next);
  }
}

} // namespace

LevelField::LevelField(const Decomposition& d, const base::RunContext& ctx) : grid_(d.grid) {
  const std::size_t cells = grid_.cellCount();
  base::require(d.rank.size() == cells, "a rank for each cell of the grid");
  base::require(d.field.empty() || d.field.size() == cells, "a level for each cell of the grid");
  base::require(d.frontNormal.empty() || d.frontNormal.size() == cells,
                "a front normal for each cell of the grid");
  const Eigen::Vector3i padded = grid_.size.array() + 2;
  base::require(static_cast<double>(padded.x()) * padded.y() * padded.z() < 2e9,
                "a grid of fewer than 2e9 cells");
  denseCount_ = padded.x() * padded.y() * padded.z();
  for (int b = 0; b < 27; ++b) {
    const Eigen::Vector3i o = offsetOf(b);
    neighbour_[static_cast<std::size_t>(b)] = o.x() + padded.x() * (o.y() + padded.y() * o.z());
  }
  const auto count = static_cast<std::size_t>(denseCount_);
  kind_.assign(count, Kind::Far);
  value_.assign(count, 0.0);
  gradient_.assign(count, Eigen::Vector3f::Zero());
  frontNormal_.assign(count, Eigen::Vector3f::Zero());

  std::vector<int> printed;
  std::vector<std::uint8_t> isPrinted(count, 0);
  for (int k = 0; k < grid_.size.z(); ++k)
    for (int j = 0; j < grid_.size.y(); ++j)
      for (int i = 0; i < grid_.size.x(); ++i) {
        const std::size_t c = grid_.index(i, j, k);
        const bool has =
            d.rank[c] > 0 && (d.field.empty() || std::isfinite(static_cast<double>(d.field[c])));
        if (!has)
          continue;
        const int v = dense(i, j, k);
        const auto at = static_cast<std::size_t>(v);
        kind_[at] = Kind::Printed;
        isPrinted[at] = 1;
        value_[at] =
            d.field.empty() ? (d.rank[c] - 0.5) * grid_.pitch : static_cast<double>(d.field[c]);
        if (!d.frontNormal.empty())
          frontNormal_[at] = d.frontNormal[c];
        printed.push_back(v);
      }
  ctx.checkpoint();
  if (d.field.empty())
    smoothRanks(value_, printed, isPrinted, neighbour_, ctx);
  for (int v : printed)
    maxPrinted_ = std::max(maxPrinted_, value_[static_cast<std::size_t>(v)]);
  fitGradients(printed, ctx);
  extrapolate(printed, ctx);
}

void LevelField::fitGradients(const std::vector<int>& printed, const base::RunContext& ctx) {
  base::parallelChunks(ctx, printed.size(), kGrain, [&](std::size_t b, std::size_t e) {
    for (std::size_t p = b; p < e; ++p) {
      const int v = printed[p];
      Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
      Eigen::Vector3d right = Eigen::Vector3d::Zero();
      for (int n = 0; n < 27; ++n) {
        const int u = v + neighbour_[static_cast<std::size_t>(n)];
        if (n == kCentre || kind_[static_cast<std::size_t>(u)] != Kind::Printed)
          continue;
        const Eigen::Vector3d o = offsetOf(n).cast<double>();
        const double w = 1.0 / o.squaredNorm();
        normal += w * o * o.transpose();
        right += w * (value(u) - value(v)) * o;
      }
      // Where the neighbours span no volume, the slope across them is taken as zero.
      normal.diagonal().array() += 1e-7 * (normal.trace() + 1e-3);
      Eigen::Vector3d g = normal.ldlt().solve(right) / grid_.pitch;
      const double slope = g.norm();
      if (slope > kMaxSlope)
        g *= kMaxSlope / slope;
      gradient_[static_cast<std::size_t>(v)] = g.cast<float>();
    }
  });
}

void LevelField::extrapolate(const std::vector<int>& printed, const base::RunContext& ctx) {
  std::vector<int> ring;
  for (int v : printed)
    for (int o : neighbour_) {
      const auto u = static_cast<std::size_t>(v + o);
      if (kind_[u] == Kind::Far) {
        kind_[u] = Kind::Ring;
        ring.push_back(v + o);
      }
    }
  std::sort(ring.begin(), ring.end());
  ctx.checkpoint();

  const auto printedAround = [&](int v) {
    std::uint32_t mask = 0;
    const voxel::VoxelGrid padded{.size = grid_.size + Eigen::Vector3i::Constant(2)};
    const Eigen::Vector3i at = padded.cell(static_cast<std::size_t>(v));
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i o = offsetOf(n);
      // Printed voxels are never on the padding, so neighbours beyond it can be skipped.
      if (!padded.contains(at.x() + o.x(), at.y() + o.y(), at.z() + o.z()))
        continue;
      if (kind_[static_cast<std::size_t>(v + neighbour_[static_cast<std::size_t>(n)])] ==
          Kind::Printed)
        mask |= 1u << n;
    }
    return mask;
  };
  const auto fill = [&](int v, std::uint32_t group, int node) {
    double sum = 0.0, weight = 0.0;
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    for (std::uint32_t g = group; g != 0; g &= g - 1) {
      const int n = std::countr_zero(g);
      const int u = v + neighbour_[static_cast<std::size_t>(n)];
      const Eigen::Vector3d away = -offsetOf(n).cast<double>();
      const double w = 1.0 / (away.squaredNorm() * away.squaredNorm());
      sum += w * (value(u) + grid_.pitch * gradient(u).dot(away));
      slope += w * gradient(u);
      weight += w;
    }
    value_[static_cast<std::size_t>(node)] = sum / weight;
    gradient_[static_cast<std::size_t>(node)] = (slope / weight).cast<float>();
  };

  std::vector<std::uint32_t> around(ring.size());
  base::parallelChunks(ctx, ring.size(), kGrain, [&](std::size_t b, std::size_t e) {
    for (std::size_t r = b; r < e; ++r) {
      around[r] = printedAround(ring[r]);
      fill(ring[r], connectedGroup(around[r]), ring[r]);
    }
  });
  for (std::size_t r = 0; r < ring.size(); ++r) {
    std::uint32_t rest = around[r], group = connectedGroup(rest);
    if (group == rest)
      continue;
    kind_[static_cast<std::size_t>(ring[r])] = Kind::SplitRing;
    splitVoxel_.push_back(ring[r]);
    firstGroup_.push_back(static_cast<int>(groups_.size()));
    for (int node = ring[r]; rest != 0;) {
      rest &= ~group;
      groups_.push_back({group, node, rest != 0 ? static_cast<int>(groups_.size()) + 1 : -1});
      if (rest == 0)
        break;
      group = connectedGroup(rest);
      node = static_cast<int>(value_.size());
      value_.push_back(0.0);
      gradient_.push_back(Eigen::Vector3f::Zero());
      fill(ring[r], group, node);
    }
  }
}

Eigen::Vector3d LevelField::frontNormal(int node) const {
  return printed(node)
             ? Eigen::Vector3d(frontNormal_[static_cast<std::size_t>(node)].cast<double>())
             : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

std::optional<LevelField::Cell> LevelField::cell(int i, int j, int k) const {
  if (i < -1 || j < -1 || k < -1 || i >= grid_.size.x() || j >= grid_.size.y() ||
      k >= grid_.size.z())
    return std::nullopt;
  Cell cell;
  int solid = -1;
  const int minimum = dense(i, j, k);
  for (int c = 0; c < 8; ++c) {
    const int v =
        minimum +
        neighbour_[static_cast<std::size_t>(kCentre + (c & 1) + 3 * (c >> 1 & 1) + 9 * (c >> 2))];
    cell.nodes[static_cast<std::size_t>(c)] = v;
    if (solid < 0 && kind_[static_cast<std::size_t>(v)] == Kind::Printed)
      solid = c;
  }
  if (solid < 0)
    return std::nullopt;
  for (int c = 0; c < 8; ++c) {
    int& node = cell.nodes[static_cast<std::size_t>(c)];
    if (kind_[static_cast<std::size_t>(node)] != Kind::SplitRing)
      continue;
    const int bit = kCentre + ((solid & 1) - (c & 1)) + 3 * ((solid >> 1 & 1) - (c >> 1 & 1)) +
                    9 * ((solid >> 2) - (c >> 2));
    const auto at = std::lower_bound(splitVoxel_.begin(), splitVoxel_.end(), node);
    for (int g = firstGroup_[static_cast<std::size_t>(at - splitVoxel_.begin())]; g >= 0;
         g = groups_[static_cast<std::size_t>(g)].next)
      if (groups_[static_cast<std::size_t>(g)].mask >> bit & 1u) {
        node = groups_[static_cast<std::size_t>(g)].node;
        break;
      }
  }
  return cell;
}

std::optional<LevelField::Cell> LevelField::locate(const Eigen::Vector3d& point,
                                                   Eigen::Vector3d& local) const {
  const Eigen::Vector3d q = (point - grid_.origin) / grid_.pitch - Eigen::Vector3d::Constant(0.5);
  if (!(q.cwiseAbs().maxCoeff() < 1e8))
    return std::nullopt;
  const Eigen::Vector3d low = q.array().floor().matrix();
  local = q - low;
  return cell(static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(low.z()));
}

std::optional<LevelField::Sample> LevelField::sample(const Eigen::Vector3d& point) const {
  Eigen::Vector3d local;
  const std::optional<Cell> at = locate(point, local);
  if (!at)
    return std::nullopt;
  Sample s;
  for (int c = 0; c < 8; ++c) {
    const double w = (c & 1 ? local.x() : 1.0 - local.x()) * (c & 2 ? local.y() : 1.0 - local.y()) *
                     (c & 4 ? local.z() : 1.0 - local.z());
    s.value += w * value(at->nodes[static_cast<std::size_t>(c)]);
    s.gradient += w * gradient(at->nodes[static_cast<std::size_t>(c)]);
  }
  return s;
}

std::optional<double> LevelField::valueAt(const Eigen::Vector3d& point) const {
  const std::optional<Sample> s = sample(point);
  return s ? std::optional<double>(s->value) : std::nullopt;
}

} // namespace voluta::curved
