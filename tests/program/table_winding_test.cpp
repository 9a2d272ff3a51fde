// A table that is wound back in travels: by how many turns, and the statements of programs for it.
#include "program_fixture.h"

#include "base/error.h"
#include "program/dialect.h"
#include "program/gcode/gcode_bc.h"
#include "program/gcode/table_winding.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace voluta::program {
namespace {

constexpr double kTwoPi = 2.0 * base::kPi;

std::vector<AngleRange> inTurns(std::initializer_list<std::pair<double, double>> stretches) {
  std::vector<AngleRange> all;
  for (const auto& [low, high] : stretches)
    all.push_back({low * kTwoPi, high * kTwoPi});
  return all;
}

// By hand: within two turns to a side.
TEST(Windings, AreAsFewAndAsSmallAsCanBe) {
  using Turns = std::vector<int>;
  EXPECT_EQ(windings({}, kTwoPi), Turns{});
  EXPECT_EQ(windings(inTurns({{0, 1}, {-2, 2}, {1, 2}}), 2 * kTwoPi), (Turns{0, 0, 0}));
  // On and on: its start is free, then it turns as far as one number does.
  EXPECT_EQ(windings(inTurns({{0, 1.5}, {1.5, 2.5}, {2.5, 4}, {4, 5.5}}), 2 * kTwoPi),
            (Turns{-2, -2, -2, -4}));
  EXPECT_EQ(windings(inTurns({{0, 1}, {1, 3}, {0.5, 3}}), 2 * kTwoPi), (Turns{-1, -1, -1}));
  // By no more than it must: from -2 to 0, though 1 would do as well.
  EXPECT_EQ(windings(inTurns({{0, 4}, {-1.5, 0.5}}), 2 * kTwoPi), (Turns{-2, 0}));
  EXPECT_EQ(windings(inTurns({{-5.25, -4.5}}), 2 * kTwoPi), (Turns{4}));
  // A range wider than the limits is centred next to 0.
  EXPECT_EQ(windings(inTurns({{10, 16}, {16, 17}}), 2 * kTwoPi), (Turns{-13, -15}));
}

TEST(Windings, MinRevolutionsLetAllFit) {
  EXPECT_EQ(minRevolutions({}), 1);
  EXPECT_EQ(minRevolutions(inTurns({{0, 1}, {7.2, 8}})), 1);
  EXPECT_EQ(minRevolutions(inTurns({{0.3, 2.4}})), 2);   // -0.7 .. 1.4 needs 1.4
  EXPECT_EQ(minRevolutions(inTurns({{10.0, 14.0}})), 2); // -2 .. 2
  EXPECT_EQ(minRevolutions(inTurns({{10.1, 14.1}})), 3);
}

// Random stretches: within the range, and no number of windings is less (all numbers tried).
TEST(Windings, StayWithinAndAreFewest) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int round = 0; round < 300; ++round) {
    const double maximum = kTwoPi * (1.0 + std::floor(3.0 * std::abs(unit(random))));
    std::vector<AngleRange> stretches;
    double at = 3.0 * unit(random);
    for (int i = 0; i < 14; ++i) {
      const double to = at + 0.9 * maximum * unit(random);
      const double spread = 0.2 * maximum * std::abs(unit(random));
      stretches.push_back({std::min(at, to) - (i % 3 ? 0.0 : spread), std::max(at, to)});
      at = to;
    }
    const int minimum = minRevolutions(stretches);
    const double limit = std::max(maximum, minimum * kTwoPi);
    const std::vector<int> turns = windings(stretches, limit);
    constexpr int kMax = 12;
    // fewest[k]: windings up to here with k - kMax turns added.
    std::vector<int> fewest(2 * kMax + 1, 0);
    int mine = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const auto fits = [&](int k) {
        return stretches[i].lowest + k * kTwoPi >= -limit - 1e-6 &&
               stretches[i].highest + k * kTwoPi <= limit + 1e-6;
      };
      EXPECT_TRUE(fits(turns[i]));
      mine += i > 0 && turns[i] != turns[i - 1];
      const int best = *std::ranges::min_element(fewest) + (i > 0 ? 1 : 0);
      for (int k = -kMax; k <= kMax; ++k) {
        int& now = fewest[static_cast<std::size_t>(k + kMax)];
        now = fits(k) ? std::min(now, best) : 1000;
      }
    }
    EXPECT_EQ(mine, *std::ranges::min_element(fewest)) << round;
  }
}

class Winding : public test::Programs {
protected:
  ProgramInput with(double turns, const char* sense) const {
    ProgramInput in = input();
    in.options.own["tableUnwind"] = std::string("wind");
    in.options.own["tableTurns"] = turns;
    in.options.own["tableSense"] = std::string(sense);
    return in;
  }
  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) const {
    return readProgram("gcode-bc", files, process::Tooling(process_));
  }
};

std::vector<double> anglesOf(const std::string& text) {
  std::vector<double> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t at = line.find(" C"); line.starts_with("G1 ") && at != std::string::npos)
      all.push_back(std::stod(line.substr(at + 2)));
  return all;
}

// C keeps within its range on every line, and the nozzle on the part is where it is without.
TEST_F(Winding, KeepsCWithinAndThePartAsItIs) {
  for (const unsigned seed : {1u, 2u}) {
    trajectory_ = {};
    plan_ = {};
    appendTurning(seed, 15);
    for (const char* sense : {"part", "tool"})
      for (const double turns : {0.0, 1.5, 3.0}) {
        SCOPED_TRACE(testing::Message() << seed << " " << sense << " " << turns);
        ProgramInput counts = with(1000.0, sense); // it counts on
        counts.options.own["tableUnwind"] = std::string("count");
        const plan::ReadProgram on = read(writeProgram("gcode-bc", counts).files);
        const plan::Program program = writeProgram("gcode-bc", with(turns, sense));
        const plan::ReadProgram back = read(program.files);
        for (const auto& d : back.defects)
          ADD_FAILURE() << d.line << ": " << base::english(d.reason);
        EXPECT_TRUE(back.complete);
        const auto c = anglesOf(program.files[0].text);
        const double maximum = std::abs(
            *std::ranges::max_element(c, {}, [](double degrees) { return std::abs(degrees); }));
        EXPECT_LE(maximum, 360.0 * (turns > 0.0 ? turns : 2.0) + 1e-4);
        const auto unwound = anglesOf(writeProgram("gcode-bc", counts).files[0].text);
        EXPECT_GT(std::abs(unwound.back()), 3.0 * 360.0) << "else nothing is tried";
        std::vector<plan::ProgramMotion> own;
        std::size_t detours = 0;
        for (const plan::ProgramMotion& m : back.motions)
          if (m.detour) {
            ++detours;
            EXPECT_FALSE(m.extruding);
          } else {
            own.push_back(m);
          }
        EXPECT_GE(detours, 3u);
        ASSERT_EQ(own.size(), on.motions.size());
        for (std::size_t m = 0; m < own.size(); ++m) {
          EXPECT_LT((own[m].position - on.motions[m].position).norm(), 2e-4);
          EXPECT_LT((own[m].direction - on.motions[m].direction).norm(), 1e-6);
          EXPECT_EQ(own[m].durationS, on.motions[m].durationS);
          EXPECT_EQ(own[m].viaPoints.size(), on.motions[m].viaPoints.size());
        }
      }
  }
}

TEST_F(Winding, RefusesTurnsBeyondTheLimitWithinAPath) {
  std::vector<double> q = {0.1, -1.9, 1.7, -1.2, -1.4, 0.0};
  append(plan::MoveKind::Joint, q, 1.0, 0.0);
  for (int i = 0; i < 200; ++i) {
    q[5] += 0.1;
    append(plan::MoveKind::Print, q, 0.1, 0.3);
  }
  EXPECT_NO_THROW(writeProgram("gcode-bc", with(2.0, "part")));
  try {
    writeProgram("gcode-bc", with(1.0, "part"));
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("1 turns"), std::string::npos) << e.what();
  }
}

// Each line of a winding is needed: without it, or with another number, it is no winding, and the
// remaining lines are a motion that no plan has.
TEST_F(Winding, IsReadOnlyWhole) {
  appendTurning(2, 15);
  const plan::Program program = writeProgram("gcode-bc", with(2.0, "part"));
  const plan::ReadProgram whole = read(program.files);
  std::vector<std::string> lines;
  std::istringstream text(program.files[0].text);
  for (std::string line; std::getline(text, line);)
    lines.push_back(line);
  std::size_t tried = 0;
  const auto detours = [](const plan::ReadProgram& p) {
    return std::ranges::count_if(p.motions, [](const auto& m) { return m.detour; });
  };
  for (std::size_t m = 0; m < whole.motions.size(); ++m) {
    if (!whole.motions[m].detour)
      continue;
    const std::size_t line = whole.motions[m].line - 1;
    const auto changed = [&](const std::string& by) {
      std::string all;
      for (std::size_t l = 0; l < lines.size(); ++l)
        if (l != line || !by.empty())
          all += (l == line ? by : lines[l]) + "\n";
      return read({{program.files[0].name, all}});
    };
    const auto moved = [&](char word) {
      std::string by = lines[line];
      const std::size_t at = by.find(std::string(" ") + word) + 2;
      const double value = std::stod(by.substr(at));
      return by.substr(0, at) + std::to_string(value + 1.5) + by.substr(by.find(' ', at));
    };
    for (const char word : {'X', 'Y', 'Z', 'B', 'C'})
      EXPECT_LT(detours(changed(moved(word))), detours(whole)) << word << ": " << lines[line];
    const plan::ReadProgram fewer = changed("");
    EXPECT_LT(detours(fewer), detours(whole)) << lines[line];
    std::string prints = lines[line];
    prints.insert(prints.find(" F"), " E9999");
    EXPECT_LT(detours(changed(prints)), detours(whole)) << lines[line];
    if (++tried == 6)
      break;
  }
  EXPECT_GE(tried, 6u);
}

} // namespace
} // namespace voluta::program
