// Arms from URDF text to a robot and a cell that can be printed in: the results are free of
// collisions, away from singularities, and the same when written and read back.
#include "cells/arm_import.h"

#include "base/error.h"
#include "base/files.h"
#include "collision/cell_collision.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/temporary_folder.h"
#include "robot/resource_fixture.h"
#include "robot/urdf_arms.h"
#include "robot/urdf_text.h"

#include <gmock/gmock.h>

namespace voluta::cells {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class ArmImporting : public test::WithResources {
protected:
  void SetUp() override {
    WithResources::SetUp();
    process_ = process::loadProcess("fdm-1.0");
    setenv("VOLUTA_DATA", (folder_ / std::filesystem::path("data")).c_str(), 1);
  }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

  ArmImport import(const std::string& text, const robot::UrdfOptions& options = {},
                   robot::Mount nozzle = robot::Mount::Flange) {
    const std::filesystem::path urdf = folder_ / std::filesystem::path("arm.urdf");
    base::writeFile(urdf, text);
    return importArm(urdf, options, nozzle, process_, base::RunContext());
  }
  std::string complaint(const std::string& text, const robot::UrdfOptions& options = {}) {
    try {
      import(text, options);
    } catch (const base::Error& e) {
      return e.what();
    }
    return {};
  }
  // Clear at rest, by a margin, in the cell as it is read back from its file.
  void expectReady(const ArmImport& import, double upright = 0.9) {
    const std::filesystem::path data = folder_ / std::filesystem::path("data");
    writeImport(import, data, Existing::Replace);
    const robot::Cell cell = robot::loadCell(
        import.layout.cell.id, process_,
        std::vector<Eigen::Vector2d>{{-100, -100}, {100, -100}, {100, 100}, {-100, 100}});
    EXPECT_EQ(cell.robot().id, import.arm.model.id);
    EXPECT_EQ(cell.robot().neverMeet, import.arm.model.neverMeet);
    const collision::CellCollision bodies(cell, process_);
    std::vector<Eigen::Isometry3d> frames;
    cell.framePoses(cell.home(), frames);
    EXPECT_FALSE(bodies.bodies(frames, {kClearMm, kClearMm, 0.0}));
    EXPECT_GT(import.layout.rest.fromSingular, 0.05);
    if (cell.robot().kinematics->isFast()) {
      EXPECT_GT(robot::reachableBallRadius(cell, 0.0), 40.0);
    }
    EXPECT_GT(import.layout.score.share(0), upright);
    EXPECT_GT(import.layout.score.share(1), 0.6); // by 30 degrees
    const Eigen::Vector3d up = cell.work_T_tool(cell.home()).linear().col(2);
    EXPECT_LT((up + Eigen::Vector3d::UnitZ()).norm(), 0.01);
  }

  const test::TemporaryFolder folder_;
  process::Process process_;
};

TEST_F(ArmImporting, EveryKindOfArmIsReadyToPrint) {
  const struct {
    std::string text;
    robot::ArmKind kind;
  } cases[] = {{test::ur5Urdf(), robot::ArmKind::ParallelAxes},
               {test::urdfOf(test::irb1200()), robot::ArmKind::SphericalWrist},
               {test::urdfOf(test::kukaLike()), robot::ArmKind::SphericalWrist},
               {test::urdfOf(test::bentArm()), robot::ArmKind::BentWrist},
               {test::urdfOf(test::oddArm()), robot::ArmKind::Other}};
  for (const auto& one : cases) {
    const ArmImport import = this->import(one.text);
    SCOPED_TRACE(import.arm.model.id);
    EXPECT_EQ(import.kind, one.kind);
    EXPECT_THAT(import.layout.cell.id, HasSubstr("-moving"));
    expectReady(import);
  }
}

TEST_F(ArmImporting, PlatesOnTheArmGetALayoutToo) {
  const ArmImport import = this->import(test::urdfOf(test::kukaLike()),
                                        {.tip = {}, .base = {}, .id = "left"}, robot::Mount::World);
  EXPECT_EQ(import.layout.cell.id, "left-fixed");
  expectReady(import);
}

// Solids that overlap in every pose of the arm are left out, with a note on which.
TEST_F(ArmImporting, NamesLinksThatAreNotCheckedAgainstEachOther) {
  test::UrdfArm fat = test::irb1200();
  fat.links[0].front().radius = 0.2;
  fat.links[0].front().p1[2] = 0.4; // up to the shoulder's axis: into the upper arm
  const ArmImport import = this->import(test::urdfOf(fat));
  EXPECT_THAT(import.arm.model.assumed,
              Contains(HasSubstr("'base_link' and 'link_2' are not checked")));
  expectReady(import);
  EXPECT_THAT(this->import(test::urdfOf(test::irb1200())).arm.model.neverMeet,
              Not(Contains(std::pair(0, 3))));
}

TEST_F(ArmImporting, ArmsThatOnlyNearlyClearTheirBaseRest) {
  // The toy's upper arm passes its base at 2 mm: nearer than plans keep, at every pose.
  const ArmImport import = this->import(test::ur5Urdf());
  EXPECT_THAT(import.arm.model.assumed,
              Contains(HasSubstr("'base_link' and 'upper_arm' are not checked")));
}

TEST_F(ArmImporting, FlangesWhoseZLiesAcrossGetTheirNozzleAlongTheLastAxis) {
  // The last link itself: its x is the axis.
  const ArmImport import =
      this->import(test::urdfOf(test::irb1200()), {.tip = "link_6", .base = {}, .id = {}});
  EXPECT_THAT(import.arm.model.assumed, Contains(HasSubstr("flange's z does not lie along")));
  expectReady(import);
}

TEST_F(ArmImporting, TableRisesWithTheBaseOfTheArm) {
  const std::string plain = test::urdfOf(test::irb1200());
  std::string text = plain;
  const std::string base = "<link name=\"base_link\">";
  text.replace(text.find(base), base.size(),
               "<link name=\"world\"/><joint name=\"stand\" type=\"fixed\"><parent "
               "link=\"world\"/><child link=\"base_link\"/><origin xyz=\"0.2 -0.1 0.8\"/></joint>" +
                   base);
  const ArmImport high = import(text), low = import(plain);
  const Eigen::Vector3d up =
      high.layout.cell.platePose.translation() - low.layout.cell.platePose.translation();
  EXPECT_LT((up - Eigen::Vector3d(200, -100, 800)).norm(), 1e-6);
  expectReady(high);
}

TEST_F(ArmImporting, NamesInUseAreRefused) {
  EXPECT_THAT(complaint(test::ur5Urdf(), {.tip = {}, .base = {}, .id = "ur5"}),
              AllOf(HasSubstr("'ur5' is the name of a built-in"), HasSubstr("--id")));
  std::string text = test::ur5Urdf();
  text.replace(text.find("My UR5, left"), 12, "UR5");
  EXPECT_EQ(import(text).arm.model.id, "ur5-imported");
}

// The earlier cell may have measured frames and obstacles.
TEST_F(ArmImporting, AnEarlierImportIsKeptUnlessItMayBeReplaced) {
  const std::filesystem::path data = folder_ / std::filesystem::path("data");
  const ArmImport import = this->import(test::urdfOf(test::irb1200()));
  EXPECT_TRUE(conflictingFiles(import, data).empty());
  const ImportedFiles files = writeImport(import, data);
  base::writeFile(files.cell, "measured");
  EXPECT_EQ(conflictingFiles(import, data), (std::vector{files.robot, files.cell}));
  EXPECT_THROW(writeImport(import, data), base::Error);
  EXPECT_EQ(base::readFile(files.cell), "measured");
  writeImport(import, data, Existing::Replace);
  EXPECT_NE(base::readFile(files.cell), "measured");
}

TEST_F(ArmImporting, ArmsOfNoSizeAndOfMillimetresAreRefused) {
  test::UrdfArm large = test::irb1200();
  for (test::UrdfAxis& axis : large.axes) // in mm, where metres are meant
    for (std::size_t at = 0; (at = axis.xyz.find("0.", at)) != std::string::npos;)
      axis.xyz.erase(at, 2);
  EXPECT_THAT(complaint(test::urdfOf(large)), HasSubstr("lengths in a URDF are metres"));
  test::UrdfArm none = test::irb1200();
  for (test::UrdfAxis& axis : none.axes)
    axis.xyz = "0 0 0";
  EXPECT_THAT(complaint(test::urdfOf(none)), HasSubstr("implausible reach"));
}

TEST_F(ArmImporting, ArmWithoutSolidsAndMeshesIsImported) {
  const ArmImport import = this->import(test::urdfOf(test::kukaLike(), [](std::size_t i) {
    return "<visual><geometry><mesh filename=\"package://none/" + std::to_string(i) +
           ".dae\"/></geometry></visual>";
  }));
  EXPECT_THAT(import.arm.model.assumed, Contains(HasSubstr("link_3' is a capsule along it")));
  expectReady(import, 0.6); // fat links
}

} // namespace
} // namespace voluta::cells
