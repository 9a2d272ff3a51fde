// Programs whose statements between motions somebody changed: of every dialect that has words for
// events each such line is dropped, doubled, exchanged with the next one, moved past motions, and
// given other numbers; all of it is refused at its line or at the next motion. Harmless edits of
// the same programs bring no alarm.
#include "helpers/all_seeds.h"
#include "plan/waypoints.h"
#include "program/dialect.h"
#include "replay/mutations.h"
#include "replay/replay_scene.h"
#include "replay/statement_mutations.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <regex>

namespace voluta::replay {
namespace {

using plan::EventKind;

// A box of three layers, the second by another tool, with all events that a dialect has words for.
class StatementScene {
public:
  explicit StatementScene(const program::Dialect& dialect)
      : scene(test::boxScene(3, test::cellFor(std::string(dialect.id)))), dialect_(dialect) {
    if (has(EventKind::ToolChange)) {
      process::Process other = scene.process;
      other.id = "other";
      other.maxFlowMm3PerS *= 1.5;
      other.material = process::loadMaterial("petg");
      tooling = process::Tooling({{scene.process}, {other}});
      for (plan::ToolPath& path : scene.plan.paths)
        path.tool = path.layer == 1 ? 1 : 0;
    }
    plan::Trajectory& t = scene.trajectory;
    add({.point = 1, .kind = EventKind::Mark});
    int tool = 0, beads = 0;
    for (std::size_t i = 2; i + 3 < t.pointCount(); ++i) {
      if (t.move[i] == plan::MoveKind::Print || t.move[i + 1] != plan::MoveKind::Print)
        continue;
      const int wanted = plan::pathOf(scene.plan, t.waypoint[i])->tool;
      if (std::exchange(tool, wanted) != wanted)
        change(i, wanted);
      else
        between(i, ++beads);
    }
    add({.point = t.pointCount(), .kind = EventKind::Mark});
  }

  test::Scene scene;
  process::Tooling tooling{scene.process};

private:
  bool has(EventKind kind) const { return program::hasWordFor(dialect_, kind); }
  void add(const plan::TrajectoryEvent& event) {
    if (has(event.kind))
      scene.trajectory.events.push_back(event);
  }
  // The second tool is fitted by hand, the first one by a tool changer where there are words for
  // it.
  void change(std::size_t point, int tool) {
    test::moveSideways(scene.trajectory, scene.cell, point - 1);
    const bool byHand = tool != 0 || !has(EventKind::Lock);
    add({.point = point, .kind = byHand ? EventKind::Pause : EventKind::Release, .seconds = 0.0});
    if (!byHand)
      scene.trajectory.events.back().seconds = 1.5;
    add({.point = point, .kind = EventKind::ToolChange, .tool = tool});
    if (!byHand)
      add({.point = point, .kind = EventKind::Lock, .seconds = 1.5});
    add({.point = point, .kind = EventKind::Purge, .seconds = 4.0, .volumeMm3 = 50.0});
  }
  // Before the bead with that number.
  void between(std::size_t point, int bead) {
    if (bead == 3)
      add({.point = point, .kind = EventKind::Wait, .seconds = 23.456});
    if (bead == 5 || bead == 19)
      add({.point = point, .kind = EventKind::Mark});
    if (bead == 6)
      add({.point = point + 4, .kind = EventKind::Cut});
    if (bead == 7)
      add({.point = point, .kind = EventKind::Pause});
    if (bead == 9 && has(EventKind::Shot)) {
      test::moveSideways(scene.trajectory, scene.cell, point - 1);
      add({.point = point, .kind = EventKind::Shot, .seconds = 1.0, .volumeMm3 = 0.6});
    }
    if (bead == 2 && !has(EventKind::ToolChange) && has(EventKind::Purge)) {
      test::moveSideways(scene.trajectory, scene.cell, point - 1);
      add({.point = point, .kind = EventKind::Purge, .seconds = 4.0, .volumeMm3 = 50.0});
    }
  }
  const program::Dialect& dialect_;
};

class StatementMutants : public ::testing::TestWithParam<std::string> {
protected:
  StatementMutants() : made_(program::findDialect(GetParam())) {}
  void SetUp() override {
    const test::Scene& s = made_.scene;
    whole_ = test::textOf(
        program::writeProgram(GetParam(), {s.plan, s.trajectory, s.cell, made_.tooling, "box"}));
    read_ = test::read(whole_, made_.tooling);
    const Verification sound = verify(read_);
    ASSERT_TRUE(sound.passed) << findingsText(sound);
    remarks_ = sound.findings.size();
  }
  Verification verify(plan::ReadProgram program) const {
    const test::Scene& s = made_.scene;
    return replayProgram(
        {std::move(program), s.plan, s.trajectory, s.cell, made_.tooling, s.part, s.platform},
        ReplayThresholds{}, {});
  }
  // At one of its lines, or at the first motion behind.
  static bool isReported(const Verification& v, const test::StatementEdit& edit,
                         const std::vector<std::size_t>& motionLines) {
    std::size_t next = edit.text.lines.size();
    for (const std::size_t line : motionLines)
      if (line >= edit.last && line < next)
        next = line;
    return std::ranges::any_of(v.places, [&](const TextPlace& place) {
      return place.line > 0 && place.line + 1 >= edit.first && place.line <= next + 1;
    });
  }

  StatementScene made_;
  test::ProgramText whole_;
  plan::ReadProgram read_;
  std::size_t remarks_ = 0; // findings of the sound program
};

TEST_P(StatementMutants, HarmIsFoundAtItsLine) {
  struct Count {
    int tried = 0, refused = 0, reported = 0;
  };
  std::map<std::string, Count> table;
  std::string missed;
  std::mt19937_64 random(23);
  constexpr std::size_t kFew = 24;
  const std::vector<test::StatementEdit> edits = test::statementEdits(whole_, read_);
  const std::size_t every = edits.size() > kFew ? test::ofSeeds(6u, 1u) : 1u;
  for (const test::StatementEdit& edit : edits) {
    if (random() % every != 0)
      continue;
    plan::ReadProgram now = test::read(edit.text, made_.tooling);
    std::vector<std::size_t> motionLines;
    for (const plan::ProgramMotion& motion : now.motions)
      motionLines.push_back(motion.line);
    const Verification v = verify(std::move(now));
    const bool isHere = isReported(v, edit, motionLines);
    Count& count = table[edit.kind];
    ++count.tried;
    count.refused += v.passed ? 0 : 1;
    count.reported += isHere ? 1 : 0;
    if (v.passed || !isHere)
      missed += edit.kind + " (line " + std::to_string(edit.first) + " to " +
                std::to_string(edit.last) + ", " + edit.text.lines[edit.first - 1] + "): " +
                (v.passed ? "passed\n" : "elsewhere: " + findingsText(v).substr(0, 160) + "\n");
  }
  int tried = 0;
  for (const auto& [kind, count] : table) {
    tried += count.tried;
    std::cout << GetParam() << " | " << kind << " | " << count.tried << " | " << count.refused
              << " | " << count.reported << "\n";
  }
  EXPECT_GT(tried, 0);
  EXPECT_EQ(missed, "");
}

TEST_P(StatementMutants, HarmlessEditsRaiseNoAlarm) {
  const int edits = test::ofSeeds(60, 300);
  std::mt19937_64 random(81);
  const std::vector<test::Mutation> all = test::harmlessMutations(GetParam());
  int alarms = 0, applied = 0;
  std::string reported;
  for (int i = 0; applied < edits && i < 3 * edits; ++i) {
    const test::Mutation& mutation = all[static_cast<std::size_t>(i) % all.size()];
    test::Subject s{whole_, read_, made_.scene.process};
    const auto line = mutation.apply(s, 0, random);
    if (!line)
      continue;
    ++applied;
    const Verification v = verify(test::read(s.text, made_.tooling));
    if (v.passed && v.findings.size() == remarks_)
      continue;
    ++alarms;
    reported += mutation.kind + ": " + s.text.lines[*line - 1] + "\n" + replay::findingsText(v);
  }
  EXPECT_EQ(applied, edits);
  EXPECT_EQ(alarms, 0) << reported;
}

std::vector<std::string> statingIds() {
  std::vector<std::string> ids;
  for (const program::Dialect& dialect : program::dialects())
    if (!dialect.events.empty())
      ids.emplace_back(dialect.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Replay, StatementMutants, ::testing::ValuesIn(statingIds()),
                         [](const auto& i) {
                           return std::regex_replace(i.param, std::regex("-"), "_");
                         });

} // namespace
} // namespace voluta::replay
