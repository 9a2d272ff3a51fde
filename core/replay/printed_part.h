// The part as the replay has laid it, asked for at any moment of the program.
#pragma once

#include "replay/depositor.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::replay {

// What lies there when the nozzle is at some place of the program: cells filled by pieces before
// `before`, without those that the same bead filled over its last `recentMm` (soft material under
// the nozzle).
struct Moment {
  std::uint32_t before = 0;
  std::uint32_t run = kNeverFilled;
  float runMm = 0.0f, recentMm = 0.0f;
};

class PrintedPart {
public:
  // Keeps references to both.
  PrintedPart(const BeadGrid& beads, const std::vector<BeadPiece>& pieces);

  const voxel::VoxelGrid& grid() const { return beads_.grid; }

  bool printed(std::size_t cell, const Moment& moment) const {
    const std::uint32_t by = beads_.filledBy(cell);
    if (by >= moment.before)
      return false;
    const BeadPiece& piece = pieces_[by];
    return piece.run != moment.run || moment.runMm - piece.runMm > moment.recentMm;
  }
  bool printedAt(const Eigen::Vector3d& point, const Moment& moment) const {
    const Eigen::Vector3i c = beads_.grid.cellOf(point);
    return beads_.grid.contains(c.x(), c.y(), c.z()) &&
           printed(beads_.grid.index(c.x(), c.y(), c.z()), moment);
  }

  // A printed cell whose centre is in a solid. `within(point, reach)` tells whether a cube of cells
  // about a point of the work frame, its corners at reach from it, may meet the solid; with reach 0
  // whether the point is in it. The solid lies in the ball of `radius` round `centre`.
  template <typename Within>
  std::optional<std::size_t> firstWithin(const Eigen::Vector3d& centre, double radius,
                                         const Moment& moment, const Within& within) const {
    if (levels_.empty())
      return std::nullopt;
    const Level& top = levels_.back();
    const double width = grid().pitch * top.cells;
    const Eigen::Array3d r = Eigen::Array3d::Constant(radius);
    const Eigen::Array3d origin = grid().origin.array();
    const Eigen::Array3i low =
        ((centre.array() - r - origin) / width).floor().max(-1.0).cast<int>().max(0);
    const Eigen::Array3i high = ((centre.array() + r - origin) / width)
                                    .floor()
                                    .max(-1.0)
                                    .min(top.size.array().cast<double>() - 1.0)
                                    .cast<int>();
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i)
          if (const auto found =
                  search(levels_.size() - 1, {i, j, k}, centre, radius, moment, within))
            return found;
    return std::nullopt;
  }

private:
  // Blocks of `cells` cubed; the least filledBy in each.
  struct Level {
    int cells = 1;
    Eigen::Vector3i size;
    std::vector<std::uint32_t> least;
    std::size_t index(const Eigen::Vector3i& b) const {
      return static_cast<std::size_t>(b.x()) +
             static_cast<std::size_t>(size.x()) *
                 (static_cast<std::size_t>(b.y()) +
                  static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(b.z()));
    }
  };
  static constexpr int kBranch = 4;

  template <typename Within>
  std::optional<std::size_t> search(std::size_t level, const Eigen::Vector3i& block,
                                    const Eigen::Vector3d& centre, double radius,
                                    const Moment& moment, const Within& within) const {
    const Level& here = levels_[level];
    if (here.least[here.index(block)] >= moment.before)
      return std::nullopt;
    const double width = grid().pitch * here.cells, reach = 0.8660254037844387 * width;
    const Eigen::Vector3d middle =
        grid().origin + width * (block.cast<double>() + Eigen::Vector3d::Constant(0.5));
    if ((middle - centre).norm() > radius + reach || !within(middle, reach))
      return std::nullopt;
    const Eigen::Vector3i first = kBranch * block;
    const Eigen::Vector3i end = (first + Eigen::Vector3i::Constant(kBranch))
                                    .cwiseMin(level == 0 ? grid().size : levels_[level - 1].size);
    for (int k = first.z(); k < end.z(); ++k)
      for (int j = first.y(); j < end.y(); ++j)
        for (int i = first.x(); i < end.x(); ++i) {
          if (level > 0) {
            const Level& finer = levels_[level - 1];
            if (finer.least[finer.index({i, j, k})] >= moment.before)
              continue;
            if (const auto found = search(level - 1, {i, j, k}, centre, radius, moment, within))
              return found;
            continue;
          }
          const std::size_t cell = grid().index(i, j, k);
          // The piece that filled it lies far away in memory.
          if (beads_.filledBy(cell) < moment.before && within(grid().centre(i, j, k), 0.0) &&
              printed(cell, moment))
            return cell;
        }
    return std::nullopt;
  }

  const BeadGrid& beads_;
  const std::vector<BeadPiece>& pieces_;
  std::vector<Level> levels_; // finest first
};

} // namespace voluta::replay
