// Invariants of every row of the extruders, over all dialects that have words for it.
#include "read_programs.h"

#include "base/error.h"
#include "process/bead_model.h"
#include "program/common/motion_targets.h"
#include "program/common/tcp_motions.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "program/filament.h"
#include "program/gcode/castelli_serial.h"
#include "program/gcode/extruder_axis.h"
#include "program/stream/extruder_stream.h"

#include <algorithm>
#include <regex>
#include <set>

namespace voluta::program {
namespace {

// Castelli 2020, 2.1.4: 3 mm filament, 1674.18 steps/mm, a strand of 0.1514 mm2; half the period is
// 1e6 / (2 * 1674.18 * 0.1514 * 10 / (pi/4 * 9)) = 1394.4 us.
TEST(CastelliSerial, writesFlowsOfTheTable) {
  EXPECT_EQ(castelliFlowText(0.1514 * 10.0), "G1394n");
  EXPECT_EQ(castelliFlowText(-0.1514 * 10.0), "G-1394n");
  EXPECT_EQ(castelliFlowText(0.0), "G0n");
  EXPECT_NEAR(castelliFlowMm3PerS(1394), 1.514, 1e-3);
  EXPECT_DOUBLE_EQ(castelliWritten(castelliFlowMm3PerS(131)), castelliFlowMm3PerS(131));
}

TEST(CastelliSerial, readsItsTextsAndNoOthers) {
  const auto read = [](std::string_view text) {
    const auto c = readCastelli(text);
    return c ? std::string(1, c->word) + std::to_string(c->value) : std::string("none");
  };
  EXPECT_EQ(read("G1394n"), "G1394");
  EXPECT_EQ(read("G-50n"), "G-50");
  EXPECT_EQ(read("M220n"), "M220");
  EXPECT_EQ(read("T0n"), "T0");
  EXPECT_EQ(read("F255n"), "F255");
  EXPECT_EQ(read("R0n"), "R0");
  for (const char* bad : {"", "n", "Gn", "G1394", "G1394nn", "g1394n", "X1n", "M-5n", "G1 n",
                          "G1.5n", "G12345678901234567n", "G1394\n"})
    EXPECT_EQ(read(bad), "none") << bad;
}

TEST(FilamentCount, feedsOnlyFilamentThatWasNotRetracted) {
  FilamentCount count;
  EXPECT_EQ(count.to(5.0), 5.0);
  EXPECT_EQ(count.to(3.0), 0.0);
  EXPECT_EQ(count.drawnBackMm(), 2.0);
  count.set(0.0); // counted anew, still drawn back
  EXPECT_EQ(count.drawnBackMm(), 2.0);
  EXPECT_EQ(count.to(1.5), 0.0);
  EXPECT_EQ(count.to(3.0), 1.0);
  EXPECT_EQ(count.mm(), 3.0);
  EXPECT_EQ(count.drawnBackMm(), 0.0);
}

class Extruders : public test::ReadPrograms {
protected:
  ProgramInput inputFor(std::string_view extruder) const {
    ProgramInput in = input();
    in.options.own[std::string(kExtruderOption)] = std::string(extruder);
    return in;
  }
};

TEST_F(Extruders, haveUniqueIdsThatDialectsReferTo) {
  std::set<std::string_view> ids;
  for (const Extruder& row : extruders())
    EXPECT_TRUE(ids.insert(row.id).second && !row.label.empty()) << row.id;
  for (const Dialect& d : dialects()) {
    for (const std::string_view id : d.extruders)
      EXPECT_TRUE(ids.contains(id)) << id;
    EXPECT_TRUE(d.extruders.empty() || d.extruders.front() == kOutputsExtruder);
  }
  EXPECT_THROW(findExtruder("castelli"), base::Error);
}

// Every pair of a dialect and a row: programs are read back as written, at every motion and pause.
TEST_F(Extruders, giveEachMotionItsMaterial) {
  for (const Dialect& d : dialects())
    for (const std::string_view id : d.extruders) {
      SCOPED_TRACE(std::string(d.id) + " with " + std::string(id));
      randomFor(d, 3, 900);
      const plan::Program program = writeProgram(d.id, inputFor(id));
      const plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process_));
      for (const plan::ProgramDefect& defect : back.defects)
        ADD_FAILURE() << defect.line << ": " << base::english(defect.reason);
      EXPECT_TRUE(back.complete);
      ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
      double primed = 0.0;
      for (const plan::ProgramPause& pause : back.pauses)
        primed += pause.volumeMm3;
      EXPECT_NEAR(primed, process::primeFlow(process_) * process_.primeS,
                  5e-3 * process::primeFlow(process_));
      for (std::size_t i = 1; i < back.motions.size(); ++i) {
        const double volume = motionVolumeMm3(trajectory_, i);
        const plan::ProgramMotion& m = back.motions[i];
        EXPECT_EQ(m.extruding, isPrint(trajectory_, i)) << i;
        const double plannedS =
            std::max(motionSeconds(trajectory_, i), volume / process_.maxFlowMm3PerS);
        if (m.extruding && m.volumeMm3 >= 0.0) { // amounts
          EXPECT_NEAR(m.volumeMm3, volume, 1e-4) << i;
        } else if (m.extruding && volume > 0.05) {
          // Within the band, and half a microsecond of a step.
          EXPECT_NEAR(m.flowMm3PerS * plannedS, volume, (kFlowBand + 0.011) * volume) << i;
        }
      }
    }
}

// Drawn back behind each bead that another follows and returned before that: nothing of it comes
// out, and where some of it is not returned the program is refused.
TEST_F(Extruders, drawBackAndReturnTheSame) {
  process_.retractMm = 1.5;
  for (const Dialect& d : dialects()) {
    std::vector<std::string_view> ids = d.extruders;
    if (ids.empty())
      ids = {kOutputsExtruder};
    for (const std::string_view id : ids) {
      SCOPED_TRACE(std::string(d.id) + " with " + std::string(id));
      randomFor(d, 3, 300);
      ProgramInput in = inputFor(id);
      const plan::Program program = writeProgram(d.id, in);
      const plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process_));
      for (const plan::ProgramDefect& defect : back.defects)
        ADD_FAILURE() << defect.line << ": " << base::english(defect.reason);
      std::size_t beads = 0, stands = 0;
      for (std::size_t i = 1; i < trajectory_.pointCount(); ++i)
        beads += isPrint(trajectory_, i) && !isPrint(trajectory_, i - 1) ? 1 : 0;
      double seconds = 0.0, out = 0.0;
      for (const plan::ProgramPause& pause : back.pauses)
        if (pause.before > 1) {
          ++stands;
          seconds += pause.durationS;
          out += pause.volumeMm3;
        }
      EXPECT_LT(out, 1e-3);
      const bool amounts = // rows of streams, and lines, state a flow
          d.extruders.empty() &&
          std::ranges::any_of(back.motions, [](const auto& m) { return m.volumeMm3 >= 0.0; });
      const bool draws = amounts ? d.id != "csv" : id != kOutputsExtruder;
      ASSERT_GT(beads, 4u);
      EXPECT_EQ(stands, draws ? 2 * (beads - 1) : 0);
      const double perS = d.extruders.empty() ? 30.0 : kDrawBackMmPerS;
      EXPECT_NEAR(seconds, draws ? 2.0 * static_cast<double>(beads - 1) * 1.5 / perS : 0.0, 0.02);
    }
  }
}

// Each file sets its extruder up and ends it: opens and closes a connection, for one.
TEST_F(Extruders, areUsedFromSeveralFiles) {
  int inSeveral = 0;
  for (const Dialect& d : dialects())
    for (const std::string_view id : d.extruders) {
      SCOPED_TRACE(std::string(d.id) + " with " + std::string(id));
      randomFor(d, 5, 200);
      ProgramInput in = inputFor(id);
      in.options.motionsPerFile = 60;
      const plan::Program program = writeProgram(d.id, in);
      inSeveral += program.files.size() > 3;
      const plan::ReadProgram back = readProgram(d.id, program.files, process::Tooling(process_));
      for (const plan::ProgramDefect& defect : back.defects)
        ADD_FAILURE() << defect.line << ": " << base::english(defect.reason);
      EXPECT_EQ(back.motions.size(), trajectory_.pointCount());
    }
  EXPECT_GE(inSeveral, 3);
}

TEST_F(Extruders, areTakenFromTheChoicesOrTheCell) {
  randomFor(findDialect("urscript"), 1, 100);
  const auto textFor = [&](std::string_view id) {
    return writeProgram("urscript", inputFor(id)).files.front().text;
  };
  EXPECT_NE(textFor("outputs").find("set_standard_analog_out(0,0."), std::string::npos);
  EXPECT_NE(textFor("castelli-serial").find("socket_send_string(\"G"), std::string::npos);
  EXPECT_EQ(textFor("castelli-serial").find("analog_out"), std::string::npos);
  EXPECT_EQ(textFor("e-stream").find("analog_out(0,0."), std::string::npos);
  EXPECT_EQ(textFor("cell"), writeProgram("urscript", input()).files.front().text);

  std::string json = test::kCellJson;
  json.insert(json.find("\"label\""), "\"extruder\": \"castelli-serial\", ");
  const test::TemporaryFolder folder;
  base::writeFile(folder / "bench.json", json);
  cell_.emplace(robot::Cell::read(folder / "bench.json", process_,
                                  {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}}));
  EXPECT_EQ(textFor("cell"), textFor("castelli-serial"));
  // A dialect that states amounts has its own; one without words for it refuses in one line.
  EXPECT_NO_THROW(writeProgram("gcode-extended", input()));
  try {
    writeProgram("krl", input());
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("castelli-serial"), std::string::npos);
  }
}

TEST_F(Extruders, areOfferedWhereTheDialectHasWordsForThem) {
  for (const Dialect& d : dialects()) {
    std::vector<std::string> offered;
    for (const base::ParameterSpec& option : optionsOf(d))
      if (option.key == kExtruderOption)
        for (const base::Choice& choice : option.choices)
          offered.push_back(choice.id);
    std::vector<std::string> expected;
    if (!d.extruders.empty()) {
      expected = {"cell"};
      expected.insert(expected.end(), d.extruders.begin(), d.extruders.end());
    }
    EXPECT_EQ(offered, expected) << d.id;
    // The table that all dialects' options are in knows each of them.
    for (const std::string& id : offered)
      EXPECT_NO_THROW(base::ParameterValues(programParameters()).set(kExtruderOption, id));
  }
}

TEST_F(Extruders, streamHasTimesAndFilamentFromTheOutputOn) {
  append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
  append(plan::MoveKind::Linear, {0.001, 0, 0, 0, 0, 0}, 0.1, 0);
  append(plan::MoveKind::Print, {0.002, 0, 0, 0, 0, 0}, 0.05, 0.5);
  append(plan::MoveKind::Print, {0.003, 0, 0, 0, 0, 0}, 0.05, 0.5);
  append(plan::MoveKind::Linear, {0.004, 0, 0, 0, 0, 0}, 0.1, 0);
  const plan::Program program = writeProgram("melfa", inputFor("e-stream"));
  // 0.5 mm3 of 1.75 mm filament are 0.20788 mm.
  EXPECT_EQ(program.files.back().name, "part_1_e.txt");
  EXPECT_EQ(program.files.back().text, "# E stream beside print_part_1\n"
                                       "# filament diameter 1.75 mm\n"
                                       "on 1\n1 0.200000 1.36808\noff 1\n"
                                       "on 2\n3 0.050000 0.20788\n4 0.100000 0.41575\noff 4\n"
                                       "end\n");
  EXPECT_EQ(continuationFiles(findDialect("melfa"), program.files.front().text),
            std::vector<std::string>{"part_1_e.txt"});
}

// 0.5 mm3 of 1.75 mm filament are 0.20788 mm; the prime of 0.2 s at 0.8 mm2 and 20 mm/s is 1.36808.
class AxisExtruder : public Extruders {
protected:
  void SetUp() override {
    Extruders::SetUp();
    append(plan::MoveKind::Joint, {0, 0, 0, 0, 0, 0}, 0, 0);
    append(plan::MoveKind::Linear, {0.001, 0, 0, 0, 0, 0}, 0.1, 0);
    for (int k = 2; k < 4; ++k)
      append(plan::MoveKind::Print, {0.001 * k, 0, 0, 0, 0, 0}, 0.05, 0.5);
    append(plan::MoveKind::Linear, {0.004, 0, 0, 0, 0, 0}, 0.1, 0);
    append(plan::MoveKind::Linear, {0.005, 0, 0, 0, 0, 0}, 0.1, 0);
    append(plan::MoveKind::Print, {0.006, 0, 0, 0, 0, 0}, 0.05, 0.5);
    append(plan::MoveKind::Linear, {0.007, 0, 0, 0, 0, 0}, 0.1, 0);
  }
  std::string written(std::string_view dialect, std::size_t file = 0) const {
    return writeProgram(dialect, inputFor(kAxisExtruder)).files[file].text;
  }
  // All that `pattern`'s brackets find, in order.
  static std::vector<std::string> all(const std::string& text, const char* pattern) {
    std::vector<std::string> found;
    const std::regex words(pattern);
    for (std::sregex_iterator at(text.begin(), text.end(), words), end; at != end; ++at)
      found.push_back((*at)[1].str());
    return found;
  }
};
using Texts = std::vector<std::string>;

TEST_F(AxisExtruder, isInEachMotionAsMillimetresOfFilament) {
  process_.retractMm = 1.5;
  // Start, prime, way, two of the bead, back, lift, way, forth, bead, lift.
  const Texts expected = {"0",       "1.36808", "1.36808", "1.57596", "1.78383", "0.28383",
                          "0.28383", "0.28383", "1.78383", "1.99171", "1.99171"};
  EXPECT_EQ(all(written("krl"), "[{,]E1 ([-0-9.]+)"), expected);
  EXPECT_EQ(all(written("rapid"), ",.([-0-9.]+),9E9,9E9,9E9,9E9,9E9."), expected);
  EXPECT_EQ(written("krl").find("$OUT"), std::string::npos);
  EXPECT_EQ(written("rapid").find("SetDO"), std::string::npos);
  EXPECT_NE(
      written("rapid").find("    MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[1.36808,9E9,9E9,9E9,9E9,"
                            "9E9]],v100\\T:=0.2,fine;\r\n"),
      std::string::npos);
  // 6.84 mm/s of 20, and all of it again for the motions.
  EXPECT_NE(written("krl").find("$VEL_EXTAX[1]=34\r\nPTP {E1 1.36808}\r\n"), std::string::npos);
  EXPECT_EQ(written("krl", 2), "&ACCESS RVP\r\n&REL 1\r\nDEF ZERO_EXTRUDER ( )\r\n"
                               "; Set the extruder's axis to 0 mm where it stands, then go on.\r\n"
                               "HALT\r\nEND\r\n");
}

TEST_F(AxisExtruder, isTheFirstAxisThatMovesNoPart) {
  useRod();
  trajectory_ = {};
  appendRandomOnRod(5, 100);
  EXPECT_NE(written("krl").find("EXTRUDER_AXIS=2\r\n"), std::string::npos);
  for (const char* dialect : {"krl", "rapid"}) {
    SCOPED_TRACE(dialect);
    const plan::Program program = writeProgram(dialect, inputFor(kAxisExtruder));
    const plan::ReadProgram back = readProgram(dialect, program.files, process::Tooling(process_));
    for (const plan::ProgramDefect& defect : back.defects)
      ADD_FAILURE() << defect.line << ": " << base::english(defect.reason);
    EXPECT_TRUE(back.complete);
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
    for (std::size_t i = 1; i < back.motions.size(); ++i) {
      ASSERT_EQ(back.motions[i].externals.size(), 1u);
      EXPECT_NEAR(back.motions[i].externals[0], trajectory_.at(i)[6], 1e-5);
      EXPECT_NEAR(back.motions[i].volumeMm3, motionVolumeMm3(trajectory_, i), 1e-4) << i;
    }
  }
}

// Where the range ends: lifted off, and all the same material.
TEST_F(AxisExtruder, isSetToNothingAnewWhereItsRangeEnds) {
  trajectory_ = {};
  plan_ = {};
  appendRandom(9, 900); // some 20 mm3, 8.6 mm of filament, a path
  for (const char* dialect : {"krl", "rapid"}) {
    SCOPED_TRACE(dialect);
    ProgramInput in = inputFor(kAxisExtruder);
    in.options.own["extruderAxisMm"] = 40.0;
    in.options.motionsPerFile = 300;
    process_.retractMm = 1.0;
    const AxisCount count = axisCount(in);
    EXPECT_GT(count.zeros.size(), 3u);
    EXPECT_LE(count.maxMm, 40.0);
    EXPECT_GT(count.maxMm, 30.0);
    for (const std::size_t i : count.zeros)
      EXPECT_TRUE(i == 0 || standsClear(trajectory_, i));
    const plan::Program program = writeProgram(dialect, in);
    double maximum = 0.0;
    for (const plan::ProgramFile& file : program.files)
      for (const std::string& mm :
           all(file.text, dialect == std::string_view("krl") ? "[{,]E1 ([-0-9.]+)"
                                                             : ",.([-0-9.]+),9E9,9E9,9E9,9E9,9E9."))
        maximum = std::max(maximum, std::stod(mm));
    EXPECT_LE(maximum, 40.0);
    EXPECT_GT(maximum, 25.0);
    const plan::ReadProgram back = readProgram(dialect, program.files, process::Tooling(process_));
    for (const plan::ProgramDefect& defect : back.defects)
      ADD_FAILURE() << defect.file << ":" << defect.line << ": " << base::english(defect.reason);
    EXPECT_TRUE(back.complete);
    ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
    for (std::size_t i = 1; i < back.motions.size(); ++i)
      EXPECT_NEAR(std::max(0.0, back.motions[i].volumeMm3), motionVolumeMm3(trajectory_, i), 1e-4)
          << i;
    for (const std::size_t i : count.zeros) // the arm rests there
      EXPECT_TRUE(i == 0 || back.motions[i - 1].blendMm == 0.0) << i;
  }
  ProgramInput in = inputFor(kAxisExtruder);
  for (double& mm3 : trajectory_.extrudedMm3)
    mm3 *= 10.0;
  in.options.own["extruderAxisMm"] = 40.0;
  try {
    writeProgram("krl", in);
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("between two lifts"), std::string::npos);
  }
}

// Invalid motions of the axis are named at their line.
TEST_F(AxisExtruder, isRefusedWhereItRunsAsNoExtruderCan) {
  struct Case {
    const char *dialect, *what, *by, *reason;
  };
  for (const Case& c :
       std::vector<Case>{{"krl", "ZERO_EXTRUDER \\( \\)\r\n", "", "is not set to 0"},
                         {"krl", "EXTRUDER_AXIS=1", "EXTRUDER_AXIS=3", "axis is missing"},
                         {"krl", "E1 1.57596", "E1 0.57596", "reverses while"},
                         {"krl", "PTP \\{E1 0.28383\\}", "PTP {E1 -30}", "retracted: out"},
                         {"krl", "PTP \\{E1 1.78383\\}\r\n", "", "is not returned"},
                         {"krl", "EXTAX\\[1\\]=100", "EXTAX[1]=50", "is slowed"},
                         {"rapid", "    zeroExtruder;", "", "is not set to 0"},
                         {"rapid", "    ActUnit extruder;", "", "moves no work object"},
                         {"rapid", ".1.57596,", "[9E9,", "axis is missing"},
                         {"rapid", ".1.57596,", "[0.57596,", "reverses while"},
                         {"rapid", ".9E9,9E9,9E9,9E9,9E9,9E9.,.0.28383", "[0,0,0,0,0,0],[0.28383",
                          "supported for the extruder"},
                         {"rapid", "v100.T:=0.15", "v100", "supported for the extruder"}}) {
    SCOPED_TRACE(std::string(c.dialect) + ": " + c.what);
    process_.retractMm = 1.5;
    plan::Program program = writeProgram(c.dialect, inputFor(kAxisExtruder));
    std::string& text = program.files.front().text;
    const std::string whole = text;
    text = std::regex_replace(text, std::regex(c.what), c.by);
    ASSERT_NE(text, whole);
    const plan::ReadProgram back =
        readProgram(c.dialect, program.files, process::Tooling(process_));
    std::string reported;
    for (const plan::ProgramDefect& defect : back.defects)
      reported += base::english(defect.reason) + "\n";
    EXPECT_NE(reported.find(c.reason), std::string::npos) << reported;
  }
}

} // namespace
} // namespace voluta::program
