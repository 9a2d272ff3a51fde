#include "geometry/turn_angles.h"

#include "base/units.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;

namespace {

TEST(TurnAngles, AnglesGiveTheRotationBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-base::kPi, base::kPi);
  for (int i = 0; i < 2000; ++i) {
    Eigen::Vector3d angles(any(random), any(random), any(random));
    if (i % 4 == 0)
      angles.y() = i % 8 == 0 ? 0.5 * base::kPi : -0.5 * base::kPi;
    const Eigen::Vector3d near(any(random), any(random), any(random));
    const Eigen::Quaterniond rotation = geometry::rotationOf(angles);
    const Eigen::Quaterniond back = geometry::rotationOf(geometry::anglesOf(rotation, near));
    EXPECT_LT(rotation.angularDistance(back), 1e-7) << angles.transpose();
    const Eigen::Vector3d same = geometry::anglesOf(rotation, angles);
    EXPECT_TRUE(same.isApprox(angles, 1e-9)) << angles.transpose() << " / " << same.transpose();
  }
}

} // namespace
