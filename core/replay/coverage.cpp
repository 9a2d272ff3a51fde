#include "replay/coverage.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::replay {

namespace {

// Lines per cell along x and along y: few where their crossings agree, more where a steep wall
// passes.
constexpr int kFewLines = 2, kManyLines = 6;

// Adds the length of [low, high] (in cells, from the column's bottom) to the cells it passes.
void addSpan(double low, double high, std::vector<float>& column) {
  low = std::max(low, 0.0);
  high = std::min(high, static_cast<double>(column.size()));
  for (auto k = static_cast<std::size_t>(std::max(low, 0.0)); k < column.size() && k < high; ++k)
    column[k] +=
        static_cast<float>(std::min(high, k + 1.0) - std::max(low, static_cast<double>(k)));
}

} // namespace

PartCells partCells(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
                    const voxel::VoxelGrid& grid, const base::RunContext& ctx) {
  PartCells result;
  result.share.assign(grid.cellCount(), 0);
  if (part.empty())
    return result;
  Eigen::Vector3d low = part.vertices.front(), high = low;
  for (const Eigen::Vector3d& v : part.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double below = std::min(low.z(), grid.origin.z()) - 1.0;
  const double above = std::max(high.z(), grid.origin.z() + grid.pitch * grid.size.z()) + 1.0;
  std::vector<char> up(part.triangles.size());
  for (std::size_t t = 0; t < up.size(); ++t) {
    const Eigen::Vector3d a = part.corner(t, 0);
    up[t] = (part.corner(t, 1) - a).cross(part.corner(t, 2) - a).z() > 0.0;
  }

  // Returns how often the line crosses the part.
  const auto column = [&](double x, double y, std::vector<geometry::MeshQuery::Hit>& hits,
                          std::vector<float>& fill) -> std::size_t {
    if (x < low.x() || x > high.x() || y < low.y() || y > high.y())
      return 0;
    query.hits({x, y, below}, {x, y, above}, hits);
    const auto cellsAt = [&](double t) {
      return (below + t * (above - below) - grid.origin.z()) / grid.pitch;
    };
    int total = 0;
    for (const auto& hit : hits)
      total += up[static_cast<std::size_t>(hit.triangle)] ? -1 : 1;
    int winding = 0;
    for (std::size_t h = 0; h + 1 < hits.size(); ++h) {
      winding += up[static_cast<std::size_t>(hits[h].triangle)] ? -1 : 1;
      const double middle = 0.5 * (hits[h].t + hits[h + 1].t);
      const bool inside =
          total == 0 ? winding > 0 : query.inside({x, y, below + middle * (above - below)});
      if (inside)
        addSpan(cellsAt(hits[h].t), cellsAt(hits[h + 1].t), fill);
    }
    return hits.size();
  };
  // Sums lines^2 lines of a column of cells; returns whether all cross the part equally often.
  const auto columnOfCells = [&](int i, std::size_t j, int lines,
                                 std::vector<geometry::MeshQuery::Hit>& hits,
                                 std::vector<float>& fill) {
    std::fill(fill.begin(), fill.end(), 0.0f);
    std::size_t least = std::numeric_limits<std::size_t>::max(), most = 0;
    for (int u = 0; u < lines; ++u)
      for (int v = 0; v < lines; ++v) {
        const std::size_t crossings =
            column(grid.origin.x() + grid.pitch * (i + (u + 0.5) / lines),
                   grid.origin.y() + grid.pitch * (static_cast<double>(j) + (v + 0.5) / lines),
                   hits, fill);
        least = std::min(least, crossings);
        most = std::max(most, crossings);
      }
    return least == most;
  };

  base::parallelChunks(
      ctx, static_cast<std::size_t>(grid.size.y()), 4, [&](std::size_t begin, std::size_t end) {
        std::vector<float> fill(static_cast<std::size_t>(grid.size.z()));
        std::vector<geometry::MeshQuery::Hit> hits;
        for (std::size_t j = begin; j < end && !ctx.cancelled(); ++j)
          for (int i = 0; i < grid.size.x(); ++i) {
            int lines = kFewLines;
            if (!columnOfCells(i, j, lines, hits, fill))
              columnOfCells(i, j, lines = kManyLines, hits, fill);
            for (int k = 0; k < grid.size.z(); ++k) {
              const float f = fill[static_cast<std::size_t>(k)] / static_cast<float>(lines * lines);
              if (f > 0.0f)
                result.share[grid.index(i, static_cast<int>(j), k)] =
                    static_cast<std::uint8_t>(std::lround(255.0f * std::min(1.0f, f)));
            }
          }
      });
  const double sum = base::parallelSum<double>(ctx, grid.cellCount(), 1 << 18, 0.0,
                                               [&](std::size_t begin, std::size_t end) {
                                                 double s = 0.0;
                                                 for (std::size_t c = begin; c < end; ++c)
                                                   s += result.share[c];
                                                 return s;
                                               });
  result.volumeMm3 = sum / 255.0 * std::pow(grid.pitch, 3);
  return result;
}

Coverage measureCoverage(const BeadGrid& beads, const PartCells& cells,
                         const geometry::MeshQuery& query, double toleranceMm,
                         const base::RunContext& ctx) {
  base::require(cells.share.size() == beads.fill.size(), "measureCoverage: one grid");
  const voxel::VoxelGrid& grid = beads.grid;
  const auto fillOf = [&](std::size_t c) {
    const double other = beads.otherFill.empty() ? 0.0 : static_cast<double>(beads.otherFill[c]);
    return std::max(0.0, static_cast<double>(beads.fill[c]) - other);
  };
  const double cellVolume = std::pow(grid.pitch, 3);
  // Gaps are accumulated over blocks to find the position where most material is missing.
  const int block = std::max(1, static_cast<int>(std::lround(3.0 / grid.pitch)));
  struct Sum {
    double covered = 0.0, part = 0.0, outside = 0.0, gap = 0.0;
    Eigen::Vector3d gapAt = Eigen::Vector3d::Zero();
  };
  const auto slabs = static_cast<std::size_t>((grid.size.z() + block - 1) / block);
  std::vector<Sum> sums(slabs);
  const int blocksX = (grid.size.x() + block - 1) / block;
  const int blocksY = (grid.size.y() + block - 1) / block;
  base::parallelChunks(ctx, slabs, 1, [&](std::size_t begin, std::size_t) {
    Sum& sum = sums[begin];
    std::vector<double> gap(static_cast<std::size_t>(blocksX) * static_cast<std::size_t>(blocksY));
    const int first = static_cast<int>(begin) * block;
    for (int k = first; k < std::min(first + block, grid.size.z()); ++k)
      for (int j = 0; j < grid.size.y(); ++j) {
        if (ctx.cancelled())
          return;
        for (int i = 0; i < grid.size.x(); ++i) {
          const std::size_t c = grid.index(i, j, k);
          const double share = cells.share[c] / 255.0, fill = fillOf(c);
          sum.part += share;
          sum.covered += std::min(share, fill);
          gap[static_cast<std::size_t>(j / block * blocksX + i / block)] +=
              std::max(0.0, share - fill);
          if (fill > 0.0 && cells.share[c] == 0 &&
              query.closest(grid.centre(i, j, k), toleranceMm).triangle < 0)
            sum.outside += fill;
        }
      }
    const auto worst = std::max_element(gap.begin(), gap.end());
    sum.gap = *worst;
    const auto b = static_cast<int>(worst - gap.begin());
    const Eigen::Vector3i low(b % blocksX * block, b / blocksX * block, first);
    const Eigen::Vector3i end = (low.array() + block).min(grid.size.array());
    double missing = 0.0;
    for (int k = low.z(); k < end.z(); ++k)
      for (int j = low.y(); j < end.y(); ++j)
        for (int i = low.x(); i < end.x(); ++i) {
          const std::size_t c = grid.index(i, j, k);
          const double less = std::max(0.0, cells.share[c] / 255.0 - fillOf(c));
          missing += less;
          sum.gapAt += less * grid.centre(i, j, k);
        }
    if (missing > 0.0)
      sum.gapAt /= missing;
  });
  ctx.checkpoint();
  Coverage result;
  double part = 0.0, covered = 0.0;
  for (const Sum& s : sums) {
    part += s.part;
    covered += s.covered;
    result.outsideMm3 += s.outside * cellVolume;
    if (s.gap * cellVolume > result.worstGapMm3) {
      result.worstGapMm3 = s.gap * cellVolume;
      result.worstGap = s.gapAt;
    }
  }
  result.coveredFraction = part > 0.0 ? covered / part : 0.0;
  return result;
}

} // namespace voluta::replay
