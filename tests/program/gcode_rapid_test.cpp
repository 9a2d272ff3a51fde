// A RAPID module that reads extended G-code on the controller: run here on its input, by as much of
// RAPID as it has, and compared with the reader of that G-code.
#include "program_fixture.h"

#include "base/error.h"
#include "base/sha256.h"
#include "program/dialect.h"
#include "program/gcode/gcode_rapid.h"
#include "program/gcode/gcode_rapid_text.h"
#include "program/makers_grammars.h"
#include "program/rapid_interpreter.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace voluta::program {
namespace {

class GcodeRapid : public test::Programs {
protected:
  plan::Program program(bool abb = false, std::size_t points = 300) {
    trajectory_ = {};
    plan_ = {};
    if (abb) {
      std::string json = test::kCellJson;
      json.replace(json.find("\"ur5\""), 5, "\"irb1200\"");
      const test::TemporaryFolder folder;
      base::writeFile(folder / "bench.json", json);
      cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                      {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
    }
    appendRandom(9, points);
    return writeProgram("gcode-extended", withRunner());
  }
  ProgramInput withRunner() const {
    ProgramInput in = input();
    in.options.own["gcodeRunner"] = std::string("rapid");
    return in;
  }
  plan::ReadProgram read(const plan::Program& p) const {
    return readProgram(p.format, p.files, process::Tooling(process_));
  }
};

TEST_F(GcodeRapid, ModuleIsWrittenOnlyIfTheOptionIsSet) {
  const plan::Program p = program();
  ASSERT_EQ(p.files.size(), 2u);
  EXPECT_EQ(p.files[1].name, "part_1_gcode.mod");
  EXPECT_EQ(continuationFiles(findDialect("gcode-extended"), p.files[0].text),
            std::vector<std::string>{p.files[1].name});
  EXPECT_EQ(writeProgram("gcode-extended", input()).files.size(), 1u);
  const plan::ReadProgram back = read(p);
  for (const auto& d : back.defects)
    ADD_FAILURE() << d.file << ":" << d.line << ": " << base::english(d.reason);
  EXPECT_TRUE(back.complete);
}

// Its module stops at the first word that it does not know, with the part half printed.
TEST_F(GcodeRapid, RefusesEventsThatItsModuleDoesNotKnow) {
  program();
  for (const plan::TrajectoryEvent& event :
       {plan::TrajectoryEvent{.kind = plan::EventKind::Pause, .text = "Put in the nut"},
        plan::TrajectoryEvent{.kind = plan::EventKind::Wait, .seconds = 60.0},
        plan::TrajectoryEvent{.kind = plan::EventKind::Output, .tool = 3, .on = true},
        plan::TrajectoryEvent{
            .kind = plan::EventKind::Statement, .text = "M300", .format = "gcode-extended"}}) {
    trajectory_.events = {event};
    trajectory_.events[0].point = 5;
    EXPECT_NO_THROW(writeProgram("gcode-extended", input()));
    try {
      writeProgram("gcode-extended", withRunner());
      ADD_FAILURE() << "written";
    } catch (const base::Error& error) {
      EXPECT_NE(base::english(error.whole()).find("has no commands for stops"), std::string::npos);
    }
  }
}

// The reader compares the common part line by line: a change makes every written module foreign.
TEST_F(GcodeRapid, TheCommonPartStaysAsItIs) {
  EXPECT_EQ(base::sha256(rapidGcodeSame()),
            "900fc7aa4e53c865cfcc42fe5d4ef579d2615f3af9e2be95b6ddb1edd0893776");
}

TEST_F(GcodeRapid, IsRapid) {
  for (const bool abb : {false, true}) {
    const plan::Program p = program(abb);
    EXPECT_EQ(test::wrongRapidLine(p.files[1].text), 0u);
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"ENDWHILE", "ENDWHLE"},
                                   {"bMore:=StrLen", "bMore=StrLen"},
                                   {" THEN\r\n", "\r\n"},
                                   {"Close dFile;", "Close dFile"},
                                   {"NOrient([", "NOrient("}}) {
      std::string bad = p.files[1].text;
      bad.replace(bad.find(from), from.size(), to);
      EXPECT_NE(test::wrongRapidLine(bad), 0u) << from;
    }
  }
}

// Motion for motion the same places, directions, speeds and material.
TEST_F(GcodeRapid, MovesLikeTheGcode) {
  for (const bool abb : {false, true}) {
    const plan::Program p = program(abb);
    const plan::ReadProgram back = read(p);
    test::RapidInterpreter controller(p.files[1].text, p.files[0].text);
    controller.run();
    EXPECT_EQ(controller.refused, "");
    EXPECT_EQ(controller.opened, p.files[0].name);
    EXPECT_TRUE(controller.closed && !controller.on && controller.flow == 0.0);
    ASSERT_EQ(controller.motions.size(), back.motions.size() + 1);
    EXPECT_EQ(controller.motions.front().word, abb ? "MoveAbsJ" : "MoveJ");
    double deposited = 0.0, wanted = 0.0;
    for (std::size_t i = 0; i < back.motions.size(); ++i) {
      SCOPED_TRACE(i);
      const plan::ProgramMotion& m = back.motions[i];
      const test::RapidMotion& a = controller.motions[i + 1];
      EXPECT_LT((a.position - m.position).norm(), 1e-9);
      EXPECT_LT((a.rotation * Eigen::Vector3d::UnitZ() + m.direction).norm(), 2e-6);
      EXPECT_EQ(a.on, m.extruding);
      if (i > 0) {
        // More than the full flow slows the motion.
        EXPECT_LE(a.speed, m.speedMmPerS * (1.0 + 1e-9));
        if (!m.extruding) {
          EXPECT_NEAR(a.speed, m.speedMmPerS, 1e-9);
        }
        const double seconds = (m.position - back.motions[i - 1].position).norm() / a.speed;
        if (m.extruding) {
          EXPECT_NEAR(a.flow * process_.maxFlowMm3PerS * seconds, m.volumeMm3, 0.021 * m.volumeMm3);
          deposited += a.flow * process_.maxFlowMm3PerS * seconds;
          wanted += m.volumeMm3;
        }
      }
      // Beads go on; they begin and end with a stop.
      const bool continues =
          i + 1 < back.motions.size() && m.extruding == back.motions[i + 1].extruding;
      EXPECT_EQ(a.zoneMm > 0.0, continues);
    }
    EXPECT_NEAR(deposited, wanted, 0.01 * wanted);
    double pushed = 0.0, primed = 0.0;
    for (const auto& [seconds, flow] : controller.waits)
      pushed += seconds * flow * process_.maxFlowMm3PerS;
    for (const plan::ProgramPause& pause : back.pauses)
      primed += pause.volumeMm3;
    EXPECT_GT(primed, 1.0);
    EXPECT_NEAR(pushed, primed, 1e-3 * primed);
  }
}

// The start turn is the plan's; each motion's is the shortest from there.
TEST_F(GcodeRapid, TurnsFromTheToolsStartOrientation) {
  const plan::Program p = program();
  test::RapidInterpreter controller(p.files[1].text, p.files[0].text);
  controller.run();
  const Eigen::Quaterniond start = controller.motions.front().rotation;
  for (const test::RapidMotion& m : controller.motions) {
    const Eigen::Quaterniond shortest =
        Eigen::Quaterniond::FromTwoVectors(start * Eigen::Vector3d::UnitZ(),
                                           m.rotation * Eigen::Vector3d::UnitZ()) *
        start;
    EXPECT_LT(shortest.angularDistance(m.rotation), 1e-6);
  }
}

TEST_F(GcodeRapid, StopsAtUnknownWords) {
  const plan::Program p = program();
  for (const char* line : {"G2 X1 Y2 I3", "M600", "G1 X1 Q3", "G1 Xabc", "G91"}) {
    std::string gcode = p.files[0].text;
    const std::size_t at = gcode.find("\nG1 X") + 1;
    gcode.insert(at, std::string(line) + "\n");
    test::RapidInterpreter controller(p.files[1].text, gcode);
    controller.run();
    EXPECT_NE(controller.refused, "") << line;
    EXPECT_FALSE(controller.on);
  }
}

TEST_F(GcodeRapid, AnotherModuleIsRefusedAtItsLine) {
  const plan::Program p = program();
  std::vector<std::string> lines;
  std::istringstream in(p.files[1].text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  for (std::size_t l = 0; l < lines.size(); ++l) {
    if (lines[l].find("!") < 4 || lines[l] == "\r" || l == 0)
      continue;
    plan::Program other = p;
    other.files[1].text.clear();
    for (std::size_t k = 0; k < lines.size(); ++k)
      if (k != l)
        other.files[1].text += lines[k] + "\n";
    const plan::ReadProgram back = read(other);
    const bool reported = !back.defects.empty();
    const bool own = lines[l].find("CONST string") != std::string::npos ||
                     lines[l].find("CONST num nFull") != std::string::npos ||
                     lines[l].find("CONST bool") != std::string::npos ||
                     lines[l].find("CONST jointtarget") != std::string::npos;
    EXPECT_TRUE(reported) << lines[l];
    if (reported && !own) {
      EXPECT_EQ(back.defects[0].file, 1u);
    }
  }
}

TEST_F(GcodeRapid, CannotTurnARod) {
  useRod();
  appendRandomOnRod(3, 50);
  EXPECT_THROW(writeProgram("gcode-extended", withRunner()), base::Error);
  EXPECT_NO_THROW(writeProgram("gcode-extended", input()));
}

} // namespace
} // namespace voluta::program
