// The search for the best orientation of a part, on parts with known answers.
#include "placement/orient.h"

#include "base/error.h"
#include "curved/grow.h"
#include "curved/platform_polygon.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "placement/placement_parts.h"

#include <gtest/gtest.h>

namespace voluta::placement {
namespace {

const base::RunContext kQuiet;

using test::meshOf;
using test::turned;

// Two posts, a beam, and a tooth below it between them, which growth from the posts' feet covers
// before it comes there.
geometry::TriangleMesh toothMesh() {
  return meshOf(24, 6, 19, [](int i, int j, int k) {
    return i < 4 || i >= 20 || k >= 16 || ((i == 11 || i == 12) && (j == 2 || j == 3) && k >= 8);
  });
}

geometry::TriangleMesh teeMesh() {
  return meshOf(15, 5, 15, [](int i, int, int k) { return k >= 10 || (i >= 5 && i < 10); });
}

OrientOptions atOneMm() {
  OrientOptions options;
  options.voxelMm = 1.0;
  return options;
}

std::size_t missedByGrowth(const geometry::TriangleMesh& mesh, double voxelMm) {
  const voxel::SolidVoxels part = voxel::solidVoxels(mesh, voxelMm, kQuiet);
  const curved::VoxelGraph graph =
      curved::voxelGraph(part.grid, part.solid, part.plateLayer(), curved::platformFit(part, 0.0));
  return part.count - curved::grow(graph, curved::GrowthScheme(), {}, kQuiet).printed;
}

TEST(Orient, FindsADirectionWithoutLoss) {
  const geometry::TriangleMesh mesh = toothMesh();
  ASSERT_GT(missedByGrowth(turned(mesh, Eigen::Quaterniond::Identity()), 1.0), 0u);
  const Orientation found = bestOrientation(mesh, Objective::FewestMissed, atOneMm(), kQuiet);
  EXPECT_GT(found.missedBefore, 0u);
  EXPECT_EQ(found.missed, 0u);
  EXPECT_EQ(found.missedAtVoxelMm, 0u);
  EXPECT_TRUE(found.score.stands);
  EXPECT_EQ(missedByGrowth(turned(mesh, found.rotation), 1.0), 0u);
}

TEST(Orient, PutsATeeOnItsBeamOrItsSide) {
  const geometry::TriangleMesh mesh = teeMesh();
  const Orientation found = bestOrientation(mesh, Objective::MinRiskyArea, atOneMm(), kQuiet);
  EXPECT_NEAR(found.before.riskyMm2, 2 * 5 * 5, 1e-9);
  EXPECT_NEAR(found.score.riskyMm2, 0.0, 1e-9);
  EXPECT_NEAR(found.score.heightMm, 5.0, 1e-9); // the lower of the two
}

TEST(Orient, WellOrientedPartIsKept) {
  const geometry::TriangleMesh mesh = test::box({0, 0, 0}, {20, 10, 5});
  for (const Objective objective : {Objective::MinRiskyArea, Objective::FewestMissed}) {
    const Orientation found = bestOrientation(mesh, objective, atOneMm(), kQuiet);
    EXPECT_TRUE(found.rotation.isApprox(Eigen::Quaterniond::Identity()));
    EXPECT_NEAR(found.score.contactMm2, 200.0, 1e-9);
  }
}

TEST(Orient, PartIsNeverPlacedOnATip) {
  // A long cone has the least risky area on its tip.
  const geometry::TriangleMesh cone = test::coneOnTip(10.0, 40.0, 32);
  for (const Objective objective : {Objective::MinRiskyArea, Objective::FewestMissed}) {
    const Orientation found = bestOrientation(cone, objective, atOneMm(), kQuiet);
    EXPECT_FALSE(found.before.stands);
    EXPECT_TRUE(found.score.stands);
    EXPECT_NEAR(found.score.heightMm, 40.0, 0.1); // on its base
  }
}

TEST(Orient, QuarterTurnsOnlyIfTheOptionIsSet) {
  OrientOptions options = atOneMm();
  options.quarterTurns = true;
  const Orientation found = bestOrientation(toothMesh(), Objective::FewestMissed, options, kQuiet);
  const Eigen::Matrix3d m = found.rotation.toRotationMatrix();
  EXPECT_LT((m - Eigen::Matrix3d(m.array().round())).norm(), 1e-9);
  EXPECT_EQ(found.missed, 0u);
}

TEST(Orient, IsTheSameForAnyNumberOfThreads) {
  const geometry::TriangleMesh mesh = toothMesh();
  const Orientation one = bestOrientation(mesh, Objective::FewestMissed, atOneMm(), kQuiet),
                    two = bestOrientation(mesh, Objective::FewestMissed, atOneMm(),
                                          base::RunContext(base::CancelToken{}, 2));
  EXPECT_EQ(one.rotation.coeffs(), two.rotation.coeffs());
  EXPECT_EQ(one.missedBefore, two.missedBefore);
  EXPECT_EQ(one.tried, two.tried);
}

TEST(Orient, ProgressNeverFalls) {
  double last = 0.0;
  std::size_t heard = 0;
  const base::RunContext ctx(base::CancelToken{}, 2,
                             [&](double fraction, const voluta::base::Message&) {
                               EXPECT_GE(fraction, last);
                               last = fraction;
                               ++heard;
                             });
  bestOrientation(toothMesh(), Objective::FewestMissed, atOneMm(), ctx);
  EXPECT_GT(heard, 5u);
  EXPECT_EQ(last, 1.0);
}

// Upside down the tee rests on its beam; `upsideDown` is the outcome there, `otherwise` elsewhere.
Orientation teeAfterCuts(const CutOutcome& upsideDown, const CutOutcome& otherwise) {
  OrientOptions options = atOneMm();
  options.cutOutcome = [&](const Eigen::Quaterniond& rotation) {
    return (rotation * Eigen::Vector3d::UnitZ()).z() < -0.99 ? upsideDown : otherwise;
  };
  return bestOrientation(teeMesh(), Objective::MinAfterCuts, options, kQuiet);
}

TEST(Orient, LeastAfterCutsMinimisesTheOverhangOfThePieces) {
  const Orientation found = teeAfterCuts({1.0, 2}, {9.0, 2});
  EXPECT_NEAR((found.rotation * Eigen::Vector3d::UnitZ()).z(), -1.0, 1e-9);
  EXPECT_EQ(found.cuts.riskyMm2, 1.0);
  EXPECT_EQ(found.cutsBefore.riskyMm2, 9.0);
  EXPECT_GT(found.tried, 3u);
  // Of equal outcomes the present orientation is kept, as it is up to a quarter above the best.
  for (const double left : {1.0, 0.81})
    EXPECT_TRUE(
        teeAfterCuts({left, 2}, {1.0, 2}).rotation.isApprox(Eigen::Quaterniond::Identity()));
}

// The estimate prefers upside down, where the cuts really leave 30 mm2.
TEST(Orient, MinAfterCutsIsCheckedByTheCutsThemselves) {
  OrientOptions options = atOneMm();
  const auto isUpsideDown = [](const Eigen::Quaterniond& rotation) {
    return (rotation * Eigen::Vector3d::UnitZ()).z() < -0.99;
  };
  options.cutOutcome = [&](const Eigen::Quaterniond& rotation) {
    return isUpsideDown(rotation) ? CutOutcome{1.0, 2} : CutOutcome{9.0, 2};
  };
  int checked = 0;
  options.checkedCuts = [&](const Eigen::Quaterniond& rotation) -> std::optional<CutOutcome> {
    ++checked;
    return isUpsideDown(rotation) ? CutOutcome{30.0, 4} : CutOutcome{10.0, 3};
  };
  const Orientation found = bestOrientation(teeMesh(), Objective::MinAfterCuts, options, kQuiet);
  EXPECT_FALSE(isUpsideDown(found.rotation));
  EXPECT_TRUE(found.areCutsChecked);
  EXPECT_EQ(found.cuts.riskyMm2, 10.0);
  EXPECT_EQ(found.cuts.pieces, 3u);
  EXPECT_LE(checked, 5);
  // Where the cuts confirm the estimate, no other orientation is cut.
  checked = 0;
  options.checkedCuts = [&](const Eigen::Quaterniond& rotation) {
    ++checked;
    return std::optional(options.cutOutcome(rotation));
  };
  EXPECT_TRUE(
      isUpsideDown(bestOrientation(teeMesh(), Objective::MinAfterCuts, options, kQuiet).rotation));
  EXPECT_EQ(checked, 1);
  // Orientations that cannot be cut are not chosen.
  options.checkedCuts = [&](const Eigen::Quaterniond& rotation) {
    return isUpsideDown(rotation) ? std::nullopt : std::optional(options.cutOutcome(rotation));
  };
  EXPECT_FALSE(
      isUpsideDown(bestOrientation(teeMesh(), Objective::MinAfterCuts, options, kQuiet).rotation));
}

TEST(Orient, MinAfterCutsCountsPieces) {
  // A piece costs 0.2 % of the present 50 mm2: 0.1 mm2.
  const CutOutcome few{0.0, 2}, many{0.0, 3};
  EXPECT_NEAR((teeAfterCuts(few, many).rotation * Eigen::Vector3d::UnitZ()).z(), -1.0, 1e-9);
  const CutOutcome saves{0.0, 4}, leaves{0.15, 2};
  EXPECT_TRUE(teeAfterCuts(saves, leaves).rotation.isApprox(Eigen::Quaterniond::Identity()));
}

TEST(Orient, CanBeCancelled) {
  const base::CancelToken token;
  token.cancel();
  EXPECT_THROW(
      bestOrientation(toothMesh(), Objective::FewestMissed, atOneMm(), base::RunContext(token, 1)),
      base::Cancelled);
}

TEST(Orient, SpotNeedsNoSupportWhenTurned) {
  VOLUTA_MODEL_OR_SKIP(file, "spot.stl");
  const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
  OrientOptions options;
  options.voxelMm = 2.0;
  const Orientation found = bestOrientation(mesh, Objective::FewestMissed, options, kQuiet);
  EXPECT_GT(found.missedBefore, 0u);
  EXPECT_EQ(found.missedAtVoxelMm, 0u);
  EXPECT_EQ(missedByGrowth(turned(mesh, found.rotation), 2.0), 0u);
}

} // namespace
} // namespace voluta::placement
