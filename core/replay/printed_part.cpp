#include "replay/printed_part.h"

namespace voluta::replay {

PrintedPart::PrintedPart(const BeadGrid& beads, const std::vector<BeadPiece>& pieces)
    : beads_(beads) {
  pieces_.reserve(pieces.size());
  for (const BeadPiece& piece : pieces)
    pieces_.push_back({piece.run, piece.runMm});
  Eigen::Vector3i size = beads_.grid.size;
  for (int cells = kBranch; cells <= kBranch * kBranch * kBranch; cells *= kBranch) {
    Level level;
    level.cells = cells;
    level.size = (size.array() + (kBranch - 1)) / kBranch;
    level.earliest.assign(static_cast<std::size_t>(level.size.x()) *
                              static_cast<std::size_t>(level.size.y()) *
                              static_cast<std::size_t>(level.size.z()),
                          kNeverFilled);
    std::size_t at = 0;
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i, ++at) {
          std::uint32_t& earliest =
              level.earliest[level.index({i / kBranch, j / kBranch, k / kBranch})];
          earliest = std::min(earliest,
                              levels_.empty() ? beads_.filledBy(at) : levels_.back().earliest[at]);
        }
    size = level.size;
    levels_.push_back(std::move(level));
  }
}

} // namespace voluta::replay
