// Statements for a contact force whose direction depends on the cell.
#include "program/bead_words.h"
#include "program/press_words.h"

#include "base/error.h"
#include "plan/finding_kinds.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::program {
namespace {

class PressWords : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }

  static robot::Cell cellOf(const char* id, const process::Process& process) {
    platform::PlatformSolid plate;
    plate.polygon = {{-30, -30}, {30, -30}, {30, 30}, {-30, 30}};
    return robot::loadCell(id, process, plate);
  }
  // The statements of a process that comes with the program, for a cell.
  static process::Process glueIn(const char* cell) {
    process::Process glue = process::loadProcess("glue-3");
    fillPressWords(glue, cellOf(cell, glue));
    return glue;
  }
};

TEST_F(PressWords, ANozzleOnTheArmPressesAlongTheTool) {
  const process::Process glue = glueIn("ur5-moving");
  const robot::Cell cell = cellOf("ur5-moving", glue);
  ASSERT_EQ(cell.nozzleMount(), robot::Mount::Flange);
  EXPECT_EQ(glue.wordsFor("urscript")->start.front(),
            "force_mode(tool_pose(),[0,0,1,0,0,0],[0,0,5,0,0,0],2,[0.1,0.1,0.02,0.2,0.2,0.2])");
  const std::vector<std::string> melfa = {"M_FsCod0=0",
                                          "P_FsMod0=(0,0,1,0,0,0)(0,0)",
                                          "P_FsDmp0=(0,0,0.1,0,0,0)(0,0)",
                                          "P_FsGn0=(0,0,20,0,0,0)(0,0)",
                                          "P_FsFCd0=(0,0,5,0,0,0)(0,0)",
                                          "Fsc On,0,0,1"};
  EXPECT_EQ(glue.wordsFor("melfa")->start, melfa);
}

// The nozzle points down in the base: the arm presses the part upwards.
TEST_F(PressWords, BeforeAFixedNozzleTheArmPressesAgainstIt) {
  const process::Process glue = glueIn("ur5-fixed");
  const robot::Cell cell = cellOf("ur5-fixed", glue);
  ASSERT_EQ(cell.nozzleMount(), robot::Mount::World);
  ASSERT_LT(cell.base_T_fixed().linear().col(2).z(), -0.999);
  EXPECT_EQ(glue.wordsFor("melfa")->start[0], "M_FsCod0=1");
  EXPECT_EQ(glue.wordsFor("melfa")->start[4], "P_FsFCd0=(0,0,5,0,0,0)(0,0)");
  const std::string& urscript = glue.wordsFor("urscript")->start.front();
  // The frame of the nozzle, turned so that its z is from the part towards the nozzle.
  EXPECT_TRUE(urscript.starts_with("force_mode(p[0.5,0,0.5,")) << urscript;
}

TEST_F(PressWords, OtherBracesAreLeftAlone) {
  process::Process glue = process::loadProcess("glue-3");
  glue.beadWords = {{"krl", {"PTP {A1 5}", "$FORCE={X 0}"}, {}}};
  const auto before = glue.beadWords;
  fillPressWords(glue, cellOf("ur5-moving", glue));
  EXPECT_EQ(glue.beadWords, before);
  glue.beadWords = {{"melfa", {"P_FsFCd0=({press five})(0,0)"}, {}}};
  EXPECT_THROW(fillPressWords(glue, cellOf("ur5-moving", glue)), base::Error);
}

// A force is an option: formats without it print beads by position. Other statements are a demand.
TEST_F(PressWords, FormatsWithoutThemPrintBeadsWithoutForce) {
  process::Process glue = process::loadProcess("glue-3");
  const process::Tooling pressed(glue);
  EXPECT_NO_THROW(requireBeadWords("urscript", pressed));
  EXPECT_NO_THROW(requireBeadWords("rapid", pressed));
  EXPECT_FALSE(withoutForce("urscript", pressed));
  const auto finding = withoutForce("rapid", pressed);
  ASSERT_TRUE(finding);
  EXPECT_FALSE(finding->blocking);
  const std::string reason = plan::englishReason(*finding);
  EXPECT_NE(reason.find("rapid"), std::string::npos) << reason;
  EXPECT_NE(reason.find("glue-3"), std::string::npos) << reason;
  EXPECT_NO_THROW(requireBeadWords("rapid", process::Tooling(process::loadProcess("fdm-1.0"))));
  glue.beadWords = {{"krl", {"$OUT[1]=TRUE"}, {"$OUT[1]=FALSE"}}};
  const process::Tooling switched(glue);
  EXPECT_FALSE(withoutForce("rapid", switched));
  EXPECT_THROW(requireBeadWords("rapid", switched), base::Error);
}

} // namespace
} // namespace voluta::program
