// Circles of changing curvature against numbers worked out apart from the code, and against
// distances measured along rays.
#include "base/error.h"
#include "base/units.h"
#include "published_flattening.h"
#include "substrate/flatten.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta {
namespace {

using substrate::FlatteningCircle;

double angle(double degrees) {
  return base::degreesToRadians(degrees);
}

// From a point of one circle outwards to the other, by halving an interval.
double measured(const FlatteningCircle& from, const FlatteningCircle& to, double alpha) {
  const auto beyond = [&](double h) {
    const double y = (from.radiusMm + h) * std::cos(alpha),
                 z = from.topMm - from.radiusMm + (from.radiusMm + h) * std::sin(alpha);
    return to.isPlane() ? z > to.topMm : std::hypot(y, z - (to.topMm - to.radiusMm)) > to.radiusMm;
  };
  double low = 0.0, high = 10.0;
  for (int i = 0; i < 80; ++i)
    (beyond(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return low;
}

TEST(Flatten, NextCircleHasTheGivenThicknesses) {
  const auto c = test::flatteningCircles({20.0, 20.0}, 0.15, 0.3, angle(41.4), 1);
  ASSERT_EQ(c.size(), 2u);
  EXPECT_NEAR(c[1].radiusMm, 20.601090481, 1e-8);
  EXPECT_NEAR(c[1].centreMm(), -0.451090481, 1e-8);
  EXPECT_NEAR(substrate::thicknessAt(c[0], c[1], angle(90)), 0.15, 1e-12);
  EXPECT_NEAR(substrate::thicknessAt(c[0], c[1], angle(75)), 0.16504, 5e-6);
  EXPECT_NEAR(substrate::thicknessAt(c[0], c[1], angle(60)), 0.20920, 5e-6);
  EXPECT_NEAR(substrate::thicknessAt(c[0], c[1], angle(50)), 0.25349, 5e-6);
  EXPECT_NEAR(substrate::thicknessAt(c[0], c[1], angle(41.4)), 0.3, 1e-12);
  EXPECT_NEAR(test::flatteningCircles({20.0, 20.0}, 0.2, 0.3, angle(45), 1)[1].radiusMm,
              20.546406555, 1e-8);
}

TEST(Flatten, EqualThicknessesStayConcentric) {
  const auto c = test::flatteningCircles({0.0, 20.0}, 0.2, 0.2, angle(40), 5);
  EXPECT_NEAR(c.back().radiusMm, 21.0, 1e-12);
  EXPECT_NEAR(c.back().centreMm(), -20.0, 1e-12);
}

TEST(Flatten, EveryLayerMeasuresTheSameAlongRays) {
  const auto c = test::flatteningCircles({20.0, 20.0}, 0.15, 0.3, angle(41.4), 10);
  for (std::size_t k = 0; k + 1 < c.size(); ++k)
    for (const double degrees : {41.4, 55.0, 70.0, 90.0, 120.0})
      EXPECT_NEAR(substrate::thicknessAt(c[k], c[k + 1], angle(degrees)),
                  measured(c[k], c[k + 1], angle(degrees)), 1e-10);
}

TEST(Flatten, EndsInAPlane) {
  const double r = 20.0, b = 7.0;
  const auto c = substrate::flatteningToPlane({r, r}, b, 0.2, 10);
  ASSERT_EQ(c.size(), 11u);
  EXPECT_TRUE(c.back().isPlane());
  EXPECT_NEAR(c.back().topMm, 22.0, 1e-12);
  const double height = r - std::sqrt(r * r - b * b);
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    // Heights over the chord are those of the circles at the chord's ends.
    const double s = c[k].radiusMm - std::sqrt(c[k].radiusMm * c[k].radiusMm - b * b);
    EXPECT_NEAR(s, height * (10.0 - static_cast<double>(k)) / 10.0, 1e-9);
    for (const double y : {0.0, 3.0, -5.0, b}) {
      const double alpha = std::acos(y / c[k].radiusMm);
      EXPECT_NEAR(substrate::thicknessAt(c[k], c[k + 1], alpha), measured(c[k], c[k + 1], alpha),
                  1e-10);
    }
  }
}

TEST(Flatten, ImpossibleOnesAreRefused) {
  EXPECT_THROW(substrate::flatteningToPlane({20.0, 20.0}, 20.5, 0.2, 10), base::Error);
}

} // namespace
} // namespace voluta
