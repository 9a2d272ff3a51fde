#include "scene/coarse_voxels.h"

namespace voluta::scene {

namespace {

// The cells of one block so far.
struct Block {
  std::int64_t rank = 0, value = 0; // sums
  std::int32_t printed = 0, missed = 0, support = 0;
  curved::Loss loss = curved::Loss::None;
};

} // namespace

CoarseVoxels::CoarseVoxels(const ShownCells& fine, int factor) {
  grid_.origin = fine.grid.origin;
  grid_.pitch = fine.grid.pitch * factor;
  grid_.size = (fine.grid.size.array() + (factor - 1)) / factor;
  std::vector<Block> blocks(grid_.cellCount());
  std::size_t cell = 0;
  for (int k = 0; k < fine.grid.size.z(); ++k)
    for (int j = 0; j < fine.grid.size.y(); ++j)
      for (int i = 0; i < fine.grid.size.x(); ++i, ++cell) {
        const std::int32_t rank = fine.rank[cell];
        if (rank == 0)
          continue;
        Block& block = blocks[grid_.index(i / factor, j / factor, k / factor)];
        if (rank < 0) {
          ++block.missed;
          if (!fine.loss.empty())
            block.loss = fine.loss[cell];
          continue;
        }
        ++block.printed;
        block.rank += rank;
        block.value += fine.value[cell];
        block.support += !fine.support.empty() && fine.support[cell] != 0;
      }

  rank_.assign(blocks.size(), 0);
  value_.assign(blocks.size(), 0);
  if (!fine.support.empty())
    support_.assign(blocks.size(), 0);
  if (!fine.loss.empty())
    loss_.assign(blocks.size(), curved::Loss::None);
  const std::int32_t enough = factor * factor * factor / 3;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    if (block.printed + block.missed < enough)
      continue;
    if (block.missed > block.printed) {
      rank_[b] = -1;
      if (!loss_.empty())
        loss_[b] = block.loss;
      continue;
    }
    rank_[b] = static_cast<std::int32_t>(block.rank / block.printed);
    value_[b] = static_cast<std::int32_t>(block.value / block.printed);
    if (!support_.empty())
      support_[b] = 2 * block.support > block.printed;
  }
}

} // namespace voluta::scene
