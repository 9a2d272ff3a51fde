// What every row of the extruders has to keep, over all dialects that have words for it.
#include "read_programs.h"

#include "base/error.h"
#include "process/bead_model.h"
#include "program/castelli_serial.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "program/extruder_stream.h"
#include "program/motion_targets.h"
#include "program/tcp_motions.h"

#include <algorithm>
#include <set>

namespace voluta::program {
namespace {

// Castelli 2020, 2.1.4: 3 mm filament, 1674.18 steps/mm, a strand of 0.1514 mm2; half the period is
// 1e6 / (2 * 1674.18 * 0.1514 * 10 / (pi/4 * 9)) = 1394.4 us.
TEST(CastelliSerial, saysABeadAsTheTableHasIt) {
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

class Extruders : public test::ReadPrograms {
protected:
  ProgramInput inputFor(std::string_view extruder) const {
    ProgramInput in = input();
    in.options.own[std::string(kExtruderOption)] = std::string(extruder);
    return in;
  }
};

TEST_F(Extruders, haveIdsOfTheirOwnAndDialectsKnowThem) {
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

// Every pair of a dialect and a row: what is written is read back, at every motion and pause.
TEST_F(Extruders, giveEachMotionItsMaterial) {
  for (const Dialect& d : dialects())
    for (const std::string_view id : d.extruders) {
      SCOPED_TRACE(std::string(d.id) + " with " + std::string(id));
      randomFor(d, 3, 900);
      const plan::Program program = writeProgram(d.id, inputFor(id));
      const plan::ReadProgram back = readProgram(d.id, program.files, process_);
      for (const plan::ProgramDefect& defect : back.defects)
        ADD_FAILURE() << defect.line << ": " << base::english(defect.reason);
      EXPECT_TRUE(back.complete);
      ASSERT_EQ(back.motions.size(), trajectory_.pointCount());
      double primed = 0.0;
      for (const plan::ProgramPause& pause : back.pauses)
        primed += pause.volumeMm3;
      EXPECT_NEAR(primed, primeFlowMm3PerS(process_) * process_.primeS,
                  5e-3 * primeFlowMm3PerS(process_));
      for (std::size_t i = 1; i < back.motions.size(); ++i) {
        const double volume = motionVolumeMm3(trajectory_, i);
        const plan::ProgramMotion& m = back.motions[i];
        EXPECT_EQ(m.extruding, isPrint(trajectory_, i)) << i;
        const double plannedS =
            std::max(motionSeconds(trajectory_, i), volume / process_.maxFlowMm3PerS);
        if (m.extruding && volume > 0.05) {
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
      const plan::ReadProgram back = readProgram(d.id, program.files, process_);
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
      const bool amounts = d.extruders.empty() && !d.beadsByJoints; // rows of streams say a flow
      const bool draws = amounts ? d.id != "csv" : id != kOutputsExtruder;
      ASSERT_GT(beads, 4u);
      EXPECT_EQ(stands, draws ? 2 * (beads - 1) : 0);
      const double perS = d.extruders.empty() ? 30.0 : kDrawBackMmPerS;
      EXPECT_NEAR(seconds, draws ? 2.0 * static_cast<double>(beads - 1) * 1.5 / perS : 0.0, 0.02);
    }
  }
}

TEST_F(Extruders, thatAChoiceOrTheCellAsksForAreTaken) {
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
  // A dialect that tells amounts has its own; one without words for it refuses in one line.
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

TEST_F(Extruders, streamSaysTimesAndFilamentFromTheOutputOn) {
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
  EXPECT_EQ(goesOnIn(findDialect("melfa"), program.files.front().text),
            std::vector<std::string>{"part_1_e.txt"});
}

} // namespace
} // namespace voluta::program
