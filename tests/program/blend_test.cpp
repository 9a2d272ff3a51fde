// Blends and rotation vectors against closed forms.
#include "base/units.h"
#include "program/common/blend.h"
#include "program/common/rotation_vector.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::program {
namespace {

constexpr double pi = base::kPi;

TEST(Blend, arcPassesTheCornerAtItsClosedForm) {
  // A right angle rounded at 1 mm: the arc's radius is 1, its centre sqrt(2) from the corner.
  EXPECT_NEAR(blendDeviationMm(1.0, pi / 2), std::sqrt(2.0) - 1.0, 1e-12);
  EXPECT_EQ(blendDeviationMm(1.0, 0.0), 0.0);
}

TEST(Blend, straightOnTakesItsShareOfTheShorterSide) {
  const BlendSegment a{2.0, {2, 0, 0}}, b{1.0, {1, 0, 0}};
  EXPECT_NEAR(blendRadiusMm(a, b, 0.02), kBlendShare, 1e-12);
}

TEST(Blend, cornerKeepsItsTolerance) {
  const BlendSegment a{1.0, {1, 0, 0}}, b{1.0, {0, 1, 0}};
  const double r = blendRadiusMm(a, b, 0.02);
  EXPECT_NEAR(blendDeviationMm(r, pi / 2), 0.02, 1e-12);
}

TEST(Blend, countsOnThePartNotInBase) {
  // The TCP moves ten times as far as the nozzle on the part: ten times the radius is allowed.
  const BlendSegment a{10.0, {1, 0, 0}}, b{10.0, {0, 1, 0}};
  EXPECT_NEAR(blendRadiusMm(a, b, 0.02), 0.2 / std::tan(pi / 8), 1e-12);
}

TEST(Blend, needsAPathOnBothSides) {
  EXPECT_EQ(blendRadiusMm({0.0, {1, 0, 0}}, {1.0, {1, 0, 0}}, 0.02), 0.0);
  EXPECT_NEAR(blendRadiusMm({1.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, 0.02), kBlendShare, 1e-12);
}

TEST(RotationVector, knownExample) {
  const Eigen::Quaterniond q(.9515485, .0381346, .1893079, .2392983);
  EXPECT_TRUE(rotationVector(q).isApprox(Eigen::Vector3d(.077525, .384852, .486479), 1e-6));
  EXPECT_LE(rotationOf({.077525, .384852, .486479}).angularDistance(q), 1e-6);
}

TEST(RotationVector, bothWaysForAllAngles) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (const double angle : {0.0, 1e-14, 1e-9, 1e-5, 0.1, 1.0, 3.0, pi - 1e-9, pi}) {
    for (int n = 0; n < 100; ++n) {
      const Eigen::Vector3d axis =
          Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
      const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, axis));
      EXPECT_LE(rotationOf(rotationVector(q)).angularDistance(q), 3e-8);
      EXPECT_LE((rotationOf(rotationVector(q)).toRotationMatrix() - q.toRotationMatrix()).norm(),
                1e-14 + 1e-15 * angle);
      EXPECT_LE(rotationVector(q).norm(), pi + 1e-12);
    }
  }
}

TEST(RotationVector, isContinuousThroughHalfATurn) {
  Eigen::Vector3d previous = Eigen::Vector3d(0.7 * pi, 0, 0);
  for (double angle = 0.7 * pi; angle < 1.45 * pi; angle += 0.01) {
    const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()));
    const Eigen::Vector3d v = rotationVectorNear(q, previous);
    EXPECT_LT((v - previous).norm(), 0.011) << angle;
    EXPECT_LE(rotationOf(v).angularDistance(q), 3e-8);
    previous = v;
  }
}

} // namespace
} // namespace voluta::program
