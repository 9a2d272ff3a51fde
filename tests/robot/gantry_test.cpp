// The slides of a Cartesian machine, and the axes of a table that turn directions upright.
#include "resource_fixture.h"

#include "base/units.h"
#include "geometry/directions.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/kinematics/gantry_kinematics.h"
#include "robot/upright_axes.h"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

namespace voluta::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using nlohmann::json;

class Gantry : public test::WithResources {
protected:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d direction() {
    return Vector3d(between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
  }
  static json shipped() {
    return json::parse(std::ifstream(VOLUTA_SOURCE_DIR "/resources/cells/five-axis.json"));
  }
  static Cell cellOf(const json& text) {
    platform::PlatformSolid plate;
    plate.polygon = {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}};
    return Cell::readText(text.dump(), "five-axis.json", process::loadProcess("fdm-1.0"), plate);
  }
  // Returns the direction in the base with the axes in this position.
  static Vector3d inBase(const Cell& cell, const Vector3d& direction, const JointVector& axes) {
    JointVector q = cell.home();
    q.tail(2) = axes;
    return cell.base_T_work(q).linear() * direction;
  }

  std::mt19937_64 random_{5};
};

TEST_F(Gantry, FlangeIsWhereTheSlidesAre) {
  const GantryKinematics gantry;
  JointVector q(4);
  q << 10, -20, 30, base::degreesToRadians(90);
  const Isometry3d flange = gantry.flange(q);
  EXPECT_LT((flange.translation() - Vector3d(10, -20, 30)).norm(), 1e-12);
  EXPECT_LT((flange.linear().col(0) - Vector3d::UnitY()).norm(), 1e-12);
  std::vector<Isometry3d> links;
  gantry.linkPoses(q, links);
  ASSERT_EQ(links.size(), 6u);
  EXPECT_LT((links[1].translation() - Vector3d(10, 0, 0)).norm(), 1e-12);
  EXPECT_LT((links[2].translation() - Vector3d(10, -20, 0)).norm(), 1e-12);
  EXPECT_LT((links[3].translation() - Vector3d(10, -20, 30)).norm(), 1e-12);
}

TEST_F(Gantry, ReachesNothingThatIsTilted) {
  const GantryKinematics gantry;
  std::vector<JointVector> solutions;
  for (const double tilt : {1e-4, 0.5, 3.1}) {
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(tilt, Vector3d::UnitX()).toRotationMatrix();
    gantry.inverse(pose, solutions);
    EXPECT_TRUE(solutions.empty()) << tilt;
  }
}

// On axes in any pose: each position found turns the direction upright; of two axes at right
// angles below an upright nozzle there are two for every direction.
TEST_F(Gantry, AxesTurnEveryDirectionUpright) {
  for (int n = 0; n < 300; ++n) {
    json text = shipped();
    const bool any = n % 2 == 1;
    const double about = between(-3, 3);
    text["externalAxes"][0]["axis"] =
        any ? json{std::cos(about), std::sin(about), between(-0.3, 0.3)} : json{0, 1, 0};
    if (any) {
      const Vector3d second = direction();
      text["externalAxes"][1]["axis"] = {second.x(), second.y(), second.z()};
      text["platform"]["pose"]["rpyDeg"] = {between(-90, 90), between(-90, 90), between(-90, 90)};
    }
    const Cell cell = cellOf(text);
    ASSERT_TRUE(tiltsPart(cell));
    const Vector3d d = direction();
    const std::vector<UprightAxes> found = uprightAxes(cell, d);
    if (!any) {
      EXPECT_EQ(found.size(), 2u);
    }
    for (const UprightAxes& at : found)
      EXPECT_LT((inBase(cell, d, at.axes) - Vector3d::UnitZ()).norm(), 1e-9) << n;
  }
}

TEST_F(Gantry, TheTurnIsFreeAlongItsAxis) {
  const Cell cell = cellOf(shipped());
  for (const double tilt : {0.0, 0.001, 0.0019}) {
    const Vector3d d(std::sin(tilt), 0, std::cos(tilt));
    const std::vector<UprightAxes> found = uprightAxes(cell, d);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found.front().lastIsFree);
    EXPECT_NEAR(found.front().axes[0], 0.0, 1e-12);
  }
  const std::vector<UprightAxes> beyond = uprightAxes(cell, Vector3d(0.0021, 0, 1).normalized());
  EXPECT_EQ(beyond.size(), 2u);
}

// B = -acos(nz), C = -atan2(ny, nx) or (-B, C + 180 degrees): the vector of docs/programs.md.
TEST_F(Gantry, AxesAreThoseOfTheTable) {
  const auto found = uprightAxes(cellOf(shipped()), Vector3d(-0.094, 0.127, 0.987).normalized());
  ASSERT_EQ(found.size(), 2u);
  const UprightAxes& at = found[found[0].axes[0] < 0.0 ? 0 : 1];
  EXPECT_NEAR(base::radiansToDegrees(at.axes[0]), -9.0950, 5e-5);
  EXPECT_NEAR(base::radiansToDegrees(at.axes[1]), -126.5073, 5e-5);
}

// Within the rounding of free directions the tip stays and the nozzle is straightened.
TEST_F(Gantry, TheTipStaysWhereTheNozzleIsStraightened) {
  const Cell cell = cellOf(shipped());
  std::vector<JointVector> solutions;
  for (int n = 0; n < 200; ++n) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = Vector3d(between(-50, 50), between(-50, 50), between(1, 80));
    const double tilt = between(0, kAlongAxisRad);
    pose.linear() = (Eigen::AngleAxisd(between(-3, 3), Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(base::kPi + tilt, Vector3d::UnitY()))
                        .toRotationMatrix();
    cell.inverse(pose, cell.home(), solutions);
    ASSERT_EQ(solutions.size(), 1u);
    const Isometry3d there = cell.work_T_tool(solutions.front());
    EXPECT_LT((there.translation() - pose.translation()).norm(), 1e-9);
    EXPECT_NEAR(geometry::angleBetween(there.linear().col(2), pose.linear().col(2)), tilt, 1e-7);
  }
}

} // namespace
} // namespace voluta::robot
