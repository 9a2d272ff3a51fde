#include "base/error.h"
#include "substrate/touch_fit.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta {
namespace {

std::vector<Eigen::Vector2d> onCircle(const Eigen::Vector2d& centre, double r,
                                      const std::vector<double>& angles) {
  std::vector<Eigen::Vector2d> points;
  for (const double a : angles)
    points.emplace_back(centre + r * Eigen::Vector2d(std::cos(a), std::sin(a)));
  return points;
}

TEST(TouchFit, ThreePointsGiveTheirCircle) {
  // (4, 0), (0, 2), (0, -2): centre (1.5, 0), radius 2.5.
  const auto fit = substrate::circleThrough({{4, 0}, {0, 2}, {0, -2}});
  EXPECT_NEAR(fit.centre.x(), 1.5, 1e-12);
  EXPECT_NEAR(fit.centre.y(), 0.0, 1e-12);
  EXPECT_NEAR(fit.radiusMm, 2.5, 1e-12);
  EXPECT_NEAR(fit.rmsMm, 0.0, 1e-12);
}

TEST(TouchFit, FarFromTheOriginAndOverAShortArc) {
  const auto fit = substrate::circleThrough(onCircle({900, -400}, 20, {1.4, 1.5, 1.6, 1.7}));
  EXPECT_NEAR((fit.centre - Eigen::Vector2d(900, -400)).norm(), 0.0, 1e-8);
  EXPECT_NEAR(fit.radiusMm, 20.0, 1e-8);
}

TEST(TouchFit, ManyTouchesAverageTheirNoise) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::vector<double> angles;
  for (int i = 0; i < 400; ++i)
    angles.push_back(0.3 + 2.5 * i / 399.0);
  auto points = onCircle({10, 5}, 20, angles);
  for (auto& p : points)
    p *= 1.0 + noise(random) / p.norm();
  const auto fit = substrate::circleThrough(points);
  EXPECT_NEAR((fit.centre - Eigen::Vector2d(10, 5)).norm(), 0.0, 0.01);
  EXPECT_NEAR(fit.radiusMm, 20.0, 0.01);
  EXPECT_NEAR(fit.rmsMm, 0.02, 0.005);
}

TEST(TouchFit, PointsOnALineAreRefused) {
  for (const auto& points : {std::vector<Eigen::Vector2d>{{0, 0}, {1, 2}, {3, 6}},
                             {{500, 1}, {501, 1}, {502, 1}, {507, 1}},
                             {{1, 1}, {1, 1}, {1, 1}}})
    try {
      substrate::circleThrough(points);
      FAIL();
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
      EXPECT_EQ(std::string(e.what()), "touched points: the points are collinear (touch points "
                                       "farther apart around the cylinder)");
    }
  EXPECT_THROW(substrate::circleThrough({{0, 0}, {1, 1}}), base::Error);
  EXPECT_THROW(substrate::circleThrough({{0, 0}, {1, NAN}, {2, 1}}), base::Error);
}

} // namespace
} // namespace voluta
