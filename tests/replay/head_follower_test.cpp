// A head among cells, along ways that creep, turn and jump.
#include "replay/head_follower.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

Vector3d randomVector(std::mt19937& random) {
  std::normal_distribution<double> u(0, 1);
  return {u(random), u(random), u(random)};
}

// Its results equal those of a new search at each place.
TEST(HeadFollower, AgreesWithASeparateSearchAtEachPlace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(0, 1);
  BeadGrid beads;
  beads.grid.origin = {-15, -12, 0};
  beads.grid.pitch = 0.4;
  beads.grid.size = {75, 61, 40};
  beads.filler = base::ZeroedArray<std::uint32_t>(beads.grid.cellCount());
  std::vector<BeadPiece> pieces(4000);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    pieces[p].run = static_cast<std::uint32_t>(p / 100);
    pieces[p].runMm = static_cast<float>(p % 100);
  }
  // Deposited from below, with gaps and some that stick out.
  for (std::size_t c = 0; c < beads.grid.cellCount(); ++c)
    if (u(random) < 0.3) {
      const double order = beads.grid.cell(c).z() / 40.0 + (u(random) < 0.01 ? -0.3 : 0.0);
      beads.filler[c] = 1 + static_cast<std::uint32_t>(std::clamp(order, 0.0, 0.99) * 4000);
    }
  const PrintedPart printed(beads, pieces);
  const HeadSolid head(
      {{{0.2, 0.4}, {5.0, 3.0}, {5.0, 6.0}, {12.0, 6.0}, {12.0, 9.0}, {30.0, 9.0}}});
  const HeadSolid upper({{{4.0, 1.0}, {12.0, 6.0}, {20.0, 2.0}}});

  int found = 0, none = 0;
  for (const HeadSolid* solid : {&head, &upper}) {
    HeadFollower follower(*solid, printed);
    Vector3d tip(0, 0, 5), direction = Vector3d::UnitZ();
    for (int round = 0; round < 4000; ++round) {
      if (u(random) < 0.03)
        tip = Vector3d(-15 + 30 * u(random), -12 + 24 * u(random), 17 * u(random));
      else
        tip += 0.3 * randomVector(random).cwiseProduct(Vector3d(1, 1, 0.2));
      direction = (direction + 0.01 * randomVector(random)).normalized();
      const double below = tip.z() / 16.0 + 0.04 * (u(random) - 0.7);
      const PrintState moment{static_cast<std::uint32_t>(std::clamp(below, 0.0, 1.0) * 4000),
                              static_cast<std::uint32_t>(40 * below), 50.0f, 30.0f};
      const auto within = [&](const Vector3d& q, double reach) {
        const double z = (q - tip).dot(direction);
        return solid->distance({(q - tip - z * direction).norm(), 0.0, z}) <= reach;
      };
      const Ball ball = solid->ball();
      const auto wanted =
          printed.firstWithin(tip + ball.centre.z() * direction, ball.radius, moment, within);
      const auto where = follower.touched(tip, direction, moment);
      ASSERT_EQ(where.has_value(), wanted.has_value()) << round;
      (wanted ? found : none)++;
      if (wanted) {
        const Eigen::Vector3i c = beads.grid.cell(*wanted);
        EXPECT_EQ(*where, beads.grid.centre(c.x(), c.y(), c.z())) << round;
      }
    }
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(none, 500);
}

// A box holds the head and is no larger than it must.
TEST(HeadFollower, ALeaningHeadIsInItsBox) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 1);
  const HeadSolid head({{{0.0, 0.5}, {10.0, 4.0}, {30.0, 15.0}, {60.0, 15.0}}});
  EXPECT_NEAR(head.reach(), std::hypot(60.0, 15.0), 1e-12);
  for (int k = 0; k < 20; ++k) {
    const Vector3d tip = randomVector(random), axis = randomVector(random).normalized();
    const Vector3d x = axis.unitOrthogonal(), y = axis.cross(x);
    const Eigen::AlignedBox3d box = head.boxRound(tip, axis);
    Eigen::AlignedBox3d points;
    for (const auto& [z, radius] : {std::pair(0.0, 0.5), {10.0, 4.0}, {30.0, 15.0}, {60.0, 15.0}})
      for (int a = 0; a < 3600; ++a) {
        const double angle = a * 0.00174532925199433;
        points.extend(
            Vector3d(tip + z * axis + radius * (std::cos(angle) * x + std::sin(angle) * y)));
      }
    EXPECT_LT((box.min() - points.min()).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LT((box.max() - points.max()).cwiseAbs().maxCoeff(), 1e-4);
  }
}

} // namespace
} // namespace voluta::replay
