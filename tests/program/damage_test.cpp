// Every damage to a text is detected, and none crashes a reader.
#include "program_fixture.h"

#include "helpers/all_seeds.h"
#include "program/dialect.h"
#include "program/text_damage.h"
#include "replay/heat_facts.h"
#include "replay/required_facts.h"

#include <algorithm>
#include <random>

namespace voluta::program {
namespace {

// On a cell with a plate, and (true) on one with a rod.
class Damage : public test::Programs, public ::testing::WithParamInterface<bool> {
protected:
  void SetUp() override {
    Programs::SetUp();
    if (GetParam())
      useRod();
  }
  void pathFor(const Dialect& d) {
    if (!GetParam()) {
      randomFor(d, 12, 120);
    } else if (trajectory_.timeS.empty()) {
      appendRandomOnRod(12, 120);
    }
  }

  static std::vector<Dialect> ofThisCell() {
    std::vector<Dialect> all = dialects();
    std::erase_if(all, [](const Dialect& d) { return GetParam() && !d.supportsExternalAxes; });
    return all;
  }
  // Does the replay find fault with the statements of the program beside its motions?
  bool misstates(const plan::ReadProgram& program) const {
    const replay::Alignment none{.pointOf = std::vector(program.motions.size(), replay::kUnmatched),
                                 .leadsTo = {},
                                 .deviations = {}};
    const process::Tooling tooling(process_);
    return !replay::compareStatedFacts(program, trajectory_, none, *cell_, tooling).empty() ||
           !replay::compareHeat(program, trajectory_, tooling).empty();
  }
  bool seen(const plan::ReadProgram& whole, const plan::ReadProgram& damaged) const {
    EXPECT_FALSE(misstates(whole)) << whole.format;
    if (!damaged.defects.empty() || !damaged.complete ||
        damaged.motions.size() != whole.motions.size() ||
        damaged.flange_T_tcp.matrix() != whole.flange_T_tcp.matrix() || misstates(damaged))
      return true;
    for (std::size_t i = 0; i < whole.motions.size(); ++i)
      if (!test::sameMotion(whole.motions[i], damaged.motions[i]))
        return true;
    return false;
  }

  // Lines without effect on the print: remarks but the mark at the end, and those that the dialect
  // names.
  static bool idle(const Dialect& dialect, const std::vector<std::string>& lines, std::size_t i) {
    const std::string& line = lines[i];
    const std::size_t first = line.find_first_not_of(' ');
    if (line.substr(first).starts_with(dialect.remark))
      return i + 1 < lines.size();
    return dialect.mayBeMissing && dialect.mayBeMissing(lines, i);
  }
};

TEST_P(Damage, noLineIsMissedUnnoticed) {
  for (const Dialect& d : ofThisCell()) {
    pathFor(d);
    const plan::Program program = writeProgram(d.id, input());
    const plan::ReadProgram whole = readProgram(d.id, program.files, process::Tooling(process_));
    const test::ProgramText text = test::textOf(program);
    for (std::size_t i = 0; i < text.lines.size(); ++i) {
      if (idle(d, text.lines, i))
        continue;
      test::ProgramText fewer = text;
      fewer.lines.erase(fewer.lines.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_TRUE(seen(whole, test::read(fewer, process_)))
          << d.id << " without line " << i + 1 << ": " << text.lines[i];
    }
  }
}

// In each motion's line the numbers of its target are found by a change too small to be refused;
// then a digit of each is changed.
TEST_P(Damage, noDigitChangesUnnoticed) {
  constexpr double kHardly = 1e-6;
  constexpr std::size_t kEach = 3;
  // Five axes of a table, three without one; six of an arm's target or of a nozzle with direction.
  const auto targetNumbers = [](const Dialect& d) -> std::size_t {
    return !d.tiltsNozzle ? 3 : d.id == "gcode-bc" ? 5 : 6;
  };
  std::mt19937_64 random(21);
  for (const Dialect& d : ofThisCell()) {
    pathFor(d);
    const plan::Program program = writeProgram(d.id, input());
    const plan::ReadProgram whole = readProgram(d.id, program.files, process::Tooling(process_));
    test::ProgramText text = test::textOf(program);
    for (std::size_t i = 1; i < whole.motions.size(); i += kEach) {
      std::string& line = text.lines[whole.motions[i].line - 1];
      const std::string as = line;
      std::size_t found = 0;
      for (const auto& where : test::numbersIn(as)) {
        line = test::withNumber(as, where, std::stod(as.substr(where.first)) + kHardly);
        const plan::ReadProgram moved = test::read(text, process_);
        if (!moved.defects.empty() || moved.motions.size() != whole.motions.size() ||
            test::sameTarget(moved.motions[i], whole.motions[i]))
          continue;
        ++found;
        line = as;
        std::size_t at = where.first;
        do
          at = where.first + random() % (where.second - where.first);
        while (line[at] < '0' || line[at] > '9');
        line[at] = line[at] == '9' ? '1' : static_cast<char>(line[at] + 1);
        EXPECT_TRUE(seen(whole, test::read(text, process_))) << d.id << ": " << line;
      }
      line = as;
      EXPECT_GE(found, targetNumbers(d)) << d.id << ": " << as;
    }
  }
}

TEST_P(Damage, everyCutIsNoticed) {
  for (const Dialect& d : ofThisCell()) {
    pathFor(d);
    const plan::Program program = writeProgram(d.id, input());
    const std::string& text = program.files[0].text;
    // Without its last line's end a text is whole.
    const std::size_t last = text.find_last_not_of("\r\n");
    const std::size_t step = test::ofSeeds<std::size_t>(1 + last / 60, 1);
    for (std::size_t length = 0; length <= last; length += step + length % 7) {
      const auto damaged =
          readProgram(d.id, {{"cut", text.substr(0, length)}}, process::Tooling(process_));
      EXPECT_FALSE(damaged.complete) << d.id << " cut to " << length;
      EXPECT_FALSE(damaged.defects.empty());
    }
  }
}

TEST_P(Damage, noGarbageBringsAReaderDown) {
  std::mt19937_64 random(33);
  constexpr char kSpice[] = "\0\n\r\t ()[],=+-.eEpnNXYZG01#;\"*\xff\x80";
  const std::string_view spice(kSpice, sizeof kSpice - 1); // it holds a zero
  for (const Dialect& d : ofThisCell()) {
    pathFor(d);
    const std::string text = writeProgram(d.id, input()).files[0].text;
    for (int round = 0; round < test::ofSeeds(60, 400); ++round) {
      std::string bad = text;
      const int hits = 1 + static_cast<int>(random() % 40);
      for (int k = 0; k < hits; ++k) {
        const std::size_t at = random() % bad.size();
        switch (random() % 4) {
        case 0:
          bad[at] = spice[random() % spice.size()];
          break;
        case 1:
          bad.erase(at, random() % 30);
          break;
        case 2:
          bad.insert(at, 1 + random() % 5, spice[random() % spice.size()]);
          break;
        default:
          bad.insert(at, bad.substr(random() % bad.size(), random() % 60));
        }
        if (bad.empty())
          bad.push_back('x');
      }
      // Every reader on every text: none may throw, and its results are finite.
      for (const Dialect& reader : dialects()) {
        const auto read = readProgram(reader.id, {{"bad", bad}}, process::Tooling(process_));
        for (const plan::ProgramMotion& m : read.motions) {
          ASSERT_TRUE(m.frame_T_tcp.matrix().allFinite() && m.position.allFinite() &&
                      m.direction.allFinite() && std::isfinite(m.speedMmPerS) &&
                      std::isfinite(m.volumeMm3) && std::isfinite(m.durationS));
          ASSERT_NEAR(m.direction.norm(), 1.0, 1e-9);
        }
      }
      detectDialect("bad", bad);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cells, Damage, ::testing::Bool(),
                         [](const auto& cell) { return cell.param ? "rod" : "plate"; });

} // namespace
} // namespace voluta::program
