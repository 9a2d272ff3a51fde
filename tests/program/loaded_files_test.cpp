// Files that a controller loads: files for its kind, of a size that it takes, and as people and
// editors leave them.
#include "program_fixture.h"

#include "program/common/motion_targets.h"
#include "program/common/walk.h"
#include "program/rapid/rapid.h"
#include "program/urscript/urscript.h"

#include <gtest/gtest.h>

namespace voluta::program {
namespace {

class LoadedFiles : public test::Programs {
protected:
  // The nozzle moves up and down along its own axis between beads, by `lifts` in turn.
  void appendBeads(const std::vector<double>& lifts, int points) {
    robot::JointVector q(6);
    q << 0.1, -1.9, 1.7, -1.2, -1.4, 0.3;
    const Eigen::Isometry3d start = cell_->work_T_tool(q);
    const auto at = [&](double alongMm, double upMm) {
      Eigen::Isometry3d pose = start;
      pose.translation() +=
          start.linear() * Eigen::Vector3d(alongMm, 0.0, -upMm); // the tool's z points down
      std::vector<robot::JointVector> solutions;
      cell_->inverse(pose, q, solutions);
      EXPECT_FALSE(solutions.empty());
      q = *std::ranges::min_element(
          solutions, {}, [&](const robot::JointVector& s) { return (s - q).squaredNorm(); });
      return std::vector<double>(q.data(), q.data() + 6);
    };
    append(plan::MoveKind::Joint, at(0, 0), 1.0, 0.0);
    std::size_t waypoint = 0;
    for (const double lift : lifts) {
      for (int i = 1; i <= points; ++i) {
        append(plan::MoveKind::Print, at(0.5 * i, 0), 0.05, 0.4);
        noteWaypoint(waypoint++, i == 1, 0);
      }
      append(plan::MoveKind::Linear, at(0.5 * points, lift), 0.1, 0.0);
      append(plan::MoveKind::Linear, at(0.0, lift), 0.1, 0.0);
      append(plan::MoveKind::Linear, at(0.0, 0), 0.1, 0.0);
    }
    plan_.position.assign(waypoint, Eigen::Vector3d::Zero());
    plan_.direction.assign(waypoint, Eigen::Vector3d::UnitZ());
  }
};

// An editor that leaves the last line without its end has changed nothing.
TEST_F(LoadedFiles, TheLastLineMayHaveNoEnd) {
  for (const Dialect& d : dialects()) {
    SCOPED_TRACE(d.id);
    randomFor(d, 2, 200);
    plan::Program program = writeProgram(d.id, input());
    const plan::ReadProgram whole = readProgram(d.id, program.files, process::Tooling(process_));
    EXPECT_TRUE(whole.complete);
    for (plan::ProgramFile& file : program.files)
      if (!d.isBinary || !d.isBinary(file.text))
        file.text.erase(file.text.find_last_not_of("\r\n") + 1);
    const plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process_));
    for (const plan::ProgramDefect& defect : back.defects)
      ADD_FAILURE() << defect.file << ":" << defect.line << ": " << base::english(defect.reason);
    EXPECT_TRUE(back.complete);
    EXPECT_EQ(back.motions.size(), whole.motions.size());
  }
}

// As tools that save bytes write it. E ends a number: no controller takes an exponent.
TEST_F(LoadedFiles, GcodeNeedsNoBlanks) {
  for (const char* format : {"gcode-extended", "gcode", "gcode-bc"}) {
    SCOPED_TRACE(format);
    randomFor(findDialect(format), 2, 200);
    const plan::Program program = writeProgram(format, input());
    std::string text;
    std::istringstream lines(program.files[0].text);
    for (std::string line; std::getline(lines, line); text += line + '\n')
      if (line.starts_with("G"))
        std::erase(line, ' ');
    ASSERT_NE(text.find("G1X"), std::string::npos);
    EXPECT_EQ(detectDialect("part", text)->id, format);
    const plan::ReadProgram whole = readProgram(format, program.files, process::Tooling(process_)),
                            back =
                                readProgram(format, {{"part", text}}, process::Tooling(process_));
    for (const plan::ProgramDefect& defect : back.defects)
      ADD_FAILURE() << defect.line << ": " << base::english(defect.reason);
    ASSERT_EQ(back.motions.size(), whole.motions.size());
    for (std::size_t m = 0; m < back.motions.size(); ++m) {
      EXPECT_EQ(back.motions[m].position, whole.motions[m].position);
      EXPECT_EQ(back.motions[m].volumeMm3, whole.motions[m].volumeMm3);
    }
  }
}

// Both makers' files end in .prg.
TEST_F(LoadedFiles, EpsonAndMitsubishiAreDetectedByTheirWords) {
  for (const char* text :
       {"#include \"points.inc\"\r\n\r\nFunction main\r\n  Motor On\r\n  Go P1\r\nFend\r\n",
        "' moves\r\n#define SPEED 20\r\n#ifdef TEST\r\n#endif\r\nGlobal Integer count\r\nReal x, "
        "y\r\nFunction print_part\r\nFend\r\n",
        "#include \"a.inc\"\nGlobal Preserve String name$\nFunction main()\nFend\n"})
    EXPECT_EQ(detectDialect("part.prg", text)->id, "spel") << text;
  for (const char* text : {"1 Mov P1\r\n2 End\r\n", "#Include \"a\"\r\nOvrd 50\r\nMvs P1\r\n"})
    EXPECT_EQ(detectDialect("part.prg", text)->id, "melfa") << text;
}

// The robot's file names its controller; the user may choose another.
TEST_F(LoadedFiles, AnOmniCoreGetsItsOwnModulesAndSignals) {
  platform::PlatformSolid plate;
  plate.polygon = {{-100, -100}, {100, -100}, {100, 100}, {-100, 100}};
  for (const auto& [cell, omniCore] :
       {std::pair{"crb15000-moving", true}, {"irb1200-moving", false}}) {
    cell_.emplace(robot::loadCell(cell, process_, plate));
    trajectory_ = {};
    plan_ = {};
    append(plan::MoveKind::Joint, {0.1, 0.2, 0.3, 0.1, 1.2, 0.3}, 1.0, 0.0);
    append(plan::MoveKind::Print, {0.1, 0.21, 0.3, 0.1, 1.2, 0.3}, 1.0, 1.0);
    for (const char* chosen : {"robot", "mod", "modx"}) {
      ProgramInput in = input();
      in.options.own["rapidModules"] = std::string(chosen);
      const bool wanted =
          chosen == std::string_view("robot") ? omniCore : chosen == std::string_view("modx");
      const plan::Program program = writeProgram("rapid", in);
      EXPECT_EQ(program.files[0].name, wanted ? "part_1.modx" : "part_1.mod");
      EXPECT_TRUE(
          program.files[1].text.starts_with(wanted ? "EIO:CFG_1.0:7:0::" : "EIO:CFG_1.0:6:1::"));
      const plan::ReadProgram back =
          readProgram("rapid", program.files, process::Tooling(process_));
      EXPECT_TRUE(back.complete && back.defects.empty());
    }
  }
}

// Without a word from the user, on both roads.
TEST_F(LoadedFiles, ALongUrscriptProgramIsSplit) {
  appendRandom(9, 2 * kMotionsPerScript + 100);
  for (const char* form : {"node", "port"}) {
    SCOPED_TRACE(form);
    ProgramInput in = input();
    in.options.own["urscriptForm"] = std::string(form);
    const plan::Program program = writeProgram("urscript", in);
    ASSERT_EQ(program.files.size(), form == std::string_view("node") ? 4u : 3u);
    const plan::ReadProgram back =
        readProgram("urscript", program.files, process::Tooling(process_));
    EXPECT_TRUE(back.complete && back.defects.empty());
    EXPECT_EQ(back.motions.size(), trajectory_.pointCount());
    std::vector<std::size_t> motions(program.files.size(), 0);
    for (const plan::ProgramMotion& m : back.motions)
      ++motions[m.file];
    for (const std::size_t count : motions)
      EXPECT_LE(count, kMotionsPerScript + kMotionsPerScript / 10);
  }
}

// While the next file is loaded the nozzle is clear of the part, as high as in a travel.
TEST_F(LoadedFiles, FilesAreCutWhereTheNozzleIsHigh) {
  appendBeads({2, 2, 12, 2, 2, 2, 12, 2, 2, 2, 2, 12, 2}, 20);
  const std::vector<std::size_t> cuts = cutsOf(input(), 120);
  ASSERT_EQ(cuts.size(), 5u);
  for (std::size_t k = 1; k + 1 < cuts.size(); ++k) {
    EXPECT_TRUE(standsClear(trajectory_, cuts[k]));
    const auto tip = [&](std::size_t i) {
      return targetOf(*cell_, Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), 6)).tipMm;
    };
    std::size_t bead = cuts[k] - 1;
    while (trajectory_.move[bead] != plan::MoveKind::Print)
      --bead;
    EXPECT_GE((tip(cuts[k] - 1) - tip(bead)).norm(), kClearMm);
  }
  // Where all lifts are equal the file is as long as it may be.
  trajectory_ = {};
  plan_ = {};
  appendBeads(std::vector<double>(13, 2.0), 20);
  const std::vector<std::size_t> alike = cutsOf(input(), 120);
  ASSERT_EQ(alike.size(), 4u);
  EXPECT_GT(alike[1], 97u);
  EXPECT_LE(alike[1], 120u);
}

// C keeps within a turn or two without a word from the user, by the table itself or by its count.
TEST_F(LoadedFiles, CKeepsWithinItsRangeByDefault) {
  appendTurning(1, 15);
  for (const char* unwind : {"", "wind", "count"}) {
    ProgramInput in = input();
    if (*unwind)
      in.options.own["tableUnwind"] = std::string(unwind);
    const std::string text = writeProgram("gcode-bc", in).files[0].text;
    double maximum = 0.0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      if (const std::size_t at = line.find(" C"); line.starts_with("G") && at != std::string::npos)
        maximum = std::max(maximum, std::abs(std::stod(line.substr(at + 2))));
    // A bead of this plan turns by up to a turn and a half, and no travel is within it.
    EXPECT_LE(maximum, 360.0 * 3.0) << unwind;
    EXPECT_EQ(text.find("G92 C") != std::string::npos, *unwind == 'c') << unwind;
  }
}

} // namespace
} // namespace voluta::program
