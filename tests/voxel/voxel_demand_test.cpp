#include "voxel/voxel_demand.h"

#include "base/error.h"
#include "base/memory.h"
#include "helpers/shapes.h"
#include "voxel/solid_voxels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace voluta::voxel {
namespace {

TEST(VoxelDemand, EstimateIsNearTheVoxelsMade) {
  geometry::TriangleMesh shell = test::sphere({0, 0, 20}, 20.0, 40);
  test::append(shell, test::sphere({0, 0, 20}, 18.0, 40), true);
  for (const auto& mesh :
       {test::box({0, 0, 0}, {30, 20, 10.3}), test::sphere({0, 0, 9}, 9.0), shell})
    for (const double pitch : {0.3, 0.8}) {
      const VoxelDemand demand = voxelDemand(mesh, pitch);
      const SolidVoxels made = solidVoxels(mesh, pitch, base::RunContext{});
      EXPECT_NEAR(demand.cells / static_cast<double>(made.grid.cellCount()), 1.0, 0.1);
      EXPECT_NEAR(demand.voxels / static_cast<double>(made.count), 1.0, 0.15);
    }
}

TEST(VoxelDemand, TooSmallAWidthIsRefusedWithOneThatFits) {
  const geometry::TriangleMesh mesh = test::sphere({0, 0, 40}, 40.0);
  const std::uint64_t free = 500'000'000;
  EXPECT_NO_THROW(checkVoxelDemand(mesh, 0.8, free));
  try {
    checkVoxelDemand(mesh, 0.2, free);
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_EQ(voluta::base::english(e.context()), "voxelMm");
    EXPECT_THAT(e.what(), ::testing::HasSubstr("500 MB are free"));
    const std::size_t at = voluta::base::english(e.remedy()).find("least ");
    ASSERT_NE(at, std::string::npos) << e.what();
    const double fits = std::atof(voluta::base::english(e.remedy()).c_str() + at + 6);
    EXPECT_GT(fits, 0.2);
    EXPECT_NO_THROW(checkVoxelDemand(mesh, fits, free));
    EXPECT_THROW(checkVoxelDemand(mesh, fits - 0.02, free), base::Error);
  }
}

TEST(VoxelDemand, CellsThatAreThereAreCountedAsTheyAre) {
  const SolidVoxels made = solidVoxels(test::box({0, 0, 0}, {8, 8, 8}), 1.0, base::RunContext{});
  const auto needed = static_cast<std::uint64_t>(1000 * kBytesPerCell + 512 * kBytesPerVoxel);
  EXPECT_NO_THROW(checkVoxelDemand(made, needed));
  EXPECT_THROW(checkVoxelDemand(made, needed - 1), base::Error);
}

TEST(AvailableMemory, IsSomethingAndReadsTheKernelsText) {
  EXPECT_GT(base::availableMemory(), 1'000'000u);
  EXPECT_EQ(base::kibibytesOf("MemFree: 7 kB\nMemAvailable:   12 kB\n", "MemAvailable:"), 12288u);
  EXPECT_EQ(base::kibibytesOf("MemFree: 7 kB\n", "MemAvailable:"), 0u);
  EXPECT_EQ(base::kibibytesOf("MemAvailable:\nMemFree: 7 kB\n", "MemAvailable:"), 0u);
}

} // namespace
} // namespace voluta::voxel
