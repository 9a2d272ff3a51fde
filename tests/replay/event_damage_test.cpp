// Every kind of event before a layer in a program of every dialect: it is written, read back and
// judged fine, or refused before it is written; and every kind of damage to its lines is refused.
#include "base/error.h"
#include "helpers/all_seeds.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/own_lines.h"
#include "program/refused_statements.h"
#include "replay/event_damage.h"
#include "replay/event_programs.h"
#include "replay/mutations.h"
#include "replay/told.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace voluta::replay {
namespace {

using plan::EventKind, plan::TrajectoryEvent;

constexpr EventKind kKinds[] = {EventKind::Pause, EventKind::Wait, EventKind::Output,
                                EventKind::Statement};

class EventDamages : public ::testing::TestWithParam<std::string> {
protected:
  EventDamages() : dialect_(program::findDialect(GetParam())) {}

  bool has(EventKind kind) const { return program::hasWordFor(dialect_, kind); }
  // Points before the second and the third layer, behind a lift.
  std::vector<std::size_t> places() const {
    const plan::Trajectory& t = scene_.trajectory;
    std::vector<std::size_t> points;
    for (std::size_t i = 1; i + 2 < t.pointCount(); ++i)
      if (t.move[i] == plan::MoveKind::Print && t.move[i + 1] != plan::MoveKind::Print)
        points.push_back(i + 2);
    return points;
  }
  void addAll() {
    const std::vector<std::size_t> points = places();
    ASSERT_GE(points.size(), 3u);
    const int output = program::outputWords(GetParam()).first + 4;
    const auto add = [&](std::size_t point, TrajectoryEvent event) {
      event.point = point;
      if (has(event.kind))
        scene_.trajectory.events.push_back(std::move(event));
    };
    const std::size_t first = points[0], second = points[points.size() / 2];
    add(first, {.kind = EventKind::Output, .tool = output, .on = true});
    add(first, {.kind = EventKind::Pause, .text = "Put in the nut (layer 2 of 3, z 2.00 mm)"});
    add(first, {.kind = EventKind::Wait, .seconds = 20.0});
    add(first, {.kind = EventKind::Statement, .text = "own_call(1)", .format = GetParam()});
    // A photo.
    add(second, {.kind = EventKind::Output, .tool = output + 1, .on = true});
    add(second, {.kind = EventKind::Wait, .seconds = 0.5});
    add(second, {.kind = EventKind::Output, .tool = output + 1, .on = false});
    add(second, {.kind = EventKind::Output, .tool = output, .on = false});
    add(second, {.kind = EventKind::Pause, .text = "Turn the plate (layer 3 of 3, z 3.00 mm)"});
  }
  plan::Program written() const {
    return program::writeProgram(GetParam(),
                                 {scene_.plan, scene_.trajectory, scene_.cell, tooling_, "box"});
  }
  Verification verify(plan::ReadProgram program) const {
    return replayProgram({std::move(program), scene_.plan, scene_.trajectory, scene_.cell, tooling_,
                          scene_.part, scene_.platform},
                         ReplayThresholds{}, {});
  }

  const program::Dialect& dialect_;
  test::Scene scene_ = test::boxScene(3, test::cellFor(GetParam()));
  process::Tooling tooling_{scene_.process};
};

TEST_P(EventDamages, AnEventWithoutWordsIsRefusedBeforehand) {
  const std::size_t point = places().front();
  for (const EventKind kind : kKinds) {
    if (has(kind))
      continue;
    scene_.trajectory.events = {{.point = point,
                                 .kind = kind,
                                 .tool = 3,
                                 .seconds = 5.0,
                                 .text = "own_call(1)",
                                 .format = GetParam()}};
    try {
      written();
      ADD_FAILURE() << GetParam() << " writes " << program::nameOf(kind).english();
    } catch (const base::Error& error) {
      EXPECT_NE(base::english(error.whole()).find(program::nameOf(kind).english()),
                std::string::npos)
          << base::english(error.whole());
    }
  }
}

TEST_P(EventDamages, ARoutineOfTheUserIsNoFileOfTheProgram) {
  if (!has(EventKind::Statement))
    GTEST_SKIP() << GetParam() << " has no statements";
  const auto filesOf = [&] {
    const plan::Program program = written();
    return program::continuationFiles(dialect_, program.files.front().text);
  };
  const std::vector<std::string> before = filesOf();
  for (const char* call : {"own_routine()", "Call own_routine"}) {
    if (program::refusedWord(GetParam(), call))
      continue; // no routine is called like this
    scene_.trajectory.events = {{.point = places().front(),
                                 .kind = EventKind::Statement,
                                 .text = call,
                                 .format = GetParam()}};
    EXPECT_EQ(filesOf(), before) << call;
  }
}

// Whatever a user or a slicer's file writes.
TEST_P(EventDamages, TextsAreReadBackAsTheyAreWritten) {
  if (!has(EventKind::Pause))
    GTEST_SKIP() << GetParam() << " has no stops";
  std::vector<std::string> texts = {"Größe prüfen – Élève °", "Пауза", "P 5", "S1 *M30 ; G1 X1",
                                    "/* 'it' // # ! ' */"};
  for (int first = ' '; first <= '~'; first += 16) {
    std::string text = "a";
    for (int c = first; c < first + 16 && c <= '~'; ++c)
      text += std::string(1, static_cast<char>(c)) + (c % 3 == 0 ? "5 " : "b");
    texts.push_back(text);
  }
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    scene_.trajectory.events = {
        {.point = places().front(), .kind = EventKind::Pause, .text = text + " (layer 2 of 3)"}};
    const Verification v = verify(test::read(test::textOf(written()), tooling_));
    EXPECT_TRUE(v.passed) << findingsText(v);
  }
}

// Returns the lines from the first to the last that differ.
std::string differing(const test::ProgramText& whole, const test::ProgramText& other) {
  const std::vector<std::string>&a = whole.lines, &b = other.lines;
  std::size_t first = 0, common = 0;
  while (first < std::min(a.size(), b.size()) && a[first] == b[first])
    ++first;
  while (common < std::min(a.size(), b.size()) - first &&
         a[a.size() - 1 - common] == b[b.size() - 1 - common])
    ++common;
  std::string lines;
  for (std::size_t i = first; i < b.size() - common; ++i)
    lines += "  " + b[i];
  return lines;
}

// Lines that a controller may run twice, or not at all, without any change.
bool isIdle(const std::string& line) {
  static const std::regex kIdle(R"(^\s*([0-9]+ )?(M400|WAIT SEC 0|QueueTag\(1,1\))\s*$)");
  return std::regex_search(line, kIdle);
}
// Returns whether a line only shows a text, and does not stop.
bool showsOnly(const std::string& line) {
  return line.find("MsgNotify") != std::string::npos || line.find("  Print \"") == 0;
}
// Damage that changes nothing that the robot does: of a line that only waits for the arm, since
// readers demand one before each line that needs it; a message on the screen that is shown earlier
// in its stop or beside another; blanks that a controller skips.
// `changed`: the lines that differ.
bool isEquivalent(const test::EventDamage& damage, const std::string& changed) {
  static const std::regex kStopBesideSpeed(R"(^(\s*(HALT|\$VEL\.CP=[0-9.]+)\s)+$)");
  const bool isEarlier =
      damage.kind == "within the stop" || damage.kind == "exchanged with the next line";
  const bool opens = damage.line.find("Open \"COM1:\"") != std::string::npos;
  return isIdle(damage.line) || (isEarlier && std::regex_match(changed, kStopBesideSpeed)) ||
         (isEarlier && (opens || showsOnly(damage.line))) ||
         (showsOnly(damage.line) && damage.kind == "copied to another stop") ||
         (damage.kind == "text begins with a blank" && damage.line.starts_with("M0 "));
}

TEST_P(EventDamages, AreAllRefused) {
  addAll();
  if (scene_.trajectory.events.empty())
    GTEST_SKIP() << GetParam() << " has no events before layers";
  const test::ProgramText whole = test::textOf(written());
  const plan::ReadProgram sound = test::read(whole, tooling_);
  const Verification v = verify(sound);
  ASSERT_TRUE(v.passed) << findingsText(v);

  std::vector<std::size_t> motions;
  for (const plan::ProgramMotion& motion : sound.motions)
    motions.push_back(motion.line - 1);
  std::vector<test::EventBlock> blocks;
  for (std::size_t m = sound.firstMotion + 1; m < sound.motions.size(); ++m) {
    const auto isHere = [&](const auto& stated) { return stated.before == m; };
    const bool hasFact = std::ranges::any_of(sound.facts, [&](const plan::StatedFact& fact) {
      return isHere(fact) && (fact.kind == plan::FactKind::OperatorStop ||
                              fact.kind == plan::FactKind::OwnStatement);
    });
    const bool waits = std::ranges::any_of(sound.pauses, [&](const plan::ProgramPause& pause) {
      return isHere(pause) && pause.durationS > 10.0;
    });
    if (hasFact || waits)
      blocks.push_back({motions[m - 1] + 1, motions[m]});
  }
  ASSERT_EQ(blocks.size(), has(EventKind::Pause) ? 2u : 1u);

  struct Count {
    int tried = 0, refused = 0, equivalent = 0;
  };
  std::map<std::string, Count> table;
  std::string missed;
  const std::vector<test::EventDamage> damages = test::eventDamage(whole, blocks, motions);
  std::map<std::string, int> ofKind, seen;
  for (const test::EventDamage& damage : damages)
    ++ofKind[damage.kind];
  constexpr int kFew = 1;     // of each kind
  bool isDefectTried = false; // each defect refuses a program, which takes long to replay
  const auto isRefused = [&](plan::ReadProgram read) {
    if (!read.defects.empty() && std::exchange(isDefectTried, true))
      return true;
    return !verify(std::move(read)).passed;
  };
  for (const test::EventDamage& damage : damages) {
    // Evenly among those of its kind.
    const int all = ofKind[damage.kind], few = std::min(test::ofSeeds(kFew, all), all),
              k = seen[damage.kind]++;
    if (k * few / all == (k + 1) * few / all)
      continue;
    Count& count = table[damage.kind];
    ++count.tried;
    if (isRefused(test::read(damage.text, tooling_)))
      ++count.refused;
    else if (isEquivalent(damage, differing(whole, damage.text)))
      ++count.equivalent;
    else
      missed += damage.kind + ": " + damage.line + "\n" + differing(whole, damage.text);
  }
  std::cout << "format | damage | tried | refused | equivalent\n";
  for (const auto& [kind, count] : table)
    std::cout << GetParam() << " | " << kind << " | " << count.tried << " | " << count.refused
              << " | " << count.equivalent << "\n";
  EXPECT_GE(table.size(), has(EventKind::Pause) ? 30u : 15u);
  EXPECT_EQ(missed, "");
}

std::vector<std::string> allIds() {
  std::vector<std::string> ids;
  for (const program::Dialect& dialect : program::dialects())
    ids.emplace_back(dialect.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Replay, EventDamages, ::testing::ValuesIn(allIds()), [](const auto& i) {
  return std::regex_replace(i.param, std::regex("-"), "_");
});

} // namespace
} // namespace voluta::replay
