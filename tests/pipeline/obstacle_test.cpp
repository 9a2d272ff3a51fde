// From an obstacle's file to a plan that keeps off it, or a finding that it is in the way.
#include "base/files.h"
#include "box_request.h"
#include "cells/obstacle_file.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/temporary_folder.h"
#include "plan/finding.h"
#include "plan/trajectory.h"
#include "replay/distances.h"
#include "robot/cell_draft.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr const char* kCell = "kr10-r1100-moving";

class Obstacle : public testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_DATA", (folder_ / "data").c_str(), 1); }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

  // The cell with the mesh as an obstacle, saved as a cell of one's own.
  std::string cellWith(const char* id, const geometry::TriangleMesh& mesh) {
    const std::filesystem::path file = folder_ / "obstacle.stl";
    base::writeFile(file, geometry::writeStl(mesh));
    const std::vector<robot::Shape> solids =
        cells::obstacleOfFile(file, 1.0, base::RunContext()).solids;
    const robot::CellDraft draft = robot::draftOfCell(kCell).named(id, id).withSolids(
        "obstacle", Isometry3d::Identity(), solids);
    std::filesystem::create_directories(folder_ / "data/cells");
    base::writeFile(folder_ / "data/cells" / (std::string(id) + ".json"), draft.text());
    return id;
  }

  static pipeline::PlanResult planned(const std::string& cell) {
    pipeline::PlanRequest request = test::boxRequest();
    request.item().loaded = test::loadedBox({-6, -6, 0}, {6, 6, 2.4});
    request.choices.item().mode = "flat";
    request.choices.cell = cell;
    request.choices.formats = {"krl"};
    return pipeline::planPart(request, base::RunContext());
  }

  // How near the cell's obstacle comes to the arm anywhere on the way: by the replay's distances,
  // not by those that the plan was made with.
  static double nearest(const robot::Cell& cell, const plan::Trajectory& t) {
    const auto obstacle = std::ranges::find(cell.bodies(), "obstacle", &robot::Body::name);
    base::require(obstacle != cell.bodies().end(), "a cell with the obstacle");
    double minimum = 1e9;
    std::vector<Isometry3d> frames;
    for (std::size_t i = 0; i < t.pointCount(); ++i) {
      cell.framePoses(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof), frames);
      for (const robot::Body& body : cell.bodies())
        if (body.role == robot::BodyRole::Link || body.role == robot::BodyRole::Holder ||
            body.role == robot::BodyRole::Head)
          for (const robot::Shape& a : body.shapes)
            for (const robot::Shape& b : obstacle->shapes)
              minimum = std::min(minimum, replay::distanceBetween(
                                              a, frames[static_cast<std::size_t>(body.frame)], b,
                                              frames[static_cast<std::size_t>(obstacle->frame)]));
    }
    return minimum;
  }

  test::TemporaryFolder folder_;
};

// A post of two boxes on the table between arm and plate: the arm would pass through it, and comes
// from the side.
TEST_F(Obstacle, FromAMeshesFileIsPassedBy) {
  geometry::TriangleMesh post = test::box({395, -20, -30}, {435, 20, 400});
  test::append(post, test::box({405, -12, 380}, {425, 12, 680}));
  const pipeline::PlanResult free = planned(kCell), around = planned(cellWith("posted", post));
  ASSERT_TRUE(around.cell);
  EXPECT_LE(nearest(*around.cell, *free.job.trajectory), 0.0) << "it stands in the way";
  EXPECT_GT(nearest(*around.cell, *around.job.trajectory), 0.0);
  const auto& report = around.job.report;
  EXPECT_EQ(report.motion.unreachable, 0u);
  EXPECT_EQ(report.motion.collisions, 0u);
  EXPECT_TRUE(report.replay.passed);
  EXPECT_EQ(report.replay.collisions, 0u);
}

bool names(const pipeline::PlanResult& result, const std::string& body) {
  return std::ranges::any_of(result.job.report.findings, [&](const plan::Finding& f) {
    return f.blocking && base::english(plan::factOf(f)).find(body) != std::string::npos;
  });
}

// A shelf over all of the plate is found before anything is planned.
TEST_F(Obstacle, FromAMeshesFileIsNamedWhereNothingCanBePrinted) {
  const pipeline::PlanResult result =
      planned(cellWith("covered", test::box({450, -150, 190}, {750, 150, 210})));
  EXPECT_EQ(result.job.reached, project::Stage::Load);
  EXPECT_FALSE(pipeline::nothingBlocks(result.job.report));
  EXPECT_TRUE(names(result, "obstacle"));
}

// A shelf over a side of the plate: nothing is printed below it, and it is named.
TEST_F(Obstacle, FromAMeshesFileIsNamedWhereItIsInTheWay) {
  const pipeline::PlanResult result =
      planned(cellWith("shelved", test::box({450, 20, 190}, {750, 150, 210})));
  EXPECT_GT(result.job.report.motion.collisions, 0u);
  EXPECT_FALSE(result.job.report.replay.passed);
  EXPECT_TRUE(names(result, "obstacle"));
}

} // namespace
