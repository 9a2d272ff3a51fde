// Voxels that uniform layers miss.
#include "planar/slicing/uniform_misses.h"

#include <gtest/gtest.h>

namespace voluta::planar {
namespace {

TEST(UniformMisses, RoofIsMissedExceptForItsFirstSteps) {
  // Boge 6.3, on a T: a leg 4 wide and 8 high, a bar 20 wide and 3 high.
  voxel::SolidVoxels t;
  t.grid.size = {22, 3, 13};
  t.solid.assign(t.grid.cellCount(), 0);
  t.grid.origin = {0, 0, -1};
  t.grid.pitch = 1.0;
  for (int k = 1; k <= 11; ++k)
    for (int i = 1; i <= 20; ++i)
      if (k > 8 || (i >= 9 && i <= 12)) {
        t.solid[t.grid.index(i, 1, k)] = 1;
        ++t.count;
      }
  // Rows of the bar reach 6, 8 and 10 wide.
  EXPECT_EQ(uniformMisses(t).count, std::size_t{14 + 12 + 10});
  // Columns carry the left half.
  EXPECT_EQ(uniformMisses(t, [](const Eigen::Vector3d& at) { return at.x() < 11.0; }).count,
            std::size_t{7 + 6 + 5});
}

} // namespace
} // namespace voluta::planar
