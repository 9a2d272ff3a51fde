#include "replay/bead_coverage.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

// Measures how much of each cell of a column the part occupies, by vertical lines.
class ColumnSampler {
public:
  // Precondition: the part has triangles.
  ColumnSampler(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
                const voxel::VoxelGrid& grid)
      : query_(query), grid_(grid), low_(part.vertices.front()), high_(low_),
        up_(part.triangles.size()) {
    for (const Eigen::Vector3d& v : part.vertices) {
      low_ = low_.cwiseMin(v);
      high_ = high_.cwiseMax(v);
    }
    below_ = std::min(low_.z(), grid.origin.z()) - 1.0;
    above_ = std::max(high_.z(), grid.origin.z() + grid.pitch * grid.size.z()) + 1.0;
    for (std::size_t t = 0; t < up_.size(); ++t) {
      const Eigen::Vector3d a = part.corner(t, 0);
      up_[t] = (part.corner(t, 1) - a).cross(part.corner(t, 2) - a).z() > 0.0;
    }
  }

  // Memory of one thread.
  struct Scratch {
    std::vector<geometry::MeshQuery::Hit> hits;
    std::vector<float> fill; // per cell of the column, summed over the lines
  };

  // Sums lines^2 lines of a column of cells; returns whether all cross the part equally often.
  bool sum(int i, std::size_t j, int lines, Scratch& scratch) const {
    std::fill(scratch.fill.begin(), scratch.fill.end(), 0.0f);
    std::size_t minimum = std::numeric_limits<std::size_t>::max(), maximum = 0;
    for (int u = 0; u < lines; ++u)
      for (int v = 0; v < lines; ++v) {
        const std::size_t crossings = addLine(
            grid_.origin.x() + grid_.pitch * (i + (u + 0.5) / lines),
            grid_.origin.y() + grid_.pitch * (static_cast<double>(j) + (v + 0.5) / lines), scratch);
        minimum = std::min(minimum, crossings);
        maximum = std::max(maximum, crossings);
      }
    return minimum == maximum;
  }

private:
  // Returns how often the line crosses the part.
  std::size_t addLine(double x, double y, Scratch& scratch) const {
    if (x < low_.x() || x > high_.x() || y < low_.y() || y > high_.y())
      return 0;
    std::vector<geometry::MeshQuery::Hit>& hits = scratch.hits;
    query_.hits({x, y, below_}, {x, y, above_}, hits);
    const auto cellsAt = [&](double t) {
      return (below_ + t * (above_ - below_) - grid_.origin.z()) / grid_.pitch;
    };
    int total = 0;
    for (const auto& hit : hits)
      total += up_[static_cast<std::size_t>(hit.triangle)] ? -1 : 1;
    int winding = 0;
    for (std::size_t h = 0; h + 1 < hits.size(); ++h) {
      winding += up_[static_cast<std::size_t>(hits[h].triangle)] ? -1 : 1;
      const double middle = 0.5 * (hits[h].t + hits[h + 1].t);
      const bool inside =
          total == 0 ? winding > 0 : query_.inside({x, y, below_ + middle * (above_ - below_)});
      if (inside)
        addSpan(cellsAt(hits[h].t), cellsAt(hits[h + 1].t), scratch.fill);
    }
    return hits.size();
  }

  const geometry::MeshQuery& query_;
  const voxel::VoxelGrid& grid_;
  Eigen::Vector3d low_, high_; // of the part
  double below_ = 0.0, above_ = 0.0;
  std::vector<char> up_; // per triangle: its normal points up
};

} // namespace

PartCells partCells(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
                    const voxel::VoxelGrid& grid, const base::RunContext& ctx) {
  PartCells result;
  result.share.assign(grid.cellCount(), 0);
  if (part.empty())
    return result;
  const ColumnSampler sampler(part, query, grid);
  base::parallelChunks(
      ctx, static_cast<std::size_t>(grid.size.y()), 4, [&](std::size_t begin, std::size_t end) {
        ColumnSampler::Scratch scratch;
        scratch.fill.resize(static_cast<std::size_t>(grid.size.z()));
        for (std::size_t j = begin; j < end && !ctx.cancelled(); ++j)
          for (int i = 0; i < grid.size.x(); ++i) {
            int lines = kFewLines;
            if (!sampler.sum(i, j, lines, scratch))
              sampler.sum(i, j, lines = kManyLines, scratch);
            for (int k = 0; k < grid.size.z(); ++k) {
              const float f =
                  scratch.fill[static_cast<std::size_t>(k)] / static_cast<float>(lines * lines);
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

namespace {

// Sums of an item's cells in a slab. Gaps are accumulated over blocks to find the position where
// most material is missing.
struct ItemSum {
  double covered = 0.0, part = 0.0, notch = 0.0, bulge = 0.0, gap = 0.0, interior = 0.0;
  Eigen::Vector3d gapAt = Eigen::Vector3d::Zero();
  double thin = 0.0, thinInBlock = 0.0; // in all, in the worst block
  Eigen::Vector3d thinAt = Eigen::Vector3d::Zero();
};

struct SlabSum {
  std::vector<ItemSum> items;
  std::vector<float> thin; // per item and block; empty: none
  double outside = 0.0;
};

class SlabMeasure {
public:
  SlabMeasure(const BeadGrid& beads, const PartCells& cells, const geometry::MeshQuery& query,
              const SurfaceBands& bands, const ItemFinder& items, const ThinCells& thin)
      : thin_(thin), beads_(beads), grid_(beads.grid), cells_(cells), query_(query), bands_(bands),
        items_(items), block_(std::max(1, static_cast<int>(std::lround(3.0 / grid_.pitch)))),
        blocksX_((grid_.size.x() + block_ - 1) / block_),
        blocksY_((grid_.size.y() + block_ - 1) / block_) {}

  std::size_t slabs() const {
    return static_cast<std::size_t>((grid_.size.z() + block_ - 1) / block_);
  }

  // Stops early if the run is cancelled.
  SlabSum measure(std::size_t slab, const base::RunContext& ctx) const {
    SlabSum sum;
    sum.items.resize(items_.count());
    const std::size_t blocks = this->blocks();
    std::vector<double> gap(blocks * items_.count()), open(gap.size());
    const int first = static_cast<int>(slab) * block_;
    for (int k = first; k < std::min(first + block_, grid_.size.z()); ++k)
      for (int j = 0; j < grid_.size.y(); ++j) {
        if (ctx.cancelled())
          return sum;
        ThinRow thinShares = thinRow(k, grid_.index(0, j, k));
        for (int i = 0; i < grid_.size.x(); ++i) {
          const std::size_t c = grid_.index(i, j, k);
          const double thin = thinShares.at(c);
          const double share = cells_.share[c] / 255.0, fill = fillOf(c);
          if (cells_.share[c] == 0 && fill <= 0.0)
            continue;
          const std::size_t item = items_.at(grid_.centre(i, j, k));
          ItemSum& own = sum.items[item];
          if (isInterior(i, j, k, item)) {
            own.interior += share;
            continue;
          }
          const double notch = notchAt(i, j, k);
          own.part += share;
          own.covered += std::min(share, fill);
          own.notch += notch;
          const std::size_t block =
              item * blocks + static_cast<std::size_t>(j / block_ * blocksX_ + i / block_);
          const double missing = std::max(0.0, share - fill - notch),
                       thinAndOpen = std::min(thin, missing);
          own.thin += thinAndOpen;
          open[block] += thinAndOpen;
          gap[block] += missing - thinAndOpen;
          if (fill <= share)
            continue;
          const bool outside = cells_.share[c] == 0 && !isNear(i, j, k, bands_.outsideMm);
          (outside ? sum.outside : own.bulge) += fill - share;
        }
      }
    for (std::size_t item = 0; item < sum.items.size(); ++item) {
      const auto from = gap.begin() + static_cast<std::ptrdiff_t>(item * blocks);
      const auto worst = std::max_element(from, from + static_cast<std::ptrdiff_t>(blocks));
      sum.items[item].gap = *worst;
      const auto b = static_cast<int>(worst - from);
      sum.items[item].gapAt =
          middleOfGap({b % blocksX_ * block_, b / blocksX_ * block_, first}, item, false);
      const auto thinFrom = open.begin() + static_cast<std::ptrdiff_t>(item * blocks);
      const auto most = std::max_element(thinFrom, thinFrom + static_cast<std::ptrdiff_t>(blocks));
      sum.items[item].thinInBlock = *most;
      const auto t = static_cast<int>(most - thinFrom);
      if (*most > 0.0)
        sum.items[item].thinAt =
            middleOfGap({t % blocksX_ * block_, t / blocksX_ * block_, first}, item, true);
    }
    if (!thin_.firstOfRow.empty())
      sum.thin.assign(open.begin(), open.end());
    return sum;
  }

  // Counts groups of neighbouring blocks, seen from above, with more than 2 % of an item's open
  // thin volume each. `open`: per block, summed over the slabs.
  std::size_t places(std::vector<double> open) const {
    constexpr double kNoticeable = 0.02;
    const double least = kNoticeable * std::accumulate(open.begin(), open.end(), 0.0);
    std::size_t count = 0;
    std::vector<int> stack;
    for (int start = 0; start < static_cast<int>(open.size()); ++start) {
      if (open[static_cast<std::size_t>(start)] <= least)
        continue;
      ++count;
      stack.assign(1, start);
      while (!stack.empty()) {
        const int block = stack.back(), x = block % blocksX_, y = block / blocksX_;
        stack.pop_back();
        open[static_cast<std::size_t>(block)] = 0.0;
        for (int j = std::max(0, y - 1); j <= std::min(blocksY_ - 1, y + 1); ++j)
          for (int i = std::max(0, x - 1); i <= std::min(blocksX_ - 1, x + 1); ++i)
            if (open[static_cast<std::size_t>(j * blocksX_ + i)] > least) {
              open[static_cast<std::size_t>(j * blocksX_ + i)] = 0.0;
              stack.push_back(j * blocksX_ + i);
            }
      }
    }
    return count;
  }

  std::size_t blocks() const {
    return static_cast<std::size_t>(blocksX_) * static_cast<std::size_t>(blocksY_);
  }

private:
  // Reads the thin cells in ascending order.
  struct ThinRow {
    const ThinCells::Cell *next, *end;
    double at(std::size_t cell) {
      while (next != end && next->index < cell)
        ++next;
      return next != end && next->index == cell ? next->share / 255.0 : 0.0;
    }
  };
  ThinRow thinRow(int k, std::size_t from) const {
    if (thin_.firstOfRow.empty())
      return {nullptr, nullptr};
    const ThinCells::Cell* cells = thin_.cells.data();
    const auto row = static_cast<std::size_t>(k);
    const ThinCells::Cell *begin = cells + thin_.firstOfRow[row],
                          *end = cells + thin_.firstOfRow[row + 1];
    return {std::lower_bound(
                begin, end, from,
                [](const ThinCells::Cell& cell, std::size_t index) { return cell.index < index; }),
            end};
  }

  double fillOf(std::size_t c) const {
    const double other = beads_.otherFill.empty() ? 0.0 : static_cast<double>(beads_.otherFill[c]);
    return std::max(0.0, static_cast<double>(beads_.fill[c]) - other);
  }

  bool isNear(int i, int j, int k, double distanceMm) const {
    return query_.closest(grid_.centre(i, j, k), distanceMm).triangle >= 0;
  }

  bool isInterior(int i, int j, int k, std::size_t item) const {
    return item < bands_.shellMm.size() && std::isfinite(bands_.shellMm[item]) &&
           cells_.share[grid_.index(i, j, k)] == 255 && !isNear(i, j, k, bands_.shellMm[item]);
  }

  // Returns the unfilled share of a cell that is a notch (see Coverage).
  double notchAt(int i, int j, int k) const {
    if (beads_.rectangle.empty())
      return 0.0;
    const std::size_t c = grid_.index(i, j, k);
    const std::uint8_t within = std::min(cells_.share[c], beads_.rectangle[c]);
    const double notch = within / 255.0 - fillOf(c);
    // Rounding of both shares
    if (notch <= 1.0 / 255.0 || (cells_.share[c] == 255 && !isNear(i, j, k, bands_.notchMm)))
      return 0.0;
    return notch;
  }

  // Returns the mean position of the item's material that is missing in the block from `low` on,
  // in thin places or in all others; zero if none is.
  Eigen::Vector3d middleOfGap(const Eigen::Vector3i& low, std::size_t item, bool ofThin) const {
    const Eigen::Vector3i end = (low.array() + block_).min(grid_.size.array());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double missing = 0.0;
    for (int k = low.z(); k < end.z(); ++k)
      for (int j = low.y(); j < end.y(); ++j)
        for (int i = low.x(); i < end.x(); ++i) {
          const std::size_t c = grid_.index(i, j, k);
          if (cells_.share[c] == 0 || items_.at(grid_.centre(i, j, k)) != item ||
              isInterior(i, j, k, item))
            continue;
          const double all = std::max(0.0, cells_.share[c] / 255.0 - fillOf(c) - notchAt(i, j, k)),
                       thin = std::min(all, thinRow(k, c).at(c)), less = ofThin ? thin : all - thin;
          missing += less;
          middle += less * grid_.centre(i, j, k);
        }
    if (missing > 0.0)
      middle /= missing;
    return middle;
  }

  const ThinCells& thin_;
  const BeadGrid& beads_;
  const voxel::VoxelGrid& grid_;
  const PartCells& cells_;
  const geometry::MeshQuery& query_;
  const SurfaceBands bands_;
  const ItemFinder& items_;
  const int block_, blocksX_, blocksY_; // cells; blocks
};

// Adds a slab's sums of an item, or of another part of it.
void add(ItemSum& to, const ItemSum& more) {
  to.covered += more.covered;
  to.part += more.part;
  to.notch += more.notch;
  to.bulge += more.bulge;
  to.interior += more.interior;
  to.thin += more.thin;
  if (more.thinInBlock > to.thinInBlock) {
    to.thinInBlock = more.thinInBlock;
    to.thinAt = more.thinAt;
  }
  if (more.gap > to.gap) {
    to.gap = more.gap;
    to.gapAt = more.gapAt;
  }
}

ItemCoverage coverageOf(const ItemSum& sum, double cellMm3) {
  const double covered = sum.covered + std::min(sum.notch, sum.bulge),
               coverable = sum.part - sum.thin;
  // Of a part that is thin everywhere, nothing is left to cover.
  constexpr double kNothing = 1e-9;
  return {.coveredFraction = coverable > kNothing ? covered / coverable
                             : sum.part > 0.0     ? 1.0
                                                  : 0.0,
          .worstGap = sum.gapAt,
          .worstGapMm3 = sum.gap * cellMm3,
          .thinMm3 = sum.thin * cellMm3,
          .worstThin = sum.thinAt,
          .shellMm3 = sum.part * cellMm3,
          .interiorMm3 = sum.interior * cellMm3};
}

} // namespace

Coverage measureCoverage(const BeadGrid& beads, const PartCells& cells,
                         const geometry::MeshQuery& query, const SurfaceBands& bands,
                         const base::RunContext& ctx, const ItemFinder& items,
                         const ThinCells& thin) {
  base::require(cells.share.size() == beads.fill.size(), "measureCoverage: one grid");
  const SlabMeasure slabs(beads, cells, query, bands, items, thin);
  std::vector<SlabSum> sums(slabs.slabs());
  base::parallelChunks(ctx, sums.size(), 1, [&](std::size_t begin, std::size_t) {
    sums[begin] = slabs.measure(begin, ctx);
  });
  ctx.checkpoint();
  const double cellMm3 = std::pow(beads.grid.pitch, 3);
  std::vector<ItemSum> ofItems(items.count());
  ItemSum all;
  double outside = 0.0;
  for (const SlabSum& slab : sums) {
    outside += slab.outside * cellMm3;
    for (std::size_t i = 0; i < ofItems.size(); ++i) {
      add(ofItems[i], slab.items[i]);
      add(all, slab.items[i]);
    }
  }
  Coverage result{coverageOf(all, cellMm3), outside, {}};
  for (std::size_t i = 0; i < ofItems.size(); ++i) {
    result.items.push_back(coverageOf(ofItems[i], cellMm3));
    if (thin.firstOfRow.empty())
      continue;
    std::vector<double> open(slabs.blocks());
    for (const SlabSum& slab : sums)
      for (std::size_t b = 0; b < open.size(); ++b)
        open[b] += static_cast<double>(slab.thin[i * open.size() + b]);
    result.items.back().thinPlaces = slabs.places(std::move(open));
    result.thinPlaces += result.items.back().thinPlaces;
  }
  return result;
}

} // namespace voluta::replay
