#include "voxel/wall_thickness.h"

#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/models.h"
#include "helpers/shapes.h"

#include <gtest/gtest.h>

namespace voluta::voxel {
namespace {

const base::RunContext kQuiet;

TEST(ThinPlaces, AWallIsFoundWithItsThicknessAndPlace) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {10, 10, 10});
  test::append(mesh, test::box({20, 0, 0}, {20.4, 8, 6}));
  const std::vector<ThinPlace> found = thinPlaces(mesh, 0.8, kQuiet);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].minMm, 0.4, 1e-9);
  EXPECT_NEAR(found[0].usualMm, 0.4, 1e-9);
  EXPECT_NEAR(found[0].areaMm2, 2 * 48.0, 1e-9);
  EXPECT_EQ(found[0].facets, 4u);
  EXPECT_GT(found[0].at.x(), 19.9);
}

TEST(ThinPlaces, WallAsThickAsAVoxelIsNotThin) {
  EXPECT_TRUE(thinPlaces(test::box({0, 0, 0}, {0.81, 8, 6}), 0.8, kQuiet).empty());
  EXPECT_TRUE(thinPlaces(test::sphere({0, 0, 5}, 5.0), 0.8, kQuiet).empty());
}

TEST(ThinPlaces, TheWallOfAHollowPartIsMeasuredNotItsCavity) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {10, 10, 10});
  test::append(mesh, test::box({0.5, 0.5, 0.5}, {9.5, 9.5, 9.5}), true);
  const std::vector<ThinPlace> found = thinPlaces(mesh, 0.8, kQuiet);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].usualMm, 0.5, 1e-9);
  // A gap of half a millimetre between two blocks is no wall.
  geometry::TriangleMesh gap = test::box({0, 0, 0}, {10, 10, 10});
  test::append(gap, test::box({10.5, 0, 0}, {20, 10, 10}));
  EXPECT_TRUE(thinPlaces(gap, 0.8, kQuiet).empty());
}

TEST(ThinPlaces, APlateOfOneLayerIsNotThinWhereLayersAreHorizontal) {
  const geometry::TriangleMesh plate = test::box({0, 0, 0}, {40, 30, 0.6}),
                               wall = test::box({0, 0, 0}, {0.6, 30, 40});
  EXPECT_EQ(thinPlaces(plate, 0.8, kQuiet).size(), 1u);
  EXPECT_TRUE(thinPlaces(plate, 0.8, kQuiet, 0.4).empty());
  EXPECT_EQ(thinPlaces(plate, 0.8, kQuiet, 0.7).size(), 1u) << "lower than a layer";
  EXPECT_EQ(thinPlaces(wall, 0.8, kQuiet, 0.4).size(), 1u);
}

TEST(ThinPlaces, SharpEdgesAreNotWalls) {
  // A wedge of 45 degrees.
  geometry::TriangleMesh wedge;
  wedge.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 8, 0}, {10, 8, 0}, {10, 8, 10}};
  wedge.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1},
                     {1, 4, 5}, {1, 5, 2}, {0, 2, 5}, {0, 5, 3}};
  EXPECT_TRUE(thinPlaces(wedge, 0.8, kQuiet).empty());
}

TEST(ThinPlaces, TwoWallsAreTwoPlacesLargestFirst) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {0.3, 4, 4});
  test::append(mesh, test::box({30, 0, 0}, {30.6, 9, 9}));
  const std::vector<ThinPlace> found = thinPlaces(mesh, 0.8, kQuiet);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].minMm, 0.6, 1e-9);
  EXPECT_NEAR(found[1].minMm, 0.3, 1e-9);
}

TEST(ThinPlaces, NothingOfAnOpenSheetOrAnEmptyMesh) {
  geometry::TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}};
  sheet.triangles = {{0, 1, 2}};
  EXPECT_TRUE(thinPlaces(sheet, 0.8, kQuiet).empty());
  EXPECT_TRUE(thinPlaces({}, 0.8, kQuiet).empty());
  EXPECT_THROW(thinPlaces(sheet, 0.0, kQuiet), base::Error);
}

TEST(ThinPlaces, SameForAnyNumberOfThreads) {
  VOLUTA_MODEL_OR_SKIP(file, "hollow_kitten_3mm.stl");
  const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
  const auto one = thinPlaces(mesh, 4.0, base::RunContext(base::CancelToken{}, 1));
  const auto two = thinPlaces(mesh, 4.0, base::RunContext(base::CancelToken{}, 2));
  ASSERT_FALSE(one.empty());
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].at, two[i].at);
    EXPECT_EQ(one[i].areaMm2, two[i].areaMm2);
  }
  EXPECT_NEAR(one[0].usualMm, 3.0, 0.3) << "the shell is 3 mm thick";
}

} // namespace
} // namespace voluta::voxel
