// Voxels one level after the other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace voluta::curved {

class VoxelsByLevel {
public:
  // level: one a voxel; what has a negative one is left out.
  explicit VoxelsByLevel(const std::vector<std::int32_t>& level);

  // Of the levels that have voxels, lowest first.
  std::size_t levels() const { return first_.size() - 1; }
  // The voxels of the n-th of them, ascending.
  std::span<const std::int32_t> of(std::size_t n) const {
    return {voxels_.data() + first_[n], first_[n + 1] - first_[n]};
  }

private:
  std::vector<std::int32_t> voxels_;
  std::vector<std::size_t> first_;
};

} // namespace voluta::curved
