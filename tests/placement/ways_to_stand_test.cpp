// The stable orientations of parts for which they are known, from any orientation of the input.
#include "placement/ways_to_stand.h"

#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/all_seeds.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "placement/placement_parts.h"
#include "placement/resting_places.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::placement {
namespace {

using test::turned;

const base::RunContext kQuiet;
const Eigen::Quaterniond kOverX(Eigen::AngleAxisd(0.5 * base::kPi, Eigen::Vector3d::UnitX()));

// Legs of 40 and 24, 6 thick, 20 wide, standing on the longer one.
geometry::TriangleMesh bracket() {
  return test::meshOf(40, 20, 24, [](int i, int, int k) { return k < 6 || i < 6; });
}

// A post with an arm over one side, a foot, and no symmetry.
geometry::TriangleMesh crane() {
  geometry::TriangleMesh mesh = test::meshOf(18, 9, 22, [](int i, int j, int k) {
    return k < 3 || (i >= 4 && i < 8 && j >= 2 && j < 6) || (k >= 18 && i >= 4 && j >= 2 && j < 6);
  });
  for (Eigen::Vector3d& v : mesh.vertices)
    v *= 2.0;
  return mesh;
}

std::vector<StandingOrientation> waysOf(const geometry::TriangleMesh& mesh) {
  return waysToStand(mesh, {}, kQuiet);
}

double secondsOf(const StandingOrientation& orientation) {
  return estimatedSeconds(orientation.part, {}, {});
}

std::vector<double> contactsOf(const std::vector<StandingOrientation>& ways) {
  std::vector<double> contacts;
  for (const StandingOrientation& orientation : ways)
    contacts.push_back(orientation.score.contactMm2);
  return contacts;
}

// The figures of a way equal those of the mesh turned so.
void expectStands(const geometry::TriangleMesh& mesh, const StandingOrientation& orientation) {
  const geometry::TriangleMesh standing = turned(mesh, orientation.rotation);
  const OrientationScore is =
      OrientationMeasure(standing, 0.8, 0.786).of(Eigen::Matrix3d::Identity());
  EXPECT_NEAR(is.contactMm2, orientation.score.contactMm2, 1e-3 * is.contactMm2);
  EXPECT_NEAR(is.heightMm, orientation.score.heightMm, 1e-3 * is.heightMm);
  EXPECT_TRUE(orientation.score.stands);
}

TEST(WaysToStand, ABoxHasThree) {
  const geometry::TriangleMesh box = test::box({0, 0, 0}, {60, 40, 20});
  const std::vector<StandingOrientation> ways = waysOf(box);
  ASSERT_EQ(ways.size(), 3u);
  const double areas[] = {2400, 1200, 800}, heights[] = {20, 40, 60};
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(ways[n].score.contactMm2, areas[n], 1e-6);
    EXPECT_NEAR(ways[n].score.heightMm, heights[n], 1e-6);
    EXPECT_EQ(ways[n].score.riskyMm2, 0.0);
    EXPECT_EQ(ways[n].missed, 0u);
    EXPECT_EQ(ways[n].now, n == 0);
    expectStands(box, ways[n]);
  }
  EXPECT_TRUE(ways[0].rotation.isApprox(Eigen::Quaterniond::Identity()));
  EXPECT_LT(secondsOf(ways[0]), secondsOf(ways[2])) << "fewer layers";
  EXPECT_FALSE(betterOrientation(box, {}, kQuiet));
  EXPECT_EQ(waysOf(test::box({0, 0, 0}, {30, 30, 30})).size(), 1u) << "a cube has one";
}

TEST(WaysToStand, PlateOnItsEdgeIsBadlyOriented) {
  const geometry::TriangleMesh plate = test::box({0, 0, 0}, {60, 5, 40});
  const auto better = betterOrientation(plate, {}, kQuiet);
  ASSERT_TRUE(better);
  EXPECT_NEAR(better->now.score.contactMm2, 300.0, 1e-6);
  EXPECT_NEAR(better->best.score.contactMm2, 2400.0, 1e-6);
  EXPECT_FALSE(betterOrientation(turned(plate, better->best.rotation), {}, kQuiet))
      << "it lies well then";
}

TEST(WaysToStand, ConeIsBadlyOrientedOnItsTipAndWellOnItsBase) {
  const geometry::TriangleMesh cone = test::coneOnTip(15.0, 30.0, 64);
  const std::vector<StandingOrientation> ways = waysOf(cone);
  ASSERT_GE(ways.size(), 2u) << "its base, its side";
  for (const StandingOrientation& orientation : ways)
    EXPECT_FALSE(orientation.now) << "on its tip it does not stand";
  EXPECT_NEAR(ways[0].score.contactMm2, base::kPi * 225.0, 4.0);
  EXPECT_NEAR(ways[0].score.heightMm, 30.0, 1e-6);
  const auto better = betterOrientation(cone, {}, kQuiet);
  ASSERT_TRUE(better);
  EXPECT_FALSE(better->now.score.stands);
  const geometry::TriangleMesh upright = turned(cone, better->best.rotation);
  EXPECT_FALSE(betterOrientation(upright, {}, kQuiet));
  EXPECT_TRUE(waysOf(upright)[0].now);
}

TEST(WaysToStand, BracketRestsOnASideOrALeg) {
  const std::vector<StandingOrientation> ways = waysOf(bracket());
  const double side = 40 * 6 + 18 * 6;
  std::vector<double> contacts = contactsOf(ways);
  std::ranges::sort(contacts);
  ASSERT_EQ(contacts.size(), 3u)
      << "both sides are one way; on a tip it falls over, on both it touches little";
  EXPECT_NEAR(contacts[0], side, 1e-6);
  EXPECT_NEAR(contacts[1], 24 * 20, 1e-6);
  EXPECT_NEAR(contacts[2], 40 * 20, 1e-6);
  EXPECT_EQ(std::ranges::count_if(ways, &StandingOrientation::now), 1);
}

TEST(WaysToStand, PartDrawnWithYUpIsTurnedUpright) {
  const geometry::TriangleMesh upright = crane();
  ASSERT_FALSE(betterOrientation(upright, {}, kQuiet));
  const std::vector<StandingOrientation> well = waysOf(upright);
  const std::vector<StandingOrientation> ways = waysOf(turned(upright, kOverX.conjugate()));
  const auto asDrawn = std::ranges::find_if(well, &StandingOrientation::now);
  ASSERT_NE(asDrawn, well.end());
  const auto stood = std::ranges::find_if(ways, [&](const StandingOrientation& orientation) {
    return std::abs(orientation.score.contactMm2 - asDrawn->score.contactMm2) < 1e-6 &&
           std::abs(orientation.score.heightMm - asDrawn->score.heightMm) < 1e-6;
  });
  ASSERT_NE(stood, ways.end());
  EXPECT_LT(stood->rotation.angularDistance(kOverX), 1e-6) << "about x, and nothing else";
}

TEST(WaysToStand, DoNotDependOnHowThePartCame) {
  const geometry::TriangleMesh mesh = crane();
  std::vector<StandingOrientation> wanted = waysOf(mesh);
  ASSERT_GE(wanted.size(), 3u);
  std::mt19937 random(11);
  std::normal_distribution<double> any;
  for (int n = 0; n < test::ofSeeds(20, 100); ++n) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
    const geometry::TriangleMesh came = turned(mesh, rotation);
    const std::vector<StandingOrientation> ways = waysOf(came);
    ASSERT_EQ(ways.size(), wanted.size()) << n;
    for (std::size_t w = 0; w < ways.size(); ++w) {
      if (ways[w].now && w + 1 == ways.size())
        continue; // on a corner, where it takes the last one's place
      EXPECT_NEAR(ways[w].score.contactMm2, wanted[w].score.contactMm2, 0.5) << n << ", " << w;
      EXPECT_NEAR(ways[w].score.heightMm, wanted[w].score.heightMm, 0.01) << n << ", " << w;
      EXPECT_NEAR(ways[w].score.riskyMm2, wanted[w].score.riskyMm2, 0.5) << n << ", " << w;
      EXPECT_NEAR(ways[w].missedShare(), wanted[w].missedShare(), 0.01) << n << ", " << w;
      EXPECT_NEAR(secondsOf(ways[w]), secondsOf(wanted[w]), 1.0) << n << ", " << w;
    }
    expectStands(came, ways[0]);
  }
}

// Each of them has an answer.
TEST(WaysToStand, SheetsAndPartsInOtherUnitsAreNoTrouble) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    EXPECT_FALSE(waysOf(test::box({0, 0, 0}, scale * Eigen::Vector3d(900, 700, 0.1))).empty());
    geometry::TriangleMesh open = test::box({0, 0, 0}, scale * Eigen::Vector3d(30, 20, 10));
    open.triangles.resize(8);
    EXPECT_NO_THROW(waysOf(open));
    open.triangles.resize(2); // in one plane
    EXPECT_NO_THROW(waysOf(open));
    EXPECT_NO_THROW(betterOrientation(open, {}, kQuiet));
  }
}

TEST(WaysToStand, AreDistinctAndFew) {
  WaysOptions options;
  options.maxCount = 2;
  EXPECT_EQ(waysToStand(crane(), options, kQuiet).size(), 2u);
  const std::vector<StandingOrientation> ball = waysOf(test::sphere({0, 0, 0}, 20.0));
  EXPECT_GE(ball.size(), 1u);
  EXPECT_LE(ball.size(), 4u);
  for (std::size_t a = 0; a < ball.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GT(ball[a].rotation.angularDistance(ball[b].rotation), 0.1);
}

// The current orientation is among the ways even a poor one, as long as it is stable.
TEST(WaysToStand, CurrentOrientationIsAmongThem) {
  for (const double angle : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    const geometry::TriangleMesh came =
        turned(crane(),
               Eigen::Quaterniond(Eigen::AngleAxisd(angle * base::kPi, Eigen::Vector3d::UnitY())));
    const std::vector<StandingOrientation> ways = waysOf(came);
    ASSERT_EQ(std::ranges::count_if(ways, &StandingOrientation::now), 1) << angle;
    EXPECT_TRUE(std::ranges::find_if(ways, &StandingOrientation::now)
                    ->rotation.isApprox(Eigen::Quaterniond::Identity(), 1e-9));
  }
}

TEST(WaysToStand, CellsAreTurnedByQuartersOnly) {
  const geometry::TriangleMesh mesh = test::meshOf(30, 20, 20, [](int i, int, int k) {
    return i + k < 30; // a slope of steps, on which it could rest too
  });
  WaysOptions options;
  options.quarterTurns = true;
  for (const StandingOrientation& orientation : waysToStand(mesh, options, kQuiet)) {
    const Eigen::Matrix3d m = orientation.rotation.toRotationMatrix();
    EXPECT_LT((m - Eigen::Matrix3d(m.array().round())).norm(), 1e-6);
  }
}

TEST(WaysToStand, AreTheSameForAnyNumberOfThreads) {
  const geometry::TriangleMesh mesh = turned(
      crane(), Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())));
  const std::vector<StandingOrientation> one = waysOf(mesh),
                                         two = waysToStand(
                                             mesh, {}, base::RunContext(base::CancelToken{}, 2));
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t n = 0; n < one.size(); ++n) {
    EXPECT_EQ(one[n].rotation.coeffs(), two[n].rotation.coeffs());
    EXPECT_EQ(one[n].score.contactMm2, two[n].score.contactMm2);
    EXPECT_EQ(one[n].missed, two[n].missed);
    EXPECT_EQ(secondsOf(one[n]), secondsOf(two[n]));
  }
}

TEST(WaysToStand, CanBeCancelledAndReportTheirProgress) {
  const base::CancelToken token;
  token.cancel();
  EXPECT_THROW(waysToStand(crane(), {}, base::RunContext(token, 2)), base::Cancelled);
  EXPECT_THROW(betterOrientation(crane(), {}, base::RunContext(token, 2)), base::Cancelled);
  // Half way through, too.
  const base::CancelToken later;
  EXPECT_THROW(waysToStand(crane(), {},
                           base::RunContext(later, 2,
                                            [&](double fraction, const base::Message&) {
                                              if (fraction > 0.3)
                                                later.cancel();
                                            })),
               base::Cancelled);
  double last = 0.0;
  waysToStand(crane(), {},
              base::RunContext(base::CancelToken{}, 2, [&](double fraction, const base::Message&) {
                EXPECT_GE(fraction, last);
                last = fraction;
              }));
  EXPECT_EQ(last, 1.0);
}

TEST(WaysToStand, BadOrientationIsARuleOfTheFigures) {
  StandingOrientation now, better;
  now.score.stands = better.score.stands = true;
  now.voxels = better.voxels = 1000;
  now.score.contactMm2 = better.score.contactMm2 = 100.0;
  EXPECT_FALSE(liesBadly(now, better));
  now.missed = 5;
  EXPECT_FALSE(liesBadly(now, better)) << "as much may be left out";
  now.missed = 6;
  EXPECT_TRUE(liesBadly(now, better));
  better.missed = 3;
  EXPECT_FALSE(liesBadly(now, better)) << "hardly more than there";
  now.missed = better.missed = 0;
  better.score.contactMm2 = 401.0;
  EXPECT_TRUE(liesBadly(now, better));
  better.score.riskyMm2 = 1.0;
  EXPECT_FALSE(liesBadly(now, better)) << "bought with overhang";
  better.score.contactMm2 = 100.0;
  better.score.riskyMm2 = 24.0;
  now.score.riskyMm2 = 99.0;
  EXPECT_FALSE(liesBadly(now, better)) << "less hangs over than stands";
  now.score.riskyMm2 = 101.0;
  EXPECT_TRUE(liesBadly(now, better));
  better.score.riskyMm2 = 26.0;
  EXPECT_FALSE(liesBadly(now, better));
  better.score.riskyMm2 = 24.0;
  better.missed = 6;
  EXPECT_FALSE(liesBadly(now, better)) << "bought with voxels";
  now.score.stands = false;
  EXPECT_TRUE(liesBadly(now, better));
}

TEST(RestingPlaces, AreTheHullsFacesLargestFirst) {
  const std::vector<Eigen::Vector3d> box = restingPlaces(test::box({0, 0, 0}, {60, 40, 20}), 10);
  ASSERT_EQ(box.size(), 6u);
  EXPECT_NEAR(std::abs(box[0].z()), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(box[5].x()), 1.0, 1e-9);
  EXPECT_EQ(restingPlaces(test::box({0, 0, 0}, {60, 40, 20}), 4).size(), 4u);
  EXPECT_THROW(restingPlaces({}, 4), base::Error);
  geometry::TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_TRUE(restingPlaces(flat, 4).empty());
}

TEST(WaysToStand, SpotRestsOnItsFeet) {
  VOLUTA_MODEL_OR_SKIP(file, "spot.stl");
  const std::vector<StandingOrientation> ways = waysOf(geometry::readMesh(file).mesh);
  EXPECT_GE(ways.size(), 3u);
  for (const StandingOrientation& orientation : ways)
    expectStands(geometry::readMesh(file).mesh, orientation);
}

} // namespace
} // namespace voluta::placement
