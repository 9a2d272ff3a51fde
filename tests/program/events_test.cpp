// Events of a trajectory in programs: every dialect writes them, or refuses.
#include "base/error.h"
#include "plan/stated_facts.h"
#include "program/dialect.h"
#include "program/gcode/gcode_text.h"
#include "program/program_builder.h"
#include "program_fixture.h"

#include <algorithm>

namespace voluta::program {
namespace {

class Events : public test::Programs {
protected:
  void SetUp() override {
    Programs::SetUp();
    appendRandom(7, 120);
  }
  // The first motion of a travel behind the first path.
  std::size_t travel() const {
    std::size_t i = 1;
    while (i + 1 < trajectory_.pointCount() && !(trajectory_.move[i] == plan::MoveKind::Print &&
                                                 trajectory_.move[i + 1] != plan::MoveKind::Print))
      ++i;
    return i + 1;
  }
  static bool says(const Dialect& dialect, plan::EventKind kind) {
    return std::ranges::find(dialect.events, kind) != dialect.events.end();
  }
};

TEST_F(Events, everyDialectWritesEachOrRefuses) {
  std::size_t said = 0;
  for (const Dialect& dialect : dialects()) {
    SCOPED_TRACE(dialect.id);
    useArmFor(dialect);
    for (const plan::EventKind kind :
         {plan::EventKind::ToolChange, plan::EventKind::Cut, plan::EventKind::Pause,
          plan::EventKind::Feed, plan::EventKind::Wait}) {
      trajectory_.events = {
          {.point = travel(), .kind = kind, .tool = 1, .feedMm = 5.0, .seconds = 5.0}};
      const auto refused = refusal(dialect, *cell_, {}, &trajectory_);
      if (!says(dialect, kind)) {
        ASSERT_TRUE(refused);
        EXPECT_THROW(requireEvents(dialect, trajectory_), base::Error);
        continue;
      }
      EXPECT_NO_THROW(requireEvents(dialect, trajectory_));
      ++said;
    }
  }
  EXPECT_GE(said, 7u);
}

TEST_F(Events, aPauseIsReadBackBeforeItsMotion) {
  for (const Dialect& dialect : dialects()) {
    if (!says(dialect, plan::EventKind::Pause) || !dialect.tiltsNozzle)
      continue;
    SCOPED_TRACE(dialect.id);
    useArmFor(dialect);
    trajectory_.events.clear();
    const auto stops = [&] {
      const plan::Program program = writeProgram(dialect.id, input());
      const plan::ReadProgram read =
          readProgram(dialect.id, program.files, process::Tooling(process_));
      EXPECT_TRUE(read.defects.empty())
          << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
      std::vector<std::size_t> before;
      for (const plan::StatedFact& fact : read.facts)
        if (fact.kind == plan::FactKind::OperatorStop && fact.before > 0 &&
            fact.before < read.motions.size())
          before.push_back(fact.before);
      return before;
    };
    EXPECT_TRUE(stops().empty());
    trajectory_.events = {{.point = travel(), .kind = plan::EventKind::Pause}};
    const std::vector<std::size_t> before = stops();
    ASSERT_EQ(before.size(), 1u);
  }
}

// At a bead's first print motion and within the bead: the extruder has to be off meanwhile.
TEST_F(Events, aPauseBesideABeadStopsTheExtruder) {
  std::size_t first = 1;
  while (trajectory_.move[first] != plan::MoveKind::Print)
    ++first;
  for (const Dialect& dialect : dialects()) {
    if (!says(dialect, plan::EventKind::Pause) || !dialect.tiltsNozzle)
      continue;
    useArmFor(dialect);
    for (const std::size_t point : {first, first + 5}) {
      SCOPED_TRACE(std::string(dialect.id) + " point " + std::to_string(point));
      trajectory_.events = {{.point = point, .kind = plan::EventKind::Pause}};
      const plan::ReadProgram read = readProgram(
          dialect.id, writeProgram(dialect.id, input()).files, process::Tooling(process_));
      EXPECT_TRUE(read.defects.empty())
          << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
      EXPECT_EQ(std::ranges::count_if(read.facts,
                                      [&](const plan::StatedFact& fact) {
                                        return fact.kind == plan::FactKind::OperatorStop &&
                                               fact.before > 0;
                                      }),
                1);
    }
  }
}

// Within a bead, as tape is cut before the end of its path.
TEST_F(Events, aCutIsReadBackBeforeItsMotion) {
  std::size_t first = 1, said = 0;
  while (trajectory_.move[first] != plan::MoveKind::Print)
    ++first;
  for (const Dialect& dialect : dialects()) {
    if (!says(dialect, plan::EventKind::Cut))
      continue;
    ++said;
    useArmFor(dialect);
    if (!dialect.tiltsNozzle)
      continue;
    for (const std::size_t point : {first + 1, first + 4}) {
      SCOPED_TRACE(std::string(dialect.id) + " point " + std::to_string(point));
      const auto cutsBefore = [&] {
        const plan::ReadProgram read = readProgram(
            dialect.id, writeProgram(dialect.id, input()).files, process::Tooling(process_));
        EXPECT_TRUE(read.defects.empty())
            << (read.defects.empty() ? "" : base::english(read.defects[0].reason));
        std::vector<std::size_t> before;
        for (const plan::StatedFact& fact : read.facts)
          if (fact.kind == plan::FactKind::TapeCut)
            before.push_back(fact.before);
        return before;
      };
      trajectory_.events.clear();
      EXPECT_TRUE(cutsBefore().empty());
      trajectory_.events = {{.point = point, .kind = plan::EventKind::Cut}};
      EXPECT_EQ(cutsBefore(), std::vector<std::size_t>{point});
    }
  }
  EXPECT_GE(said, 4u);
}

TEST_F(Events, aJoinedTrajectoryKeepsThem) {
  trajectory_.events = {{.point = 20, .kind = plan::EventKind::Pause},
                        {.point = 20, .kind = plan::EventKind::Cut},
                        {.point = travel(), .kind = plan::EventKind::Pause}};
  const MergedPoints merged = mergedPoints(input(),
                                           {.minS = 10.0,
                                            .minMm = 50.0,
                                            .toleranceMm = 100.0,
                                            .toleranceRad = 10.0,
                                            .sectionShare = 100.0},
                                           {});
  const plan::Trajectory& t = *merged.trajectory;
  ASSERT_EQ(t.events.size(), 3u);
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ(t.events[e].kind, trajectory_.events[e].kind);
    const std::size_t before = trajectory_.events[e].point - 1;
    EXPECT_EQ(t.timeS[t.events[e].point - 1], trajectory_.timeS[before])
        << "the point before stays";
  }
  EXPECT_EQ(t.eventsBefore(t.events[0].point).size(), 2u);
  EXPECT_EQ(t.eventsBefore(t.events[2].point).size(), 1u);
  EXPECT_TRUE(t.eventsBefore(t.events[2].point + 1).empty());
}

TEST_F(Events, FactsPausesAndMotionsBelongToTheSelectedTool) {
  ProgramBuilder out("gcode", process::Tooling({{process_}, {process_}}));
  out.state(plan::FactKind::NozzleHeat, 210.0);
  out.selectTool(1);
  out.state(plan::FactKind::NozzleHeat, 220.0);
  out.stateOf(0, plan::FactKind::NozzleHeat, 180.0);
  out.pause(1.0, 0.0);
  out.motion({});
  out.selectTool(2); // The job has none
  EXPECT_EQ(out.selectedTool(), 1);
  const plan::ReadProgram read = out.take(true);
  ASSERT_EQ(read.facts.size(), 4u);
  EXPECT_EQ(read.facts[0].tool, 0);
  EXPECT_EQ(read.facts[1].kind, plan::FactKind::ToolSelected);
  EXPECT_EQ(read.facts[1].tool, 1);
  EXPECT_EQ(read.facts[2].tool, 1);
  EXPECT_EQ(read.facts[3].tool, 0);
  EXPECT_EQ(read.pauses[0].tool, 1);
  EXPECT_EQ(read.motions[0].tool, 1);
  EXPECT_EQ(read.defects.size(), 1u);
}

// Firmware shows the text of M0, but takes a P or S with a number for a time.
TEST_F(Events, GcodeStopsShowTheirText) {
  EXPECT_EQ(gcodeStopText("Fit tool 2 (petg-1.0, PETG, 240 C), then continue"),
            "Fit tool 2 (petg-1.0, PETG, 240 C), then continue");
  EXPECT_EQ(gcodeStopText("ABS 240; P5 S+1"), "ABs 240  p5 s+1");
  const auto stopOf = [&](const std::string& line) {
    const plan::ReadProgram read =
        readProgram("gcode", {{"a", line + "\n"}}, process::Tooling(process_));
    const auto stop =
        std::ranges::find(read.facts, plan::FactKind::OperatorStop, &plan::StatedFact::kind);
    EXPECT_NE(stop, read.facts.end()) << line;
    return stop == read.facts.end() ? plan::StatedFact() : *stop;
  };
  EXPECT_EQ(stopOf("M0 Fit tool 2 (PETG, 240 C)").word, "Fit tool 2 (PETG, 240 C)");
  EXPECT_EQ(stopOf("M0 Fit tool 2 (PETG, 240 C)").number, 1.0);
  EXPECT_EQ(stopOf("M0 Wait S5").number, 0.0);
  EXPECT_EQ(stopOf("M0 P100").number, 0.0);
  EXPECT_EQ(stopOf("M0").number, 1.0);
}

// The heads of G-code name the tools only if the motion changes them.
TEST_F(Events, GcodeHeatsEachToolThatPrints) {
  process::Tool hot{process_};
  process_.material.nozzleC = 210;
  hot.process.material.nozzleC = 220;
  const process::Tooling two({{process_}, hot});
  const auto textOf = [&] {
    ProgramInput in = input();
    in.tooling = two;
    GcodeText text;
    text.head(in, "title", "question");
    text.end();
    return text.out;
  };
  const std::string one = textOf();
  EXPECT_NE(one.find("\nM104 S210 ;"), std::string::npos);
  EXPECT_EQ(one.find("220"), std::string::npos);
  trajectory_.events = {{.point = travel(), .kind = plan::EventKind::ToolChange, .tool = 1}};
  const std::string both = textOf();
  for (const char* line : {"\nM104 T0 S210 ;", "\nM104 T1 S220 ;", "\nM109 T0 S210\n",
                           "\nM109 T1 S220\n", "\nM104 T0 S0\n", "\nM104 T1 S0\n"})
    EXPECT_NE(both.find(line), std::string::npos) << line;

  const plan::ReadProgram read = readProgram("gcode-extended", {{"head", both}}, two);
  std::vector<std::pair<int, double>> heats;
  for (const plan::StatedFact& fact : read.facts)
    if (fact.kind == plan::FactKind::NozzleHeat)
      heats.emplace_back(fact.tool, fact.number);
  const std::vector<std::pair<int, double>> planned = {{0, 210}, {1, 220}, {0, 210},
                                                       {1, 220}, {0, 0},   {1, 0}};
  EXPECT_EQ(heats, planned);
}

} // namespace
} // namespace voluta::program
