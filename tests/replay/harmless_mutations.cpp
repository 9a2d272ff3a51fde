#include "program/common/program_text.h"
#include "replay/mutation_text.h"

#include <cctype>
#include <map>
#include <utility>

namespace voluta::test {

std::vector<Mutation> harmlessMutations(const std::string& format) {
  static const std::map<std::string, std::string> kRemark = {{"urscript", "# "},
                                                             {"rapid", "! "},
                                                             {"gcode-extended", "; "},
                                                             {"gcode-bc", "; "},
                                                             {"gcode", "; "},
                                                             {"krl", "; "},
                                                             {"spel", "' "},
                                                             {"melfa", "' "},
                                                             {"tmscript", "// "},
                                                             {"csv", "# "},
                                                             {"urscript-stream", "# "},
                                                             {"melfa-stream", "# "},
                                                             {"melfa-datalink", "# "},
                                                             {"krl-eki", "# "}};
  const std::string remark = kRemark.at(format);
  const auto any = [](Subject& s, std::mt19937_64& random) {
    return s.read.motions.front().line + random() % (s.text.lines.size() - 40);
  };
  std::vector<Mutation> all;
  all.push_back({"a remark", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
                   const std::size_t line = any(s, random);
                   s.text.lines.insert(s.text.lines.begin() + at(line),
                                       ended(s, remark + "seen by me " + std::to_string(random())));
                   return line;
                 }});
  all.push_back(
      {"a remark in the head", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         const std::size_t first = format == "krl" ? 4 : 3, last = s.read.motions.front().line;
         const std::size_t line = first + random() % (last - first + 1);
         s.text.lines.insert(s.text.lines.begin() + at(line), ended(s, remark + "room 12"));
         return line;
       }});
  all.push_back({"a remark in the head on the extruder",
                 [=](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                   const std::size_t line = s.read.motions.front().line;
                   s.text.lines.insert(s.text.lines.begin() + at(line),
                                       ended(s, remark + "extruder flow: 95 %"));
                   return line;
                 }});
  all.push_back(
      {"a remark says more", [](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         std::vector<std::size_t> remarks;
         for (std::size_t l = 1; l <= s.text.lines.size(); ++l)
           if (s.text.lines[l - 1].find(", path ") != std::string::npos)
             remarks.push_back(l);
         if (remarks.empty())
           return std::nullopt;
         const std::size_t line = remarks[random() % remarks.size()];
         std::string& text = s.text.lines[line - 1];
         text.insert(endOf(text), ", 20 mm3/s");
         return line;
       }});
  all.push_back({"an empty line", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
                   const std::size_t line = any(s, random);
                   s.text.lines.insert(s.text.lines.begin() + at(line), ended(s, "   "));
                   return line;
                 }});
  all.push_back(
      {"blanks before a line", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         const std::size_t line = any(s, random);
         s.text.lines[line - 1].insert(0, 1 + random() % 5, ' ');
         return line;
       }});
  all.push_back(
      {"a tab before a line", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         const std::size_t line = any(s, random);
         s.text.lines[line - 1].insert(0, 1, '\t');
         return line;
       }});
  all.push_back(
      {"zeros behind a number", [](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         const std::size_t m = 1 + random() % (s.read.motions.size() - 1);
         std::string& line = lineOf(s, m);
         std::vector<std::size_t> ends;
         for (const auto& [begin, end] : numbersIn(line))
           if (line.substr(begin, end - begin).find('.') != std::string::npos &&
               line.substr(begin, end - begin).find_first_of("eE") == std::string::npos)
             ends.push_back(end);
         if (ends.empty())
           return std::nullopt;
         line.insert(ends[random() % ends.size()], "000");
         return s.read.motions[m].line;
       }});
  // Of the statements between motions.
  const auto statement = [](Subject& s, std::mt19937_64& random) -> std::string* {
    std::vector<std::size_t> lines;
    for (const plan::StatedFact& fact : s.read.facts)
      lines.push_back(fact.line);
    for (const plan::ProgramPause& pause : s.read.pauses)
      lines.push_back(pause.line);
    std::erase_if(lines, [&](std::size_t l) { return l == 0 || l > s.text.lines.size(); });
    return lines.empty() ? nullptr : &s.text.lines[lines[random() % lines.size()] - 1];
  };
  const auto lineOfText = [](const Subject& s, const std::string* text) {
    return static_cast<std::size_t>(text - s.text.lines.data()) + 1;
  };
  all.push_back({"zeros behind a number of a statement",
                 [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
                   std::string* text = statement(s, random);
                   if (!text || text->find('"') != std::string::npos || text->starts_with("M0"))
                     return std::nullopt;
                   const std::string code = text->substr(0, text->find(program::trimmed(remark)));
                   std::vector<std::size_t> ends;
                   for (const auto& [begin, end] : numbersIn(code))
                     if (code.substr(begin, end - begin).find('.') != std::string::npos)
                       ends.push_back(end);
                   if (ends.empty())
                     return std::nullopt;
                   text->insert(ends[random() % ends.size()], "00");
                   return lineOfText(s, text);
                 }});
  all.push_back(
      {"blanks around a statement", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         std::string* text = statement(s, random);
         if (!text)
           return std::nullopt;
         text->insert(endOf(*text), " ");
         text->insert(0, "  ");
         return lineOfText(s, text);
       }});
  if (format == "rapid" || format == "krl" || format == "spel" || format == "melfa")
    all.push_back({"letters of the other case in a statement",
                   [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
                     std::string* text = statement(s, random);
                     if (!text || text->find('"') != std::string::npos)
                       return std::nullopt;
                     for (char& c : *text)
                       c = static_cast<char>(random() % 2 ? std::toupper(c) : std::tolower(c));
                     return lineOfText(s, text);
                   }});
  all.push_back(
      {"blanks within a line", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         const std::size_t m = 1 + random() % (s.read.motions.size() - 1);
         std::string& line = lineOf(s, m);
         const char mark = format.starts_with("gcode") ? ' ' : ',';
         std::vector<std::size_t> places;
         for (std::size_t i = line.find(mark); i != std::string::npos; i = line.find(mark, i + 1))
           places.push_back(i);
         line.insert(places[random() % places.size()] + 1, "  ");
         return s.read.motions[m].line;
       }});
  all.push_back(
      {"blanks behind a line", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
         const std::size_t line = any(s, random);
         std::string& text = s.text.lines[line - 1];
         text.insert(endOf(text), "  ");
         return line;
       }});
  if (format != "csv")
    all.push_back(
        {"a remark behind a line", [=](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
           const std::size_t m = 1 + random() % (s.read.motions.size() - 1);
           std::string& text = lineOf(s, m);
           text.insert(endOf(text), " " + remark + "ok");
           return s.read.motions[m].line;
         }});
  if (format == "rapid" || format == "krl" || format == "spel" || format == "melfa")
    all.push_back(
        {"letters of the other case", [](Subject& s, std::size_t, std::mt19937_64& random) -> Line {
           const std::size_t m = 1 + random() % (s.read.motions.size() - 1);
           for (char& c : lineOf(s, m))
             c = static_cast<char>(random() % 2 ? std::toupper(c) : std::tolower(c));
           return s.read.motions[m].line;
         }});
  const auto swapped = [](const std::string& a, const std::string& b) {
    return Mutation{"lines of the head in another order",
                    [a, b](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                      std::size_t first = 0, second = 0;
                      for (std::size_t i = s.text.lines.size(); i-- > 0;) {
                        first = s.text.lines[i].find(a) != std::string::npos ? i + 1 : first;
                        second = s.text.lines[i].find(b) != std::string::npos ? i + 1 : second;
                      }
                      if (!first || !second)
                        return std::nullopt;
                      std::swap(s.text.lines[first - 1], s.text.lines[second - 1]);
                      return first;
                    }};
  };
  if (format == "urscript") {
    all.push_back(swapped("set_tcp", "set_payload"));
    all.push_back(swapped("set_standard_digital_out(0,False)", "set_standard_analog_out(0,0)"));
  } else if (format == "rapid") {
    all.push_back(swapped("ConfL", "ConfJ"));
    all.push_back(swapped("PERS tooldata", "PERS wobjdata"));
  } else if (format == "krl") {
    all.push_back(swapped("$BASE=", "$TOOL="));
    all.push_back(swapped("$VEL.ORI1", "$LOAD"));
  } else if (format == "spel") {
    all.push_back(swapped("Weight", "AutoLJM"));
    all.push_back(swapped("Power Low", "TLSet"));
  } else if (format.starts_with("gcode")) {
    all.push_back(swapped("G21", "G90"));
    all.push_back(swapped("G90", "M82"));
    // As slicers write it: it drives home cold.
    all.push_back(swapped("M104 S", "G28"));
    all.push_back(
        {"no heat but the wait for it", [](Subject& s, std::size_t, std::mt19937_64&) -> Line {
           for (std::size_t line = 1; line <= s.text.lines.size(); ++line)
             if (s.text.lines[line - 1].starts_with("M104 S")) {
               s.text.lines.erase(s.text.lines.begin() + at(line));
               return line;
             }
           return std::nullopt;
         }});
  } else if (format == "tmscript") {
    all.push_back(swapped("ChangeBase", "ChangeTCP"));
  }
  return all;
}

} // namespace voluta::test
