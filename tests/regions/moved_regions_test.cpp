// Regions of a part that is cut.
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "regions/moved_regions.h"
#include "regions/part_regions.h"
#include "regions/region_uses.h"

#include <gtest/gtest.h>

namespace voluta::test {
namespace {

using project::Region;

regions::PieceOfPart pieceTurned(double degrees, const Eigen::Vector3d& axis) {
  regions::PieceOfPart piece;
  piece.work_T_file = Eigen::Translation3d(5, -3, 12) *
                      Eigen::AngleAxisd(base::degreesToRadians(degrees), axis.normalized());
  piece.scale = 2.0;
  piece.partBox = piece.box =
      Eigen::AlignedBox3d(Eigen::Vector3d(-60, -60, -60), Eigen::Vector3d(60, 60, 60));
  return piece;
}

// The body in the work frame is the same before and after.
void expectSamePlace(const std::string& shape, const regions::PieceOfPart& piece,
                     const std::string& kind) {
  const Region before{.shape = shape};
  const auto after = regions::regionsOfPiece(std::vector{before}, piece);
  ASSERT_EQ(after.size(), 1u) << shape;
  EXPECT_EQ(after[0].shape.substr(0, kind.size()), kind) << shape;
  const geometry::TriangleMesh part = box({-60, -60, -60}, {60, 60, 60});
  const auto was = regions::bodyOf(before, {part, piece.work_T_file, piece.scale}, {}, {});
  const auto is = regions::bodyOf(after[0], {part}, {}, {});
  EXPECT_NEAR(geometry::volume(is) / geometry::volume(was), 1.0, 1e-3) << shape;
  EXPECT_LT((geometry::bounds(is).center() - geometry::bounds(was).center()).norm(), 1e-3);
}

TEST(MovedRegions, ShapesKeepTheirPlacesInTheMaterial) {
  using Eigen::Vector3d;
  for (const double degrees : {0.0, 90.0, 30.0}) {
    const auto piece = pieceTurned(degrees, Vector3d::UnitZ());
    expectSamePlace("sphere:4,2,3,6", piece, "sphere");
    expectSamePlace("cylinder:4,2,3,6,8", piece, "cylinder");
    expectSamePlace("box:4,2,3,6,8,2", piece, degrees == 30.0 ? "mesh" : "box");
  }
  const auto tilted = pieceTurned(40.0, Vector3d(1, 1, 0));
  expectSamePlace("sphere:4,2,3,6", tilted, "sphere");
  expectSamePlace("cylinder:4,2,3,6,8", tilted, "mesh");
  expectSamePlace("box:4,2,3,6,8,2", tilted, "mesh");
}

TEST(MovedRegions, AForceKeepsItsDirectionInTheMaterial) {
  const auto piece = pieceTurned(90.0, Eigen::Vector3d::UnitZ());
  const Region before{.shape = "sphere:4,2,3,6", .use = "load:3,0,-1"};
  const auto after = regions::regionsOfPiece(std::vector{before}, piece);
  ASSERT_EQ(after.size(), 1u);
  EXPECT_LT((regions::forceOf(after[0].use) - Eigen::Vector3d(0, 3, -1)).norm(), 1e-6);
}

TEST(MovedRegions, HeightsBecomeABoxWhereThePieceIsPutDown) {
  auto piece = pieceTurned(0.0, Eigen::Vector3d::UnitZ());
  const std::vector<Region> all{{.shape = "height:4,8"}, {.shape = "skin:2", .use = "surface"}};
  EXPECT_EQ(regions::regionsOfPiece(all, piece), all);
  piece.keepsHeight = false;
  const auto moved = regions::regionsOfPiece(all, piece);
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[0].shape, "box:0,0,6,122,122,4");
  EXPECT_EQ(moved[1], all[1]);
}

TEST(MovedRegions, RegionsBesideThePieceAndThoseThatCutAreLeftOut) {
  auto piece = pieceTurned(0.0, Eigen::Vector3d::UnitZ());
  piece.box.max().z() = 0.0;
  const std::vector<Region> all{{.shape = "sphere:0,0,0,4"},   // around z = 12
                                {.shape = "sphere:0,0,-12,4"}, // around z = -12
                                {.shape = "sphere:0,0,-12,4", .use = "cut"},
                                {.shape = "sphere:0,0,-12,4", .use = "insert:7"},
                                {.shape = "painted:1"}};
  const auto kept = regions::regionsOfPiece(all, piece);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].shape, "sphere:5,-3,-12,8");
  EXPECT_EQ(kept[1].shape, "sphere:5,-3,-12,8");
  EXPECT_EQ(kept[1].use, "insert") << "its layers are others";
  EXPECT_EQ(kept[2].shape, "painted:1");
}

TEST(MovedRegions, PaintMovesWithThePart) {
  const auto piece = pieceTurned(90.0, Eigen::Vector3d::UnitX());
  const auto paint = std::make_shared<const geometry::TriangleMesh>(box({0, 0, 0}, {1, 2, 3}));
  const auto moved =
      regions::regionsOfPiece(std::vector<Region>{{.shape = "painted:1", .mesh = paint}}, piece);
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_LT((geometry::bounds(*moved[0].mesh).min() - Eigen::Vector3d(5, -9, 12)).norm(), 1e-9);
}

} // namespace
} // namespace voluta::test
