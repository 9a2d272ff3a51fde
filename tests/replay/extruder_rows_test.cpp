// Programs for every extruder that a dialect has words for beside its outputs (those are in
// mutation_test.cpp): the undamaged one passes, harm is refused at its line.
#include "helpers/all_seeds.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "program/stream/extruder_stream.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

namespace voluta::replay {
namespace {

struct Row {
  std::string dialect, extruder;
};
std::vector<Row> rows() {
  std::vector<Row> all;
  for (const program::Dialect& d : program::dialects())
    for (const std::string_view id : d.extruders)
      if (id != program::kOutputsExtruder)
        all.push_back({std::string(d.id), std::string(id)});
  return all;
}

const test::Scene& sceneFor(const std::string& format) {
  static const test::Scene usual = test::boxScene(1), other = test::boxScene(1, "rv2f-moving");
  return test::cellFor(format) == usual.cell.id() ? usual : other;
}

using TextLines = std::vector<std::string>;
// Changes the lines from `at` on (an index); where, or nothing.
using Harm = std::function<std::optional<std::size_t>(TextLines&, std::size_t at)>;
struct Kind {
  std::string name;
  Harm harm;
};

std::ptrdiff_t offset(std::size_t i) {
  return static_cast<std::ptrdiff_t>(i);
}
std::optional<std::size_t> next(const TextLines& lines, std::size_t at,
                                const std::string& pattern) {
  const std::regex words(pattern);
  for (std::size_t i = at; i < lines.size(); ++i)
    if (std::regex_search(lines[i], words))
      return i;
  return std::nullopt;
}
Kind replaced(const std::string& name, const std::string& pattern, const std::string& by,
              bool fromTop = false) {
  return {name, [=](TextLines& lines, std::size_t at) {
            const auto i = next(lines, fromTop ? 0 : at, pattern);
            if (i)
              lines[*i] = std::regex_replace(lines[*i], std::regex(pattern), by);
            return i;
          }};
}
Kind erased(const std::string& name, const std::string& pattern, bool fromTop = false) {
  return {name, [=](TextLines& lines, std::size_t at) {
            const auto i = next(lines, fromTop ? 0 : at, pattern);
            if (i)
              lines.erase(lines.begin() + offset(*i));
            return i;
          }};
}
// So many lines behind one that the pattern is in.
Kind inserted(const std::string& line, const std::string& pattern, std::size_t behind) {
  return {"amid: " + line, [=](TextLines& lines, std::size_t at) {
            auto i = next(lines, at, pattern);
            if (i)
              lines.insert(lines.begin() + offset(*i = *i + behind), line);
            return i;
          }};
}
Kind later(const std::string& name, const std::string& pattern) {
  return {name, [=](TextLines& lines, std::size_t at) -> std::optional<std::size_t> {
            const auto i = next(lines, at, pattern);
            if (!i || *i + 4 > lines.size())
              return std::nullopt;
            std::rotate(lines.begin() + offset(*i), lines.begin() + offset(*i + 1),
                        lines.begin() + offset(*i + 4));
            return i;
          }};
}
// Each number that the pattern has in brackets, over so many lines.
Kind scaled(const std::string& name, const std::string& pattern, double by, std::size_t count,
            int decimals) {
  return {name, [=](TextLines& lines, std::size_t at) {
            const std::regex words(pattern);
            const auto first = next(lines, at, pattern);
            for (std::size_t i = first.value_or(lines.size());
                 i < std::min(lines.size(), first.value_or(0) + count); ++i)
              if (std::smatch m; std::regex_search(lines[i], m, words)) {
                char number[32];
                std::snprintf(number, sizeof number, "%.*f", decimals, by * std::stod(m[1].str()));
                lines[i].replace(static_cast<std::size_t>(m.position(1)),
                                 static_cast<std::size_t>(m.length(1)), number);
              }
            return first;
          }};
}

// Of a line that sends `text` in this dialect.
std::string sent(const std::string& dialect, const std::string& text) {
  return dialect == "spel" ? "  Write #201, \"" + text + "\"\r"
                           : "  socket_send_string(\"" + text + "\",\"extruder\")";
}

std::vector<Kind> textKinds(const std::string& dialect) {
  const std::string flows = "\"G([1-9][0-9]*)n\"", stop = "\"G0n\"";
  const std::string wait = dialect == "spel" ? "^  Wait [0-9]" : "^  sleep";
  std::vector<Kind> all = {scaled("flow is 80 % over 200 lines", flows, 1.25, 200, 0),
                           replaced("a flow loses a digit", "\"G([0-9]+)[0-9]n\"", "\"G$1n\""),
                           replaced("a flow has a digit more", flows, "\"G$011n\""),
                           replaced("the filament runs back", flows, "\"G-$1n\""),
                           replaced("a text has no end", flows, "\"G$1\""),
                           replaced("another word", flows, "\"X$1n\""),
                           replaced("a flow becomes heat", flows, "\"M$1n\""),
                           replaced("a part of a step", flows, "\"G$1.5n\""),
                           erased("the extruder never starts", flows),
                           erased("the extruder stays on", stop),
                           later("the extruder starts late", flows),
                           later("the extruder stops late", stop),
                           erased("the prime is missing", wait, true),
                           replaced("ten times the prime",
                                    dialect == "spel" ? "Wait 0\\.2" : "sleep\\(0\\.2",
                                    dialect == "spel" ? "Wait 2" : "sleep(2", true),
                           replaced("heat of 400", "\"M210n\"", "\"M400n\"", true)};
  for (const char* text : {"G50n", "G0n", "G-50n", "M0n", "M400n", "R0n", "G131", "", "nn"})
    all.push_back(inserted(sent(dialect, text), flows, 3));
  return all;
}

std::vector<Kind> streamKinds() {
  const std::string step = "^[0-9]+ [0-9.]+ ([0-9.]+)$", time = "^[0-9]+ ([0-9.]+) [0-9.]+$";
  std::vector<Kind> all = {
      scaled("flow is 80 % over 200 lines", step, 0.8, 200, 5),
      scaled("one amount is twice", step, 2.0, 1, 5),
      scaled("one amount is nothing", step, 0.0, 1, 5),
      scaled("one time is twice", time, 2.0, 1, 6),
      scaled("all times are half as long again", time, 1.5, 100000, 6),
      erased("a line is missing", step),
      erased("the extruder never goes on", "^on "),
      erased("the extruder never goes off", "^off "),
      later("it goes on late", "^on "),
      later("a line comes late", step),
      replaced("an amount lost its point", "^([0-9]+ [0-9.]+) ([0-9]+)\\.([0-9]+)$", "$1 $2$3"),
      replaced("an amount has a sign", "^([0-9]+ [0-9.]+) ", "$1 -"),
      replaced("a time is no number", "^([0-9]+) [0-9.]+ ", "$1 x "),
      replaced("a number of a motion is another", "^([0-9]+) ([0-9.]+ )", "9$1 $2"),
      replaced("a word too many", "^([0-9]+ [0-9.]+ [0-9.]+)$", "$1 7"),
      replaced("on elsewhere", "^on ([0-9]+)", "on 9$1"),
      replaced("off elsewhere", "^off ([0-9]+)", "off 9$1"),
      replaced("filament of 2.85 mm", "diameter 1\\.75", "diameter 2.85", true),
      erased("the end is missing", "^end", true)};
  for (const char* line : {"on 5", "off 5", "end", "5 0 0", "G1 E5", "stop"})
    all.push_back(inserted(line, step, 0));
  all.push_back({"the file ends early", [](TextLines& lines, std::size_t at) {
                   lines.resize(at);
                   return std::optional(at - 1);
                 }});
  all.push_back({"two lines have changed places", [=](TextLines& lines, std::size_t at) {
                   const auto i = next(lines, at, step);
                   if (i)
                     std::swap(lines[*i], lines[*i + 1]);
                   return i;
                 }});
  return all;
}

// Of an axis that moves with each motion, mm of filament.
std::vector<Kind> axisKinds(const std::string& dialect) {
  const bool krl = dialect == "krl";
  const std::string bead = krl ? "^LIN .*,E1 ([0-9.]+)\\}" : "^    MoveL .*,\\[([0-9.]+),9E9",
                    number = krl ? "E1 ([0-9]+)\\.([0-9]+)\\}" : ",\\[([0-9]+)\\.([0-9]+),9E9",
                    zero = krl ? "^ZERO_EXTRUDER" : "^    zeroExtruder",
                    feed = krl ? "^PTP \\{E1 ([0-9.]+)" : "^    MoveExtJ .*,\\[([0-9.]+),";
  const auto as = [&](const std::string& name, const std::string& value) {
    return replaced(name, number, krl ? "E1 " + value + "}" : ",[" + value + ",9E9");
  };
  const auto fed = [&](const std::string& mm) {
    return krl ? "PTP {E1 " + mm + "}\r"
               : "    MoveExtJ [[9E9,9E9,9E9,9E9,9E9,9E9],[" + mm +
                     ",9E9,9E9,9E9,9E9,9E9]],v100\\T:=0.2,fine;\r";
  };
  std::vector<Kind> all = {scaled("all amounts are 80 % over 200 lines", bead, 0.8, 200, 5),
                           scaled("all amounts are 5 % more from here on", bead, 1.05, 100000, 5),
                           scaled("one amount is twice", bead, 2.0, 1, 5),
                           scaled("one amount is a little less", bead, 0.97, 1, 5),
                           scaled("the prime is ten times that", feed, 10.0, 1, 5),
                           as("an amount lost its point", "$1$2"),
                           as("an amount has a sign", "-$1.$2"),
                           as("an amount is nothing", "0"),
                           as("an amount has a digit more", "1$1.$2"),
                           as("an amount is no number", "x"),
                           as("the axis is missing", krl ? "$1.$2,E1 $1.$2" : "9E9"),
                           erased("a line is missing", bead),
                           later("a line comes late", bead),
                           erased("the axis is never set to 0", zero, true),
                           erased("the prime is missing", feed, true),
                           erased("nobody knows which axis it is",
                                  krl ? "^EXTRUDER_AXIS=" : "^    ActUnit extruder", true),
                           {"the file ends early",
                            [](TextLines& lines, std::size_t at) {
                              lines.resize(at);
                              return std::optional(at - 1);
                            }},
                           {"two lines have changed places", [=](TextLines& lines, std::size_t at) {
                              const auto i = next(lines, at, bead);
                              const auto other = i ? next(lines, *i + 1, bead) : std::nullopt;
                              if (other)
                                std::swap(lines[*i], lines[*other]);
                              return i;
                            }}};
  // The prime comes before all beads.
  for (Kind& kind : all)
    if (kind.name.starts_with("the prime is ten"))
      kind.harm = [harm = kind.harm](TextLines& lines, std::size_t) { return harm(lines, 0); };
  if (krl)
    all.push_back(replaced("another axis", "E1 ([0-9.]+)\\}", "E2 $1}"));
  else
    all.push_back(replaced("another axis", ",\\[([0-9.]+),9E9", ",[9E9,$1"));
  for (const std::string& line :
       {fed("500"), fed("-30"), krl ? std::string("ZERO_EXTRUDER ( )\r") : "    zeroExtruder;\r",
        krl ? std::string("HALT\r") : "    UIMsgBox \"wait\";\r",
        krl ? std::string("EXTRUDER_AXIS=2\r") : "    DeactUnit extruder;\r",
        krl ? std::string("$VEL_EXTAX[1]=1\r") : "    VelSet 50,5000;\r",
        krl ? std::string("EXTRUDER_AXIS=0\r") : "    ActUnit other;    SetAO aoFlow,3;\r"})
    all.push_back(inserted(line, bead, 3));
  return all;
}

class ExtruderRows : public ::testing::TestWithParam<Row> {
protected:
  const test::Scene& scene() const { return sceneFor(GetParam().dialect); }
  void SetUp() override {
    const test::Scene& s = scene();
    program::ProgramInput in{s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"};
    in.options.own["extruder"] = GetParam().extruder;
    files_ = program::writeProgram(GetParam().dialect, in).files;
    for (std::size_t f = 0; f < files_.size(); ++f)
      if (program::looksLikeStream(files_[f].text))
        stream_ = f;
    whole_ = read(files_);
  }
  bool streams() const { return stream_.has_value(); }

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) const {
    return program::readProgram(GetParam().dialect, files, process::Tooling(scene().process));
  }
  Verification verify(const std::vector<plan::ProgramFile>& files) const {
    const test::Scene& s = scene();
    return replayProgram({read(files), s.plan, s.trajectory, s.cell, process::Tooling(s.process),
                          s.part, s.platform},
                         ReplayThresholds{}, {});
  }
  std::size_t harmed() const { return stream_.value_or(0); }
  TextLines lines() const {
    TextLines all;
    std::istringstream in(files_[harmed()].text);
    for (std::string line; std::getline(in, line);)
      all.push_back(line);
    return all;
  }

  // At the line or the one beside it, or at the motion that it concerns, or that follows it.
  bool named(const Verification& v, const TextLines& lines, std::size_t at) const {
    const std::size_t line = at + 1;
    const auto near = [](std::size_t a, std::size_t b) { return a + 1 >= b && a <= b + 1; };
    std::size_t concerned = 0;
    if (streams()) {
      std::size_t motion = 0;
      for (const std::size_t i : {at, std::min(at + 1, lines.size() - 1)})
        if (std::smatch m; motion == 0 && i < lines.size() &&
                           std::regex_search(lines[i], m, std::regex("^([0-9]+) ")))
          motion = std::stoul(m[1].str());
      concerned =
          motion > 0 && motion <= whole_.motions.size() ? whole_.motions[motion - 1].line : 1;
    }
    // At the line or behind it; and, where that line is a motion of its own, the one behind that.
    std::size_t following = 0, second = 0;
    for (const plan::ProgramMotion& m : whole_.motions) {
      if (streams())
        break;
      if (m.line >= line && following == 0)
        following = m.line;
      else if (m.line > line && second == 0)
        second = m.line;
    }
    return !v.passed && std::any_of(v.places.begin(), v.places.end(), [&](TextPlace p) {
      if (p.file == harmed() + 1 && near(p.line, line))
        return true;
      return streams() ? p.file != harmed() + 1 && near(p.line, concerned)
                       : near(p.line, following) ||
                             (following == line && second > 0 && near(p.line, second));
    });
  }

  std::vector<plan::ProgramFile> files_;
  std::optional<std::size_t> stream_;
  plan::ReadProgram whole_;
};

TEST_P(ExtruderRows, TheUndamagedProgramPasses) {
  const Verification v = verify(files_);
  EXPECT_TRUE(v.passed) << findingsText(v);
  EXPECT_NEAR(v.massRatio, 1.0, 0.01);
  EXPECT_TRUE(v.findings.empty()) << findingsText(v);
}

TEST_P(ExtruderRows, HarmIsFoundAtItsLine) {
  const std::vector<Kind> kinds = streams() ? streamKinds()
                                  : program::findExtruder(GetParam().extruder).byAxis
                                      ? axisKinds(GetParam().dialect)
                                      : textKinds(GetParam().dialect);
  const std::vector<double> shares =
      test::allSeeds() ? std::vector{0.3, 0.6} : std::vector{0.3}; // of the text
  std::size_t tried = 0, refused = 0, found = 0;
  std::string missed;
  for (const Kind& kind : kinds)
    for (const double share : shares) {
      TextLines text = lines();
      const auto at =
          kind.harm(text, static_cast<std::size_t>(share * static_cast<double>(text.size())));
      if (!at) {
        missed += "not applied: " + kind.name + "\n";
        continue;
      }
      auto files = files_;
      files[harmed()].text.clear();
      for (const std::string& line : text)
        files[harmed()].text += line + "\n";
      const Verification v = verify(files);
      const bool here = named(v, text, *at);
      ++tried;
      refused += v.passed ? 0 : 1;
      found += here ? 1 : 0;
      if (!here)
        missed += kind.name + " (line " + std::to_string(*at + 1) +
                  "): " + (v.passed ? "passed\n" : findingsText(v).substr(0, 200) + "\n");
    }
  EXPECT_EQ(tried, shares.size() * kinds.size()) << missed;
  EXPECT_EQ(refused, tried) << missed;
  EXPECT_EQ(found, tried) << missed;
}

TEST_P(ExtruderRows, HarmlessEditsRaiseNoAlarm) {
  const std::size_t step =
      test::ofSeeds(std::max(std::size_t{17}, lines().size() / 20), std::size_t{17});
  int alarms = 0, tried = 0;
  for (std::size_t at = 5; at + 5 < lines().size(); at += step)
    for (const char* line : {"", "   ", "MARK seen"}) {
      TextLines text = lines();
      std::string extra = line;
      if (extra.starts_with("MARK"))
        extra = std::string(streams() ? "#" : program::findDialect(GetParam().dialect).remark) +
                " seen by me";
      if (!text.front().empty() && text.front().back() == '\r')
        extra += '\r';
      text.insert(text.begin() + offset(at), extra);
      auto files = files_;
      files[harmed()].text.clear();
      for (const std::string& each : text)
        files[harmed()].text += each + "\n";
      const Verification v = verify(files);
      ++tried;
      alarms += v.passed && v.findings.empty() ? 0 : 1;
    }
  EXPECT_GE(tried, 15);
  EXPECT_EQ(alarms, 0);
}

INSTANTIATE_TEST_SUITE_P(Replay, ExtruderRows, ::testing::ValuesIn(rows()), [](const auto& i) {
  return std::regex_replace(i.param.dialect + "_" + i.param.extruder, std::regex("-"), "_");
});

} // namespace
} // namespace voluta::replay
