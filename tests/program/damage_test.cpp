// No damage to a text goes unseen, and none brings a reader down.
#include "program_fixture.h"

#include "program/dialect.h"

#include <algorithm>
#include <random>

namespace voluta::program {
namespace {

// On a cell with a plate, and (true) on one with a rod.
class Damage : public test::Programs, public ::testing::WithParamInterface<bool> {
protected:
  void SetUp() override {
    Programs::SetUp();
    if (GetParam()) {
      useRod();
      appendRandomOnRod(12, 120);
    } else {
      appendRandom(12, 120);
    }
  }

  static std::vector<Dialect> ofThisCell() {
    std::vector<Dialect> all = dialects();
    std::erase_if(all, [](const Dialect& d) { return GetParam() && !d.turnsRods; });
    return all;
  }
  static std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      lines.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    return lines;
  }
  static std::string textOf(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
      text += line + "\n";
    return text;
  }

  static bool sameMotion(const plan::ProgramMotion& a, const plan::ProgramMotion& b) {
    return a.target == b.target && a.jointInterpolated == b.jointInterpolated &&
           a.joints == b.joints && a.externals == b.externals &&
           a.frame_T_tcp.matrix() == b.frame_T_tcp.matrix() && a.position == b.position &&
           a.direction == b.direction && a.speedMmPerS == b.speedMmPerS &&
           a.jointSpeedRadPerS == b.jointSpeedRadPerS && a.durationS == b.durationS &&
           a.blendMm == b.blendMm && a.extruding == b.extruding && a.flowMm3PerS == b.flowMm3PerS &&
           a.volumeMm3 == b.volumeMm3;
  }
  static bool seen(const plan::ReadProgram& whole, const plan::ReadProgram& damaged) {
    if (!damaged.defects.empty() || !damaged.complete ||
        damaged.motions.size() != whole.motions.size() ||
        damaged.flange_T_tcp.matrix() != whole.flange_T_tcp.matrix())
      return true;
    for (std::size_t i = 0; i < whole.motions.size(); ++i)
      if (!sameMotion(whole.motions[i], damaged.motions[i]))
        return true;
    return false;
  }

  // Lines that mean nothing to what is printed, each with its reason.
  static bool idle(const std::vector<std::string>& lines, std::size_t i) {
    const std::string& line = lines[i];
    const std::size_t first = line.find_first_not_of(' ');
    if (line == "# end" || line == "; end")
      return false;
    // Nothing to say where no motion is one that it is about.
    if (line.find("ConfJ") != std::string::npos)
      return std::none_of(lines.begin(), lines.end(), [](const std::string& other) {
        return other.find("MoveJ ") != std::string::npos;
      });
    if (line[first] == '#' || line[first] == ';' || line[first] == '!')
      return true;                                                          // comments
    for (const char* word : {"set_payload", "sleep(",                       // not motion
                             "G21", "G90", "M82", "G28", "M104 S2", "M109", // the default, or heat
                             "G92 E0"}) // E starts at 0, or behind the prime
      if (line.find(word) != std::string::npos)
        return line != "G92 E0" || lines[i - 1].find("prime") == std::string::npos;
    // The prime, and outputs that say what already holds, are no part of a path.
    if (line.find("; prime") != std::string::npos)
      return true;
    for (std::size_t k = i; k-- > 0 && i - k <= 4;)
      if (lines[k].find(" prime") != std::string::npos)
        return true;
    return false;
  }
};

TEST_P(Damage, noLineIsMissedUnnoticed) {
  for (const Dialect& d : ofThisCell()) {
    const plan::Program program = writeProgram(d.id, input());
    const plan::ReadProgram whole = readProgram(d.id, program.files, process_);
    const auto lines = linesOf(program.files[0].text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (idle(lines, i))
        continue;
      auto fewer = lines;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      const auto damaged = readProgram(d.id, {{"damaged", textOf(fewer)}}, process_);
      EXPECT_TRUE(seen(whole, damaged)) << d.id << " without line " << i + 1 << ": " << lines[i];
    }
  }
}

TEST_P(Damage, noDigitChangesUnnoticed) {
  std::mt19937_64 random(21);
  for (const Dialect& d : ofThisCell()) {
    const plan::Program program = writeProgram(d.id, input());
    const plan::ReadProgram whole = readProgram(d.id, program.files, process_);
    const auto lines = linesOf(program.files[0].text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (idle(lines, i) ||
          (lines[i].find("mov") == std::string::npos && lines[i].find("Move") == std::string::npos))
        continue;
      auto changed = lines;
      std::string& line = changed[i];
      // The target: in RAPID what stands before the configuration.
      const std::size_t from = line.find('['), second = line.find("],[");
      const std::size_t end = std::min(
          {line.size(), line.find(",a="), line.find("],[", second + 1), line.find("\\NoEOffs")});
      std::size_t at = from + random() % (end - from);
      while (line[at] < '0' || line[at] > '9')
        at = from + random() % (end - from);
      line[at] = line[at] == '9' ? '1' : static_cast<char>(line[at] + 1);
      const auto damaged = readProgram(d.id, {{"damaged", textOf(changed)}}, process_);
      EXPECT_TRUE(seen(whole, damaged)) << line;
    }
  }
}

TEST_P(Damage, everyCutIsNoticed) {
  for (const Dialect& d : ofThisCell()) {
    const plan::Program program = writeProgram(d.id, input());
    const std::string& text = program.files[0].text;
    for (std::size_t length = 0; length + 1 < text.size(); length += 1 + length % 7) {
      const auto damaged = readProgram(d.id, {{"cut", text.substr(0, length)}}, process_);
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
    const std::string text = writeProgram(d.id, input()).files[0].text;
    for (int round = 0; round < 400; ++round) {
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
      // Every reader on every text: none may throw, and what it gives is finite.
      for (const Dialect& reader : dialects()) {
        const auto read = readProgram(reader.id, {{"bad", bad}}, process_);
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
