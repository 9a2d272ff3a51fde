// A disc over a straight bead, by closed forms.
#include "collision/bead_sections.h"

#include "base/run_context.h"
#include "collision/growing_part.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <vector>

using namespace voluta;
using Eigen::Vector3d;

namespace {

constexpr double kWidth = 1.2, kHeight = 0.8;

plan::ToolPlan beadAlongX() {
  plan::ToolPlan plan;
  for (int i = 0; i <= 20; ++i) {
    plan.position.emplace_back(i, 0.0, kHeight);
    plan.direction.push_back(Vector3d::UnitZ());
    plan.widthMm.push_back(static_cast<float>(kWidth));
    plan.heightMm.push_back(static_cast<float>(kHeight));
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back({.first = 0, .count = 21});
  return plan;
}

// Leaning by an angle about the bead's own direction: its rim on the bead's side is lowest.
collision::Disc leaning(double angle, const Vector3d& centre, double radius) {
  return {centre, Vector3d(0.0, std::sin(angle), std::cos(angle)), radius};
}

// From the disc's lowest rim point at (y, z) to the bead's section, a rectangle with half-round
// sides, where the rim point is the nearest.
double rimDistance(double y, double z) {
  const double flat = 0.5 * (kWidth - kHeight);
  return std::hypot(std::max(0.0, std::abs(y) - flat), z - 0.5 * kHeight) - 0.5 * kHeight;
}

} // namespace

TEST(BeadSections, DistanceOfALeaningDiscIsThatOfItsRim) {
  const collision::BeadSection bead = collision::beadSection(beadAlongX(), 9);
  const double radius = 0.5;
  for (const double angle : {0.05, 0.2, 0.5, 1.0})
    for (const double up : {0.9, 1.2, 2.0}) {
      const Vector3d centre(9.5, -1.0, up);
      const double y = centre.y() + radius * std::cos(angle),
                   z = centre.z() - radius * std::sin(angle);
      if (std::abs(y) > 0.2 || z < 0.4)
        continue; // the rim is not the nearest
      const double wanted = rimDistance(y, z);
      const double is = collision::discDistance(leaning(angle, centre, radius), bead);
      if (wanted > 0.0)
        EXPECT_NEAR(is, wanted, 1e-3) << angle << " " << up;
      else
        EXPECT_LE(is, 0.0) << angle << " " << up;
    }
}

TEST(BeadSections, AFlatDiscOverTheBeadIsAsFarAsItIsHigh) {
  const collision::BeadSection bead = collision::beadSection(beadAlongX(), 9);
  for (const double up : {0.81, 1.0, 1.5})
    EXPECT_NEAR(collision::discDistance({{9.5, 0.3, up}, Vector3d::UnitZ(), 0.5}, bead), up - 0.8,
                1e-3);
  // Beside it: from rim to the half-round side.
  EXPECT_NEAR(collision::discDistance({{9.5, 2.0, 0.4}, Vector3d::UnitZ(), 0.5}, bead),
              2.0 - 0.5 - 0.6, 1e-3);
  EXPECT_LE(collision::discDistance({{9.5, 0.0, 0.5}, Vector3d::UnitZ(), 0.5}, bead), 0.0);
}

// Cells of 0.3 mm hide a disc that is 0.1 mm deep in the bead; its section does not.
TEST(BeadSections, FindsContactsThatTheCellGridMisses) {
  plan::ToolPlan plan = beadAlongX();
  const collision::GrowingPart part(plan, 0.3, {});
  const collision::Revolved head({{{0, 0, -0.4}, {0, 0, -12.4}, 0.5, 5.6}});
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal(); // the tool's z points down
  for (const double deep : {-0.02, 0.02, 0.1}) {
    pose.translation() = Vector3d(9.5, 0.0, kHeight - 0.4 - deep);
    EXPECT_EQ(part.headTouches(head, pose, 0.0, 1000), deep > 0.0) << deep;
  }
  // Beads that the path itself has just deposited are soft.
  pose.translation() = Vector3d(9.5, 0.0, kHeight - 0.5);
  EXPECT_FALSE(part.headTouches(head, pose, 0.0, 11));
  EXPECT_TRUE(part.headTouches(head, pose, 0.0, 16));
}

// Bounds spare most searches; the answer is that of the search over every bead.
TEST(BeadSections, AreReachedWhereADistanceIsNotPositive) {
  const plan::ToolPlan plan = beadAlongX();
  std::vector<std::uint32_t> segments(20);
  std::iota(segments.begin(), segments.end(), 0U);
  const collision::BeadSections beads(plan, segments);
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::size_t reached = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const collision::Disc disc{
        {10.0 + 12.0 * unit(random), 1.5 * unit(random), 0.4 + 1.2 * unit(random)},
        Vector3d(unit(random), unit(random), 1.2 + unit(random)).normalized(),
        0.6 + 0.5 * unit(random)};
    bool isNear = false;
    for (const std::uint32_t segment : segments)
      isNear =
          isNear || collision::discDistance(disc, collision::beadSection(plan, segment)) <= 0.0;
    EXPECT_EQ(beads.reachedBy(disc, 1000), isNear) << trial;
    reached += isNear;
  }
  EXPECT_GT(reached, 400U);
  EXPECT_LT(reached, 1600U);
}
