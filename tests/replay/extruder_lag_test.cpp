// Programs for extruders that lag: read back, run and judged in every dialect that can state them;
// programs without the lags are refused. Statements of the process at the ends of beads.
#include "replay/extruder_lag.h"

#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/dialects_for.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

constexpr double kStartS = 0.4, kStopS = 0.2;
constexpr std::size_t kStopPoints = 4; // of 50 ms

struct Bead {
  std::size_t first = 0, end = 0; // points
};
std::vector<Bead> beadsOf(const plan::Trajectory& t) {
  std::vector<Bead> beads;
  for (std::size_t i = 1; i < t.pointCount(); ++i)
    if (t.move[i] == plan::MoveKind::Print) {
      if (t.move[i - 1] != plan::MoveKind::Print)
        beads.push_back({i, i});
      beads.back().end = i + 1;
    }
  return beads;
}

class ExtruderLag : public ::testing::Test {
protected:
  void SetUp() override {
    scene_.process.lag = {kStartS, kStopS};
    for (const Bead& bead : beadsOf(scene_.trajectory)) {
      scene_.trajectory.events.push_back(
          {.point = bead.first, .kind = plan::EventKind::StartLag, .seconds = kStartS});
      scene_.trajectory.events.push_back(
          {.point = bead.end - kStopPoints, .kind = plan::EventKind::StopLag});
    }
  }
  std::vector<program::Dialect> dialects() const {
    std::vector<program::Dialect> all = test::dialectsFor("urscript");
    std::erase_if(all, [&](const program::Dialect& dialect) {
      return !dialect.tiltsNozzle ||
             program::refusal(dialect, scene_.cell, {}, &scene_.trajectory).has_value();
    });
    return all;
  }
  test::ProgramText textFor(std::string_view id) const {
    return test::textOf(program::writeProgram(id, {scene_.plan, scene_.trajectory, scene_.cell,
                                                   process::Tooling(scene_.process), "box"}));
  }
  Verification verify(const plan::ReadProgram& program, const process::Process& process) const {
    return replayProgram({program, scene_.plan, scene_.trajectory, scene_.cell,
                          process::Tooling(process), scene_.part, scene_.platform},
                         ReplayThresholds{}, {});
  }
  Verification verify(const plan::ReadProgram& program) const {
    return verify(program, scene_.process);
  }

  test::Scene scene_ = test::boxScene(2);
};

TEST_F(ExtruderLag, EveryDialectWithAnExtruderOfItsOwnKeepsThem) {
  std::size_t passed = 0;
  for (const program::Dialect& dialect : dialects()) {
    SCOPED_TRACE(dialect.id);
    ++passed;
    const plan::ReadProgram read = test::read(textFor(dialect.id), scene_.process);
    ASSERT_TRUE(read.defects.empty()) << base::english(read.defects[0].reason);
    const Verification v = verify(read);
    EXPECT_TRUE(v.passed) << findingsText(v);
    EXPECT_LE(v.flowErrorFraction, 0.01);
    const auto mass = std::ranges::find(v.results, "massRatio", &ThresholdResult::name);
    if (mass != v.results.end()) {
      EXPECT_NEAR(mass->value, 1.0, 0.01);
    }
  }
  EXPECT_GE(passed, 5u);
}

// A machine without the lags would print such a program with blobs and gaps.
TEST_F(ExtruderLag, AnExtruderWithoutLagsIsAnotherOne) {
  process::Process quick = scene_.process;
  quick.lag = {};
  EXPECT_FALSE(verify(test::read(textFor("urscript"), scene_.process), quick).passed);
  scene_.trajectory.events.clear();
  const plan::ReadProgram read = test::read(textFor("urscript"), scene_.process);
  EXPECT_TRUE(verify(read, quick).passed);
  EXPECT_FALSE(verify(read).passed) << "neither starts nor stops ahead";
}

// Forty edits of starts and stops, in a dialect chosen at random.
TEST_F(ExtruderLag, EveryEditIsRefused) {
  std::vector<plan::ReadProgram> programs;
  for (const program::Dialect& dialect : dialects())
    programs.push_back(test::read(textFor(dialect.id), scene_.process));
  std::mt19937 random(5);
  for (int edit = 0; edit < 40; ++edit) {
    plan::ReadProgram program = programs[random() % programs.size()];
    std::vector<std::size_t> starts, stops;
    for (std::size_t p = 0; p < program.pauses.size(); ++p)
      if (std::abs(program.pauses[p].durationS - kStartS) < 0.02 && program.pauses[p].before > 2)
        starts.push_back(p);
    for (std::size_t m = 1; m < program.motions.size(); ++m)
      if (program.motions[m - 1].flowMm3PerS > 0.0 && !(program.motions[m].flowMm3PerS > 0.0))
        stops.push_back(m);
    ASSERT_GE(starts.size(), 20u);
    ASSERT_GE(stops.size(), 20u);
    plan::ProgramPause& start = program.pauses[starts[random() % starts.size()]];
    const std::size_t stop = stops[random() % stops.size()];
    const auto kind = static_cast<int>(random() % 5);
    SCOPED_TRACE(program.format + " edit " + std::to_string(kind));
    if (kind == 0)
      program.pauses.erase(program.pauses.begin() + (&start - program.pauses.data()));
    else if (kind == 1)
      start.durationS *= 0.5, start.volumeMm3 *= 0.5;
    else if (kind == 2)
      start.volumeMm3 = 0.0; // switched on behind the wait
    else if (kind == 3)
      for (std::size_t m = stop;
           m < program.motions.size() &&
           program.motions[m].speedMmPerS + program.motions[m].durationS > 0.0 &&
           m < stop + kStopPoints;
           ++m) { // switched off with the bead
        program.motions[m].extruding = true;
        program.motions[m].flowMm3PerS = program.motions[stop - 1].flowMm3PerS;
      }
    else
      for (std::size_t m = stop - 5; m < stop; ++m) { // switched off too early
        program.motions[m].extruding = false;
        program.motions[m].flowMm3PerS = 0.0;
      }
    EXPECT_FALSE(verify(program).passed);
  }
}

class BeadWords : public ::testing::Test {
protected:
  void SetUp() override {
    scene_.process.beadWords = {
        {.format = "urscript",
         .start = {"set_standard_digital_out(3,True)", "sync()"},
         .end = {"set_standard_digital_out(3,False)"}},
        {.format = "rapid", .start = {"SetDO doArc,1;"}, .end = {"SetDO doArc,0;"}},
        {.format = "melfa", .start = {"M_Out(8)=1"}, .end = {"M_Out(8)=0"}}};
  }
  test::ProgramText textFor(std::string_view id) const {
    return test::textOf(program::writeProgram(id, {scene_.plan, scene_.trajectory, scene_.cell,
                                                   process::Tooling(scene_.process), "box"}));
  }
  Verification verify(const test::ProgramText& text) const {
    return replayProgram({test::read(text, scene_.process), scene_.plan, scene_.trajectory,
                          scene_.cell, process::Tooling(scene_.process), scene_.part,
                          scene_.platform},
                         ReplayThresholds{}, {});
  }
  test::Scene scene_ = test::boxScene(2);
};

TEST_F(BeadWords, AreStatedAtEveryBead) {
  const std::size_t beads = beadsOf(scene_.trajectory).size();
  for (const process::BeadWords& words : scene_.process.beadWords) {
    SCOPED_TRACE(words.format);
    const test::ProgramText text = textFor(words.format);
    for (const auto* statements : {&words.start, &words.end})
      for (const std::string& statement : *statements)
        EXPECT_EQ(std::ranges::count_if(text.lines,
                                        [&](const std::string& line) {
                                          const std::size_t at = line.find(statement);
                                          return at != std::string::npos &&
                                                 line.find_first_not_of(" 0123456789") == at;
                                        }),
                  static_cast<std::ptrdiff_t>(beads));
    const Verification v = verify(text);
    EXPECT_TRUE(v.passed) << findingsText(v);
  }
}

TEST_F(BeadWords, EveryEditIsRefused) {
  std::mt19937 random(7);
  for (int edit = 0; edit < 40; ++edit) {
    const process::BeadWords& words =
        scene_.process.beadWords[random() % scene_.process.beadWords.size()];
    test::ProgramText text = textFor(words.format);
    const std::string& statement = random() % 2 ? words.start.front() : words.end.front();
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < text.lines.size(); ++i)
      if (text.lines[i].find(statement) != std::string::npos)
        lines.push_back(i);
    ASSERT_FALSE(lines.empty());
    const std::size_t line = lines[random() % lines.size()];
    const auto at = text.lines.begin() + static_cast<std::ptrdiff_t>(line);
    const std::string whole = *at;
    const auto kind = static_cast<int>(random() % 3);
    SCOPED_TRACE(words.format + " edit " + std::to_string(kind) + " line " + std::to_string(line));
    if (kind == 0)
      text.lines.erase(at);
    else if (kind == 1)
      text.lines.insert(at, whole);
    else
      *at = whole.substr(0, whole.size() - 3) + "9" + whole.substr(whole.size() - 2);
    EXPECT_FALSE(verify(text).passed);
  }
}

} // namespace
} // namespace voluta::replay
