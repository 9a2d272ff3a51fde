// One inverse for all turns about the nozzle comes to the same branches as one for each; and cells
// that are written from numbers.
#include "resource_fixture.h"
#include "urdf_arms.h"

#include "base/files.h"
#include "base/units.h"
#include "helpers/temporary_folder.h"
#include "robot/cell/cell_file_writer.h"
#include "robot/nozzle_turns.h"
#include "robot/urdf/urdf_reader.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace voluta::robot {
namespace {

using Eigen::Vector3d;

class NozzleTurning : public test::WithResources {
protected:
  RobotModel arm() {
    const std::filesystem::path file = folder_ / std::filesystem::path("arm.urdf");
    base::writeFile(file, test::urdfOf(test::oddArm()));
    return readUrdf(file, {.tip = {}, .base = {}, .id = "odd"}).model;
  }
  static CellDescription description(const RobotModel& robot) {
    CellDescription cell;
    cell.id = "odd-moving";
    cell.label = "odd";
    cell.note = "by hand";
    cell.robot = robot.id;
    cell.nozzlePose.translation() = Vector3d(0, 0, 200);
    cell.holder = {Frustum{Vector3d(0, 0, -110), Vector3d(0, 0, -175), 20, 20}};
    cell.platePose.translation() = Vector3d(500, 20, 100);
    cell.plates = {"rect:200x200"};
    cell.obstacles = {
        {"post", BodyRole::Obstacle, 0, {Capsule{Vector3d(900, 0, 0), Vector3d(900, 0, 500), 20}}}};
    cell.home = JointVector::Constant(6, 0.1);
    cell.neverMeet = {{"link_1", "post", "far"}};
    return cell;
  }
  static Cell cellOf(const CellDescription& described, const RobotModel& robot) {
    return Cell::read(cellFileJson(described, kindsOf(robot.limits)), described.id + ".json", robot,
                      process::loadProcess("fdm-1.0"),
                      std::vector<Eigen::Vector2d>{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}});
  }
  const test::TemporaryFolder folder_;
};

TEST_F(NozzleTurning, CellsAreReadBackFromTheirText) {
  const RobotModel robot = arm();
  const CellDescription described = description(robot);
  const Cell cell = cellOf(described, robot);
  EXPECT_EQ(cell.note(), "by hand");
  EXPECT_EQ(cell.plates(), described.plates);
  EXPECT_LT((cell.base_T_fixed().translation() - Vector3d(500, 20, 100)).norm(), 1e-12);
  EXPECT_LT((cell.flange_T_moved().translation() - Vector3d(0, 0, 200)).norm(), 1e-12);
  EXPECT_LT((cell.home() - described.home).norm(), 1e-12);
  ASSERT_EQ(cell.bodies().back().name, "post");
  const int post = static_cast<int>(cell.bodies().size()) - 1;
  const auto& pairs = cell.checkedPairs();
  EXPECT_EQ(std::find(pairs.begin(), pairs.end(), std::pair(1, post)), pairs.end());
  EXPECT_NE(std::find(pairs.begin(), pairs.end(), std::pair(2, post)), pairs.end());
  CellDescription other = described; // the plate on the flange
  other.nozzleMount = Mount::World;
  EXPECT_EQ(cellOf(other, robot).nozzleMount(), Mount::World);
}

TEST_F(NozzleTurning, IsTheSameAsAnInverseForEachTurn) {
  const RobotModel robot = arm();
  CellDescription described = description(robot);
  Eigen::Isometry3d down = Eigen::Isometry3d::Identity();
  down.linear() = Eigen::AngleAxisd(base::kPi, Vector3d::UnitX()).toRotationMatrix();
  down.translation() = Vector3d(10, -20, 30);
  for (const double offset : {0.0, 1e-3, 30.0}) { // of the nozzle from the last joint's axis, mm
    described.nozzlePose.translation().x() = offset;
    const Cell cell = cellOf(described, robot);
    EXPECT_EQ(cell.lastJointTurnsNozzle() != 0, offset < 1.0) << offset;
    const NozzleTurns turns(cell, down, cell.home());
    std::vector<JointVector> at, each;
    std::size_t found = 0;
    for (int k = 0; k < 12; ++k) {
      const double rotation = base::kTwoPi * k / 12;
      turns.at(rotation, at);
      Eigen::Isometry3d turned = down;
      turned.linear() *= Eigen::AngleAxisd(rotation, Vector3d::UnitZ()).toRotationMatrix();
      cell.inverse(turned, cell.home(), each);
      EXPECT_EQ(at.size(), each.size()) << offset << " " << k;
      for (const JointVector& q : at) {
        const Eigen::Isometry3d is = cell.work_T_tool(q);
        EXPECT_LT((is.translation() - turned.translation()).norm(), 1e-6);
        EXPECT_LT((is.linear() - turned.linear()).norm(), 1e-8);
        found += std::any_of(each.begin(), each.end(),
                             [&](const JointVector& other) { return (other - q).norm() < 1e-5; });
      }
    }
    EXPECT_GT(found, 12u);
  }
}

} // namespace
} // namespace voluta::robot
