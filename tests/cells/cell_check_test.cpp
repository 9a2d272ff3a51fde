// A cell with one fault: exactly that fault is found. The shipped cells have none.
#include "cells/cell_check.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "robot/cell_draft.h"

#include <algorithm>
#include <cstdlib>
#include <gmock/gmock.h>

namespace voluta::cells {
namespace {

using robot::CellDraft;
using robot::DraftBody;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Eigen::Vector2d> square(double half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

class CellCheck : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }

  static robot::Cell read(const CellDraft& draft, double half = 60) {
    return robot::Cell::readText(draft.text(), draft.id() + ".json", process(), square(half));
  }
  static process::Process process() { return process::loadProcess("fdm-1.0"); }
  static std::vector<std::string> faults(const CellDraft& draft, double partKg = 0.0) {
    std::vector<std::string> reported;
    for (const CellFault& fault : cellFaults(read(draft), process(), partKg, {})) {
      reported.push_back(base::english(fault.what));
      EXPECT_FALSE(fault.remedy.empty());
    }
    return reported;
  }
  static DraftBody body(const CellDraft& draft, DraftBody::Kind kind) {
    const std::vector<DraftBody> bodies = draft.bodies();
    return *std::ranges::find(bodies, kind, &DraftBody::kind);
  }
};

TEST_F(CellCheck, theShippedCellsHaveNothingWrong) {
  for (const std::string& id : robot::cellIds()) {
    const CellDraft draft = robot::draftOfCell(id);
    if (id == "lathe") {
      platform::PlatformSolid rod;
      rod.rod = platform::straightRod(5, 200);
      const robot::Cell cell = robot::loadCell(id, process::loadProcess("fdm-0.35"), rod);
      EXPECT_TRUE(cellFaults(cell, process::loadProcess("fdm-0.35"), 0.0, {}).empty());
      continue;
    }
    EXPECT_THAT(faults(draft), ElementsAre()) << id;
  }
}

TEST_F(CellCheck, findsAPurgePlaceOutOfReach) {
  const auto faultsOf = [](const std::string& place) {
    std::string text = robot::draftOfCell("five-axis").text();
    text.insert(text.find('{') + 1, "\"purgeMm\": " + place + ",");
    const robot::Cell cell = robot::Cell::readText(text, "five-axis.json", process(), square(60));
    std::vector<std::string> faults;
    for (const CellFault& fault : cellFaults(cell, process(), 0.0, {}))
      faults.push_back(base::english(fault.what));
    return faults;
  };
  EXPECT_THAT(faultsOf("[-150, -120, 60]"), ElementsAre());
  EXPECT_THAT(faultsOf("[5000, 0, 60]"),
              ElementsAre("the arm does not reach the place for purges"));
  EXPECT_THAT(faultsOf("[0, 190, 30]"), ElementsAre("the arm collides at the place for purges"))
      << "within a stand";
}

// Each process family has a cell that carries its head, at rest clear of the part.
TEST_F(CellCheck, everyProcessHasACell) {
  for (const std::string& id : process::processIds()) {
    const process::Process p = process::loadProcess(id);
    const bool isSmall = p.head.sections.back().zMm <= 110.0;
    const robot::Cell cell = robot::loadCell(isSmall ? "irb2400-moving" : "irb6700-moving", p,
                                             square(isSmall ? 150 : 500));
    EXPECT_TRUE(cellFaults(cell, p, 0.0, {}).empty()) << id;
  }
}

TEST_F(CellCheck, aNozzleInsideTheArm) {
  const CellDraft fixed = robot::draftOfCell("ur5-fixed");
  DraftBody nozzle = body(fixed, DraftBody::Kind::Nozzle);
  nozzle.pose.translation() = Eigen::Vector3d(0, 0, 20); // in the base, which keeps its pose
  EXPECT_THAT(faults(fixed.withPose(nozzle, nozzle.pose)),
              ::testing::Contains(HasSubstr("the nozzle is inside base")));
  const CellDraft moving = robot::draftOfCell("ur5-moving");
  nozzle = body(moving, DraftBody::Kind::Nozzle);
  nozzle.pose.translation() = Eigen::Vector3d(0, 0, -10); // behind the flange
  EXPECT_THAT(faults(moving.withPose(nozzle, nozzle.pose)),
              ::testing::Contains(HasSubstr("the nozzle is inside")));
}

TEST_F(CellCheck, aPlateOutOfReach) {
  const CellDraft draft = robot::draftOfCell("ur5-moving");
  DraftBody plate = body(draft, DraftBody::Kind::Platform);
  plate.pose.translation() += Eigen::Vector3d(1500, 0, 0);
  EXPECT_THAT(faults(draft.withPose(plate, plate.pose)),
              ElementsAre("the plate is out of the arm's reach"));
}

TEST_F(CellCheck, aBoxOverThePlate) {
  const CellDraft draft = robot::draftOfCell("ur5-moving");
  Eigen::Isometry3d over = body(draft, DraftBody::Kind::Platform).pose;
  over.translation().z() += 100;
  // Wide enough to be in the way of the bodies that hold the nozzle, not of the arm at rest.
  const CellDraft boxed = draft.withBox("lid", over, {500, 500, 40});
  EXPECT_THAT(faults(boxed), ::testing::Contains(HasSubstr("lid")));
}

TEST_F(CellCheck, aLoadBeyondTheRobots) {
  const CellDraft draft = robot::draftOfCell("ur5-fixed");
  EXPECT_THAT(faults(draft, 4.4), ElementsAre());
  EXPECT_THAT(faults(draft, 4.6), ElementsAre("payload 5.1 kg exceeds the robot's rating of 5 kg"));
  EXPECT_THAT(faults(draft.withCarriedKg(5.5)),
              ElementsAre("payload 5.5 kg exceeds the robot's rating of 5 kg"));
  // With the nozzle on the flange the part is on the table.
  EXPECT_THAT(faults(robot::draftOfCell("ur5-moving"), 100.0), ElementsAre());
}

TEST_F(CellCheck, findsAHeadThatIsUpsideDown) {
  const robot::Cell cell = read(robot::draftOfCell("ur5-moving"));
  process::Process turned = process();
  turned.head = {{{0.0, 22.0}, {60.0, 22.0}, {60.0, 0.5}, {70.0, 0.5}}};
  const std::vector<CellFault> all = cellFaults(cell, turned, 0.0, {});
  ASSERT_FALSE(all.empty());
  EXPECT_THAT(base::english(all.front().what), HasSubstr("44 mm wide at its tip and 1 mm"));
  EXPECT_EQ(base::english(all.front().remedy), "turn the head of process fdm-1.0 over");
}

TEST_F(CellCheck, theClearestRestIsClear) {
  const CellDraft draft = robot::draftOfCell("ur5-moving");
  const robot::Cell cell = read(draft);
  const auto rest = clearestRest(cell, process());
  ASSERT_TRUE(rest);
  EXPECT_THAT(faults(draft.withHome(rest->head(cell.armDof()), cell.limits())), ElementsAre());
  const Eigen::Isometry3d work_T_tool = cell.work_T_tool(*rest);
  EXPECT_LT((work_T_tool.translation().head<2>()).norm(), 1e-6);
  EXPECT_GE(work_T_tool.translation().z(), 19.0);
}

} // namespace
} // namespace voluta::cells
