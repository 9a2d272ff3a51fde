// Cells edited as files: an edit changes its own values and nothing else.
#include "robot/cell_draft.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "process/process.h"
#include "resource_fixture.h"

#include <algorithm>
#include <fstream>
#include <gmock/gmock.h>

namespace voluta::robot {
namespace {

using Kind = DraftBody::Kind;

class Drafts : public test::WithResources {
protected:
  static Cell read(const CellDraft& draft) {
    return Cell::readText(draft.text(), draft.id() + ".json", process::loadProcess("fdm-1.0"),
                          {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}});
  }
  static DraftBody body(const CellDraft& draft, Kind kind) {
    const std::vector<DraftBody> bodies = draft.bodies();
    return *std::ranges::find(bodies, kind, &DraftBody::kind);
  }
  static Eigen::Isometry3d someRotation() {
    Eigen::Isometry3d pose(Eigen::Translation3d(11, -7, 23));
    pose.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()));
    return pose;
  }
};

TEST_F(Drafts, everyBodyOfEveryCellMovesWhereItIsPut) {
  for (const std::string& id : cellIds()) {
    const CellDraft draft = draftOfCell(id);
    const std::vector<DraftBody> bodies = draft.bodies();
    for (const DraftBody& body : bodies) {
      const CellDraft same = draft.withPose(body, body.pose);
      const CellDraft moved = draft.withPose(body, someRotation() * body.pose);
      for (const DraftBody& after : moved.bodies()) {
        const auto before = std::ranges::find_if(
            bodies, [&](const DraftBody& other) { return other.sameAs(after); });
        const Eigen::Isometry3d expected =
            after.sameAs(body) ? someRotation() * body.pose : before->pose;
        // Frusta and capsules have a place and no turn of their own.
        EXPECT_LT((after.pose.translation() - expected.translation()).norm(), 1e-9) << id;
        if (body.kind != Kind::Obstacle || body.sizeMm) {
          EXPECT_TRUE(after.pose.isApprox(expected, 1e-9)) << id;
        }
        EXPECT_EQ(after.sizeMm.has_value(), before->sizeMm.has_value());
      }
      const auto unmoved = same.bodies();
      for (std::size_t i = 0; i < unmoved.size(); ++i)
        EXPECT_TRUE(unmoved[i].pose.isApprox(bodies[i].pose, 1e-12));
    }
  }
}

TEST_F(Drafts, aMovedPlateIsTheCellsWorkFrame) {
  const CellDraft draft = draftOfCell("ur5-moving");
  DraftBody plate = body(draft, Kind::Platform);
  EXPECT_FALSE(plate.onFlange);
  EXPECT_TRUE(body(draft, Kind::Nozzle).onFlange);
  const Eigen::Isometry3d there = someRotation() * plate.pose;
  EXPECT_TRUE(read(draft.withPose(plate, there)).base_T_fixed().isApprox(there, 1e-9));
}

TEST_F(Drafts, boxesAreAddedAndRemovedWithTheirPairs) {
  const CellDraft draft = draftOfCell("ur5-fixed");
  const std::size_t before = read(draft).bodies().size();
  const CellDraft one = draft.withBox("post", someRotation(), {10, 20, 30});
  const CellDraft two = one.withBox("post", someRotation(), {10, 20, 30});
  ASSERT_EQ(read(two).bodies().size(), before + 2);
  EXPECT_EQ(read(two).bodies().back().name, "post 2");
  const Box box = std::get<Box>(read(one).bodies().back().shapes.front());
  EXPECT_EQ(2.0 * box.half, Eigen::Vector3d(10, 20, 30));
  EXPECT_TRUE(box.frame_T_box.isApprox(someRotation(), 1e-9));
  const DraftBody post = one.bodies().back();
  EXPECT_EQ(*one.withSize(post, {5, 6, 7}).bodies().back().sizeMm, Eigen::Vector3d(5, 6, 7));
  EXPECT_EQ(read(one.without(post)).bodies().size(), before);
  // The table is named among pairs that never meet: they go with it.
  const CellDraft bare = draft.without(body(draft, Kind::Obstacle));
  EXPECT_EQ(read(bare).bodies().size(), before - 1);
  // A name that the arm has is not taken a second time.
  EXPECT_EQ(draft.withBox("forearm", someRotation(), {1, 1, 1}).bodies().back().name, "forearm 2");
}

TEST_F(Drafts, thePlaceForPurgesIsAddedMovedAndTakenAway) {
  const CellDraft draft = draftOfCell("ur5-moving");
  ASSERT_FALSE(read(draft).purgePlaceMm());
  EXPECT_TRUE(std::ranges::none_of(
      draft.bodies(), [](const DraftBody& body) { return body.kind == Kind::PurgePlace; }));
  const CellDraft added = draft.withPurgePlace({400, -150, 25});
  EXPECT_EQ(*read(added).purgePlaceMm(), Eigen::Vector3d(400, -150, 25));
  const DraftBody place = body(added, Kind::PurgePlace);
  EXPECT_EQ(place.pose.translation(), Eigen::Vector3d(400, -150, 25));
  EXPECT_FALSE(place.onFlange);
  const CellDraft moved = added.withPose(place, someRotation());
  EXPECT_EQ(*read(moved).purgePlaceMm(), someRotation().translation());
  EXPECT_TRUE(body(moved, Kind::PurgePlace).pose.linear().isIdentity());
  // Without it the file is as before, except for its layout.
  EXPECT_EQ(moved.without(place), draft.named(draft.id(), draft.label()));
  std::string text = added.text();
  text.replace(text.find("-150"), 4, "true");
  EXPECT_THROW(CellDraft{text}, base::Error);
}

// Solids with a frame of their own: it moves, and they go with it.
TEST_F(Drafts, solidsFromAFileAreInTheirFrame) {
  const std::vector<Shape> solids{Frustum{{0, 0, 0}, {0, 0, 200}, 15, 15},
                                  Capsule{{0, 0, 200}, {80, 0, 200}, 12},
                                  Box{someRotation(), {5, 6, 7}}};
  const Eigen::Isometry3d there = someRotation() * someRotation();
  const CellDraft draft = draftOfCell("ur5-fixed").withSolids("stand", someRotation(), solids);
  const DraftBody stand = draft.bodies().back();
  EXPECT_EQ(stand.name, "stand");
  EXPECT_TRUE(stand.pose.isApprox(someRotation(), 1e-9));
  EXPECT_FALSE(stand.sizeMm);
  for (const auto& [cell, pose] : {std::pair(read(draft), someRotation()),
                                   std::pair(read(draft.withPose(stand, there)), there)}) {
    const Body& body = cell.bodies().back();
    ASSERT_EQ(body.shapes.size(), 3u);
    EXPECT_TRUE(std::get<Frustum>(body.shapes[0]).p1.isApprox(pose * Eigen::Vector3d(0, 0, 200)));
    EXPECT_EQ(std::get<Frustum>(body.shapes[0]).r1, 15.0);
    EXPECT_TRUE(std::get<Capsule>(body.shapes[1]).p1.isApprox(pose * Eigen::Vector3d(80, 0, 200)));
    EXPECT_TRUE(std::get<Box>(body.shapes[2]).frame_T_box.isApprox(pose * someRotation(), 1e-9));
  }
  // One box in such a frame has no edges of the obstacle's own, and moves all the same.
  const CellDraft one = draft.withSolids("crate", someRotation(), {Box{someRotation(), {5, 6, 7}}});
  const DraftBody crate = one.bodies().back();
  EXPECT_FALSE(crate.sizeMm);
  EXPECT_TRUE(one.withPose(crate, there).bodies().back().pose.isApprox(there, 1e-9));
}

TEST_F(Drafts, anotherRobotFitsIntoTheSameCell) {
  for (const char* id : {"ur5-fixed", "irb1200-irbp", "t3"})
    for (const std::string& robot : robotIds()) {
      const RobotModel model = loadRobot(robot);
      const Cell cell = read(draftOfCell(id).withRobot(model));
      EXPECT_EQ(cell.robot().id, robot);
      for (int i = 0; i < cell.armDof(); ++i) {
        EXPECT_GE(cell.home()[i], model.limits[static_cast<std::size_t>(i)].min);
        EXPECT_LE(cell.home()[i], model.limits[static_cast<std::size_t>(i)].max);
      }
    }
}

TEST_F(Drafts, carriedMassAndExtruderAreEdited) {
  const CellDraft draft = draftOfCell("ur5-fixed");
  EXPECT_FALSE(draft.carriedKg());
  EXPECT_TRUE(read(draft).carriedIsAssumed());
  EXPECT_EQ(read(draft).carriedKg(), 0.5);
  EXPECT_EQ(read(draft.withCarriedKg(1.25)).carriedKg(), 1.25);
  EXPECT_FALSE(read(draft.withCarriedKg(1.25)).carriedIsAssumed());
  EXPECT_EQ(draft.extruder(), "outputs");
  EXPECT_EQ(read(draft.withExtruder("e-stream")).extruder(), "e-stream");
}

class OwnCells : public Drafts {
protected:
  void SetUp() override {
    Drafts::SetUp();
    setenv("VOLUTA_DATA", folder_.path().c_str(), 1);
  }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }
  test::TemporaryFolder folder_;
};

TEST_F(OwnCells, areSavedWholeAndLoadedByTheirName) {
  const CellDraft own = draftOfCell("ur5-fixed").named("my-cell", "Mine");
  const std::filesystem::path file = saveOwnCell(own);
  EXPECT_EQ(base::readFile(file), own.text());
  EXPECT_THAT(cellIds(), ::testing::Contains("my-cell"));
  EXPECT_EQ(draftOfCell("my-cell"), own);
  const Cell cell = loadCell("my-cell", process::loadProcess("fdm-1.0"),
                             {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}});
  EXPECT_EQ(cell.label(), "Mine");
  // Nothing is left beside it.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()),
                          std::filesystem::directory_iterator()),
            1);
}

TEST_F(OwnCells, takeNoNameOfTheProgramsOwnAndNoPath) {
  for (const char* id : {"ur5-fixed", "", "../up", "a/b", ".hidden", "a b"})
    EXPECT_THROW(saveOwnCell(draftOfCell("ur5-fixed").named(id, "x")), base::Error) << id;
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "cells"));
}

TEST_F(OwnCells, thatCannotBeWrittenGiveAnError) {
  std::ofstream(folder_.path() / "cells") << "a file where the folder should be";
  try {
    saveOwnCell(draftOfCell("ur5-fixed").named("mine", "x"));
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::CannotWrite);
  }
}

TEST_F(Drafts, invalidCellsAreRefused) {
  EXPECT_THROW(CellDraft("no json"), base::Error);
  EXPECT_THROW(CellDraft("[]"), base::Error);
  EXPECT_THROW(CellDraft("{}"), base::Error);
  std::string text = draftOfCell("ur5-fixed").text();
  text.replace(text.find("\"xyzMm\""), 7, "\"xyz\"");
  EXPECT_THROW(CellDraft{text}, base::Error);
}

} // namespace
} // namespace voluta::robot
