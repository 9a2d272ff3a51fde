// Parts that flat layers print as well as any others.
#include "placement/terraced.h"

#include "helpers/shapes.h"
#include "placement/placement_parts.h"

#include <gtest/gtest.h>

namespace voluta::placement {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const Matrix3d kUpright = Matrix3d::Identity();

TEST(Terraced, AreBoxesStepsAndPlates) {
  const geometry::TriangleMesh box = test::box({0, 0, 0}, {30, 20, 10});
  const geometry::TriangleMesh steps =
      test::meshOf(9, 4, 6, [](int i, int, int k) { return k <= i / 2; });
  EXPECT_TRUE(isTerraced(box, kUpright));
  EXPECT_TRUE(isTerraced(steps, kUpright));
  // Turned about the vertical, and laid on any side, a box stays one.
  EXPECT_TRUE(isTerraced(box, AngleAxisd(0.3, Vector3d::UnitZ()).matrix()));
  EXPECT_TRUE(isTerraced(box, AngleAxisd(0.5 * base::kPi, Vector3d::UnitX()).matrix()));
}

TEST(Terraced, AreNoPartsWithSlopesOrOverhangs) {
  const geometry::TriangleMesh box = test::box({0, 0, 0}, {30, 20, 10});
  const geometry::TriangleMesh steps =
      test::meshOf(9, 4, 6, [](int i, int, int k) { return k <= i / 2; });
  const geometry::TriangleMesh table =
      test::meshOf(9, 4, 6, [](int i, int, int k) { return k > 4 || (i > 2 && i < 6); });
  const geometry::TriangleMesh hollow = test::meshOf(6, 6, 6, [](int i, int j, int k) {
    return i < 2 || i > 3 || j < 2 || j > 3 || k < 2 || k > 3;
  });
  EXPECT_FALSE(isTerraced(table, kUpright));
  EXPECT_FALSE(isTerraced(hollow, kUpright));
  EXPECT_FALSE(isTerraced(test::coneOnTip(10.0, 20.0, 40), kUpright));
  EXPECT_FALSE(isTerraced(steps, AngleAxisd(base::kPi, Vector3d::UnitX()).matrix()));
  for (const double degrees : {0.2, 2.0, 45.0})
    EXPECT_FALSE(
        isTerraced(box, AngleAxisd(base::degreesToRadians(degrees), Vector3d::UnitY()).matrix()))
        << degrees;
}

} // namespace
} // namespace voluta::placement
