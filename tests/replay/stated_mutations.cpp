#include "replay/stated_mutations.h"

#include "replay/mutation_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <regex>

namespace voluta::test {

namespace {

using TextLines = std::vector<std::string>;

TextLines::iterator lineAt(Subject& s, std::size_t line) { // 1-based
  return s.text.lines.begin() + at(line);
}

// The first line that the pattern is in, at or behind `from`; nothing: there is none.
Line find(const Subject& s, const std::string& pattern, std::size_t from = 1) {
  const std::regex expression(pattern);
  for (std::size_t line = from; line <= s.text.lines.size(); ++line)
    if (std::regex_search(s.text.lines[line - 1], expression))
      return line;
  return std::nullopt;
}

Mutation erasedAll(const std::string& kind, const std::string& pattern) {
  return {kind, [pattern](Subject& s, std::size_t, std::mt19937_64&) -> Line {
            const Line first = find(s, pattern);
            const std::regex expression(pattern);
            std::erase_if(s.text.lines, [&](const std::string& line) {
              return std::regex_search(line, expression);
            });
            return first;
          }};
}

// In the first line that the pattern is in.
Mutation replacedInHead(const std::string& kind, const std::string& pattern,
                        const std::string& by) {
  return {kind, [pattern, by](Subject& s, std::size_t, std::mt19937_64&) -> Line {
            const Line line = find(s, pattern);
            if (line)
              s.text.lines[*line - 1] =
                  std::regex_replace(s.text.lines[*line - 1], std::regex(pattern), by);
            return line;
          }};
}

// A line of the head comes behind the first motion.
Mutation movedBehindFirstMotion(const std::string& kind, const std::string& pattern) {
  return {kind, [pattern](Subject& s, std::size_t, std::mt19937_64&) -> Line {
            const Line line = find(s, pattern);
            const std::size_t motion = s.read.motions.front().line;
            if (!line || *line > motion)
              return std::nullopt;
            std::rotate(lineAt(s, *line), lineAt(s, *line + 1), lineAt(s, motion + 1));
            return line;
          }};
}

// The line that stops the arm after motion m, and the lines needed to continue.
TextLines waitBehind(const Subject& s, std::size_t m, const std::string& seconds) {
  const std::string& format = s.text.format;
  static const std::map<std::string, std::array<std::string, 2>> kWords = {
      {"urscript", {"  sleep(", ")"}},  {"rapid", {"    WaitTime ", ";"}},
      {"krl", {"WAIT SEC ", ""}},       {"spel", {"  Wait ", ""}},
      {"melfa", {"Dly ", ""}},          {"gcode", {"G4 S", ""}},
      {"gcode-extended", {"G4 S", ""}}, {"gcode-bc", {"G4 S", ""}}};
  if (const auto words = kWords.find(format); words != kWords.end())
    return {words->second[0] + seconds + words->second[1]};
  const std::string& line = s.text.lines[s.read.motions[m].line - 1];
  std::smatch place;
  if (format == "tmscript") {
    if (!std::regex_search(line, place, std::regex(R"(PVTPoint\(((?:[^,]*,){6}))")))
      return {};
    return {"PVTExit()", "PVTEnter(1)",
            "PVTPoint(" + place[1].str() + "0,0,0,0,0,0," + seconds + ")"};
  }
  if (format.ends_with("-stream")) {
    if (!std::regex_search(line, place, std::regex("^2,[^,]*((?:,[^,]*){6})")))
      return {};
    return {"3," + seconds + place[1].str() + ",0,0"};
  }
  if (!std::regex_search(line, place, std::regex("^(?:[^,]*,){5}[^,]*")))
    return {};
  return {place.str() + ",-" + seconds + (format == "krl-eki" ? ",0,0,0" : ",0,0")};
}
Line insertWait(Subject& s, std::size_t m, const std::string& seconds) {
  TextLines wait = waitBehind(s, m, seconds);
  const std::size_t line = s.read.motions[m].line;
  for (std::string& one : wait)
    one = ended(s, one);
  s.text.lines.insert(lineAt(s, line + 1), wait.begin(), wait.end());
  return wait.empty() ? std::nullopt : Line(line + wait.size());
}

// Motions without flow that end where a bead begins, from m on.
std::vector<std::size_t> arrivals(const Subject& s, std::size_t m) {
  std::vector<std::size_t> found;
  for (std::size_t k = m; k + 1 < s.read.motions.size(); ++k)
    if (!s.read.motions[k].extruding && s.read.motions[k + 1].extruding)
      found.push_back(k);
  return found;
}

// From the last to the first, so that lines before them stay where they are.
Line insertWaits(Subject& s, const std::vector<std::size_t>& motions, const std::string& seconds) {
  Line first;
  for (std::size_t k = motions.size(); k-- > 0;)
    first = insertWait(s, motions[k], seconds);
  return first;
}

void waits(std::vector<Mutation>& all, const std::string& format) {
  if (format == "csv") { // each line has its time from the beginning
    all.push_back(
        {"a wait of 0.95 s before a bead", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
           const auto beads = arrivals(s, m);
           if (beads.empty())
             return std::nullopt;
           const std::size_t first = s.read.motions[beads.front() + 1].line;
           for (std::size_t l = first; l <= s.text.lines.size(); ++l)
             if (std::string& line = s.text.lines[l - 1];
                 std::isdigit(static_cast<unsigned char>(line.front())) != 0)
               line = withNumber(line, numbersIn(line).front(), std::stod(line) + 0.95);
           return first;
         }});
    return;
  }
  all.push_back(
      {"a wait of 0.95 s before a bead", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
         const auto beads = arrivals(s, m);
         return beads.empty() ? std::nullopt : insertWait(s, beads.front(), "0.95");
       }});
  all.push_back(
      {"a wait of 0.3 s before every bead", [](Subject& s, std::size_t, std::mt19937_64&) -> Line {
         return insertWaits(s, arrivals(s, 1), "0.3");
       }});
  if (format.starts_with("gcode"))
    all.push_back({"a wait of 0.9 s at every tenth motion",
                   [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                     std::vector<std::size_t> motions;
                     for (std::size_t k = m; k + 1 < s.read.motions.size(); k += 10)
                       motions.push_back(k);
                     return insertWaits(s, motions, "0.9");
                   }});
}

// The operator's stop: removed, of no duration, too late.
void stops(std::vector<Mutation>& all, const std::string& format) {
  struct Stop {
    std::string line, word;
    std::vector<std::string> passing; // instead of the word
  };
  static const std::map<std::string, Stop> kStops = {
      {"urscript", {"popup\\(", ",blocking=True", {"", ",blocking=False"}}},
      {"rapid",
       {"UIMsgBox", "UIMsgBox (\"[^\"]*\");", {"UIMsgBox $1\\MaxTime:=1;", "TPWrite $1;"}}},
      {"krl", {"^HALT", "HALT", {"WAIT SEC 0.1"}}},
      {"spel", {"  Pause", "Pause", {"Wait 0.1"}}},
      {"melfa", {"^[0-9]+ Hlt", "^([0-9]+) Hlt", {"$1 Dly 0.1"}}},
      {"tmscript", {"^Pause\\(\\)", "Pause\\(\\)", {"QueueTag(1,0)"}}},
      {"gcode", {"^M0$", "M0", {"M0 P100", "M0 S1", "M1"}}}};
  const auto stop = kStops.find(format.starts_with("gcode") ? "gcode" : format);
  if (stop == kStops.end())
    return;
  const Stop& words = stop->second;
  all.push_back(erasedAll("the operator's stop is missing", words.line));
  all.push_back(movedBehindFirstMotion("the operator's stop is too late", words.line));
  for (const std::string& passing : words.passing)
    all.push_back(
        replacedInHead("the operator's stop becomes '" + passing + "'", words.word, passing));
}

void gcode(std::vector<Mutation>& all, const std::string& format) {
  all.push_back(erasedAll("no heat", "^M10[49] S[1-9]"));
  all.push_back(erasedAll("no wait for the heat", "^M109"));
  for (const char* word : {"G28", "G21", "G90", "M82"})
    all.push_back(erasedAll(std::string("no ") + word, "^" + std::string(word) + "$"));
  if (format == "gcode-bc")
    all.push_back(erasedAll("no G94", "^G94$"));
  for (const char* word : {"M104 S0", "M109 S0"})
    all.push_back({std::string("cold before the first motion: ") + word,
                   [word](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                     const std::size_t line = s.read.motions.front().line;
                     s.text.lines.insert(lineAt(s, line), word);
                     return line;
                   }});
  all.push_back({"the drive home comes before the stop",
                 [](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                   const Line stop = find(s, "^M0$"), home = find(s, "^G28$");
                   std::swap(s.text.lines[*stop - 1], s.text.lines[*home - 1]);
                   return stop;
                 }});
}

void melfa(std::vector<Mutation>& all) {
  const auto inMotion = [](const std::string& kind, const std::string& by) {
    return Mutation{kind, [by](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                      std::string& line = lineOf(s, m);
                      line = std::regex_replace(line, std::regex(R"(\(\d+,\d+\))"), by);
                      return s.read.motions[m].line;
                    }};
  };
  all.push_back(inMotion("another structure", "(6,0)"));
  all.push_back(inMotion("a left arm", "(3,0)"));
  all.push_back(inMotion("another turn", "(7,1048576)"));
  all.push_back(erasedAll("no base", "Base P_NBase"));
  all.push_back(
      {"rounding without distances", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
         const Line line = find(s, "Cnt 1,", s.read.motions[m].line);
         if (line)
           s.text.lines[*line - 1] =
               std::regex_replace(s.text.lines[*line - 1], std::regex("Cnt 1,[0-9.,]+"), "Cnt 1");
         return line;
       }});
}

void tmscript(std::vector<Mutation>& all) {
  const auto standing = [](const std::string& line) {
    return std::regex_replace(line, std::regex(R"((PVTPoint\((?:[^,]*,){6})(?:[^,]*,){6})"),
                              "$010,0,0,0,0,0,");
  };
  // Signs of the velocities (7th to 12th number) of a point.
  const auto turned = [](const std::string& kind, std::size_t first, std::size_t count) {
    return Mutation{kind, [=](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                      std::string& line = lineOf(s, m);
                      for (std::size_t k = first; k < first + count; ++k) {
                        const auto where = numbersIn(line).at(k);
                        line = withNumber(line, where, -std::stod(line.substr(where.first)));
                      }
                      return s.read.motions[m].line;
                    }};
  };
  all.push_back(turned("the velocities of a point are reversed", 6, 6));
  all.push_back(turned("the way's velocity of a point is reversed", 6, 3));
  all.push_back(erasedAll("no base", "^ChangeBase"));
  all.push_back({"a point on a bead has no velocity",
                 [standing](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   lineOf(s, m) = standing(lineOf(s, m));
                   return s.read.motions[m].line;
                 }});
  all.push_back({"no point on a bead has a velocity",
                 [standing](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                   Line first;
                   for (std::size_t m = 0; m + 1 < s.read.motions.size(); ++m)
                     if (s.read.motions[m].extruding && s.read.motions[m + 1].extruding) {
                       lineOf(s, m) = standing(lineOf(s, m));
                       first = first ? first : Line(s.read.motions[m].line);
                     }
                   return first;
                 }});
}

void spel(std::vector<Mutation>& all) {
  all.push_back(replacedInHead("full power for the first motion", "Power Low", "Power High"));
  all.push_back(
      {"full power before the first motion", [](Subject& s, std::size_t, std::mt19937_64&) -> Line {
         const std::size_t motion = s.read.motions.front().line;
         s.text.lines.insert(lineAt(s, motion), ended(s, "  Power High"));
         return motion;
       }});
}

void urscript(std::vector<Mutation>& all) {
  for (const char* word : {"sleep", "floor"})
    all.push_back({std::string("the function is called ") + word,
                   [word](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                     const Line line = find(s, "^def ");
                     for (std::string& text : s.text.lines)
                       text = std::regex_replace(text, std::regex(R"(^(def )?print_\w+\()"),
                                                 "$1" + std::string(word) + "(");
                     return line;
                   }});
  all.push_back(erasedAll("no range of the flow output", "set_analog_outputdomain"));
  all.push_back(movedBehindFirstMotion("the range of the flow output is too late",
                                       "set_analog_outputdomain"));
  all.push_back(replacedInHead("another range of the flow output",
                               "set_analog_outputdomain\\(0,1\\)", "set_analog_outputdomain(0,0)"));
}

} // namespace

std::vector<Mutation> statedMutations(const std::string& format) {
  std::vector<Mutation> all;
  waits(all, format);
  stops(all, format);
  // The lines of an EthernetKRL program do not state it.
  const bool saysFullFlow = format != "csv" && format != "krl-eki" && !format.starts_with("gcode");
  if (saysFullFlow) {
    all.push_back(replacedInHead("half the full flow", " = 40 mm3/s", " = 20 mm3/s"));
    all.push_back(replacedInHead("a tenth of the full flow", " = 40 mm3/s", " = 4 mm3/s"));
    all.push_back(replacedInHead("the full flow in another unit", " = 40 mm3/s", " = 40 mm3/min"));
  }
  if (format.starts_with("gcode"))
    gcode(all, format);
  else if (format == "melfa")
    melfa(all);
  else if (format == "tmscript")
    tmscript(all);
  else if (format == "urscript")
    urscript(all);
  else if (format == "spel")
    spel(all);
  return all;
}

} // namespace voluta::test
