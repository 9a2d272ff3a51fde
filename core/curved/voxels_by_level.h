// Voxels grouped by level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace voluta::curved {

class VoxelsByLevel {
public:
  // level: one per voxel; voxels with a negative level are left out.
  explicit VoxelsByLevel(const std::vector<std::int32_t>& level);

  // Number of levels that have voxels; they are sorted from the lowest.
  std::size_t levels() const { return first_.size() - 1; }
  // Returns the voxels of the n-th of these levels, ascending.
  std::span<const std::int32_t> of(std::size_t n) const {
    return {voxels_.data() + first_[n], first_[n + 1] - first_[n]};
  }

private:
  std::vector<std::int32_t> voxels_;
  std::vector<std::size_t> first_;
};

} // namespace voluta::curved
