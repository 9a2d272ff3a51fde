// The part as printed by the replay, at any moment of the program.
#pragma once

#include "replay/depositor.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::replay {

// The printed part at a place of the program: cells filled by pieces before `before`, without those
// that the same bead filled over its last `recentMm` (soft material below the nozzle).
struct PrintState {
  std::uint32_t before = 0;
  std::uint32_t run = kNeverFilled;
  float runMm = 0.0f, recentMm = 0.0f;
};

class PrintedPart {
public:
  // Keeps a reference to the beads and copies the needed fields of the pieces.
  PrintedPart(const BeadGrid& beads, const std::vector<BeadPiece>& pieces);

  const voxel::VoxelGrid& grid() const { return beads_.grid; }

  bool printed(std::size_t cell, const PrintState& moment) const {
    const std::uint32_t by = beads_.filledBy(cell);
    if (by >= moment.before)
      return false;
    const Piece& piece = pieces_[by];
    return piece.run != moment.run || moment.runMm - piece.runMm > moment.recentMm;
  }
  // Returns the piece that filled the cell of a point, kNeverFilled if the cell is not printed.
  std::uint32_t pieceAt(const Eigen::Vector3d& point, const PrintState& moment) const {
    const Eigen::Vector3i c = beads_.grid.cellOf(point);
    if (!beads_.grid.contains(c.x(), c.y(), c.z()))
      return kNeverFilled;
    const std::size_t cell = beads_.grid.index(c.x(), c.y(), c.z());
    return printed(cell, moment) ? beads_.filledBy(cell) : kNeverFilled;
  }
  bool printedAt(const Eigen::Vector3d& point, const PrintState& moment) const {
    return pieceAt(point, moment) != kNeverFilled;
  }

  // Returns a printed cell whose centre is in a solid. `within(point, reach)` returns whether a
  // cube of cells around a point of the work frame, with centres within `reach` of it, may
  // intersect the solid; with reach 0 whether the point is inside. The solid is inside the ball of
  // `radius` around `centre`.
  template <typename Within>
  std::optional<std::size_t> firstWithin(const Eigen::Vector3d& centre, double radius,
                                         const PrintState& moment, const Within& within) const {
    const Eigen::Vector3d r = Eigen::Vector3d::Constant(radius);
    std::optional<std::size_t> found;
    visitBlocks(
        {centre - r, centre + r}, moment.before,
        [&](const Eigen::Vector3d& q, double reach) {
          return (q - centre).squaredNorm() <= std::pow(radius + reach, 2) && within(q, reach);
        },
        [&](const Block& block) {
          found = firstIn(block, moment, within);
          return found.has_value();
        });
    return found;
  }

  // A cube of cells, some of them filled.
  struct Block {
    Eigen::Vector3i at;
    std::size_t index;
    Eigen::Vector3d middle;
  };
  // Collects the blocks that were partly filled before the piece `before` and may intersect the
  // solid in a box, in the order of firstWithin().
  template <typename Within>
  void blocksWithin(const Eigen::AlignedBox3d& box, std::uint32_t before, const Within& within,
                    std::vector<Block>& out) const {
    visitBlocks(box, before, within, [&](const Block& block) {
      out.push_back(block);
      return false;
    });
  }
  // Returns the maximum distance from a block's centre to the centres of its cells.
  double blockReach() const { return reachOf(0); }
  // As firstWithin(), for the cells of one block.
  template <typename Within>
  std::optional<std::size_t> firstIn(const Block& block, const PrintState& moment,
                                     const Within& within) const {
    if (levels_.front().earliest[block.index] >= moment.before)
      return std::nullopt;
    const Eigen::Vector3i first = kBranch * block.at, end = endOf(first, grid().size);
    for (int k = first.z(); k < end.z(); ++k)
      for (int j = first.y(); j < end.y(); ++j)
        for (int i = first.x(); i < end.x(); ++i) {
          const std::size_t cell = grid().index(i, j, k);
          // Check printed() last: the piece is far away in memory.
          if (beads_.filledBy(cell) < moment.before && within(grid().centre(i, j, k), 0.0) &&
              printed(cell, moment))
            return cell;
        }
    return std::nullopt;
  }

private:
  struct Piece {
    std::uint32_t run;
    float runMm;
  };
  // Blocks of `cells` cubed cells; `earliest`: the minimum filledBy in each.
  struct Level {
    int cells = 1;
    Eigen::Vector3i size;
    std::vector<std::uint32_t> earliest;
    std::size_t index(const Eigen::Vector3i& b) const {
      return static_cast<std::size_t>(b.x()) +
             static_cast<std::size_t>(size.x()) *
                 (static_cast<std::size_t>(b.y()) +
                  static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(b.z()));
    }
  };
  static constexpr int kBranch = 4;

  static Eigen::Vector3i endOf(const Eigen::Vector3i& first, const Eigen::Vector3i& size) {
    return (first + Eigen::Vector3i::Constant(kBranch)).cwiseMin(size);
  }
  double reachOf(std::size_t level) const {
    return 0.8660254037844387 * grid().pitch * (levels_[level].cells - 1);
  }

  // Calls visit(block) for the finest blocks in the solid until it returns true.
  template <typename Within, typename Visit>
  void visitBlocks(const Eigen::AlignedBox3d& box, std::uint32_t before, const Within& within,
                   const Visit& visit) const {
    const Level& top = levels_.back();
    const double width = grid().pitch * top.cells;
    const Eigen::Array3d low = (box.min() - grid().origin).array() / width,
                         high = (box.max() - grid().origin).array() / width;
    const Eigen::Vector3i first = low.floor().max(-1.0).cast<int>().max(0).matrix();
    const Eigen::Vector3i end =
        high.floor().max(-1.0).min(top.size.array().cast<double>() - 1.0).cast<int>() + 1;
    visitBlocks(levels_.size() - 1, first, end, before, within, visit);
  }
  template <typename Within, typename Visit>
  bool visitBlocks(std::size_t level, const Eigen::Vector3i& first, const Eigen::Vector3i& end,
                   std::uint32_t before, const Within& within, const Visit& visit) const {
    const Level& here = levels_[level];
    const double width = grid().pitch * here.cells, reach = reachOf(level);
    for (int k = first.z(); k < end.z(); ++k)
      for (int j = first.y(); j < end.y(); ++j)
        for (int i = first.x(); i < end.x(); ++i) {
          const Eigen::Vector3i block(i, j, k);
          const std::size_t index = here.index(block);
          if (here.earliest[index] >= before)
            continue;
          const Eigen::Vector3d middle =
              grid().origin + width * (block.cast<double>() + Eigen::Vector3d::Constant(0.5));
          if (!within(middle, reach))
            continue;
          const Eigen::Vector3i inner = kBranch * block;
          if (level == 0 ? visit(Block{block, index, middle})
                         : visitBlocks(level - 1, inner, endOf(inner, levels_[level - 1].size),
                                       before, within, visit))
            return true;
        }
    return false;
  }

  const BeadGrid& beads_;
  std::vector<Piece> pieces_;
  std::vector<Level> levels_; // finest first
};

} // namespace voluta::replay
