#include "replay/mutations.h"

#include "mutation_lines.h"
#include "replay/flow_mutations.h"
#include "replay/mutation_text.h"
#include "replay/stated_mutations.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>

namespace voluta::test {

namespace {

// The distance of two motions' targets, in about millimetres.
double apart(const plan::ProgramMotion& a, const plan::ProgramMotion& b) {
  constexpr double kLeverMm = 15.0; // of a small part on its plate
  double d =
      (a.position - b.position).norm() +
      kLeverMm * std::acos(std::clamp(a.direction.dot(b.direction), -1.0, 1.0)) +
      (a.frame_T_tcp.translation() - b.frame_T_tcp.translation()).norm() +
      kLeverMm *
          Eigen::AngleAxisd(a.frame_T_tcp.linear().transpose() * b.frame_T_tcp.linear()).angle();
  for (std::size_t k = 0; k < std::min(a.joints.size(), b.joints.size()); ++k)
    d += kLeverMm * std::abs(a.joints[k] - b.joints[k]);
  for (std::size_t k = 0; k < std::min(a.externals.size(), b.externals.size()); ++k)
    d += kLeverMm * std::abs(a.externals[k] - b.externals[k]);
  return d;
}

// Is the change one that a reader refuses, or that moves the target by some tenths of a millimetre?
bool matters(Subject& s, std::size_t m) {
  const plan::ReadProgram now = read(s.text, s.process);
  return !now.defects.empty() || now.motions.size() != s.read.motions.size() ||
         apart(now.motions[m], s.read.motions[m]) > 0.3;
}

// Positions of the target's numbers in a motion's line.
std::vector<std::pair<std::size_t, std::size_t>> targetNumbers(Subject& s, std::size_t m) {
  std::string& line = lineOf(s, m);
  const std::string as = line;
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const auto& where : numbersIn(as)) {
    line = withNumber(as, where, std::stod(as.substr(where.first)) + 1e-6);
    const plan::ReadProgram moved = read(s.text, s.process);
    if (moved.defects.empty() && moved.motions.size() == s.read.motions.size() &&
        !sameTarget(moved.motions[m], s.read.motions[m]))
      found.push_back(where);
  }
  line = as;
  return found;
}

using Change = std::function<std::vector<std::string>(const std::string&)>;

Mutation ofNumber(std::size_t k, const std::string& what, Change change) {
  return {"number " + std::to_string(k + 1) + " of the target " + what,
          [k, change](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
            const auto numbers = targetNumbers(s, m);
            if (k >= numbers.size())
              return std::nullopt;
            std::string& line = lineOf(s, m);
            const std::string as = line;
            const auto [begin, end] = numbers[k];
            for (const std::string& number : change(as.substr(begin, end - begin))) {
              line = as.substr(0, begin) + number + as.substr(end);
              if (matters(s, m))
                return s.read.motions[m].line;
            }
            line = as;
            return std::nullopt;
          }};
}

std::string fixed(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.7f", value);
  return buffer;
}

// The first line from motion m's on, back or forth, that the pattern is in is changed.
Mutation replaced(const std::string& kind, const std::string& pattern, const std::string& by,
                  bool fromTop = false) {
  return {kind, [pattern, by, fromTop](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
            const std::regex expression(pattern);
            std::size_t line = fromTop ? 1 : s.read.motions[m].line;
            for (; line <= s.text.lines.size(); ++line) {
              std::string& text = s.text.lines[line - 1];
              const std::string now =
                  std::regex_replace(text, expression, by, std::regex_constants::format_first_only);
              if (now != text) {
                text = now;
                return line;
              }
            }
            return std::nullopt;
          }};
}
Mutation erased(const std::string& kind, const std::string& pattern, bool fromTop = false) {
  return {kind, [pattern, fromTop](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
            const std::regex expression(pattern);
            for (std::size_t line = fromTop ? 1 : s.read.motions[m].line;
                 line <= s.text.lines.size(); ++line)
              if (std::regex_search(s.text.lines[line - 1], expression)) {
                s.text.lines.erase(s.text.lines.begin() + at(line));
                return line;
              }
            return std::nullopt;
          }};
}
// A line that the pattern is in comes three lines later.
Mutation shifted(const std::string& kind, const std::string& pattern) {
  return {kind, [pattern](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
            const std::regex expression(pattern);
            for (std::size_t line = s.read.motions[m].line; line + 3 <= s.text.lines.size(); ++line)
              if (std::regex_search(s.text.lines[line - 1], expression)) {
                std::rotate(s.text.lines.begin() + at(line), s.text.lines.begin() + at(line + 1),
                            s.text.lines.begin() + at(line + 4));
                return line;
              }
            return std::nullopt;
          }};
}
Mutation inserted(const std::string& line) {
  return {"amid: " + line, [line](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
            const std::size_t where = s.read.motions[m].line + 1;
            s.text.lines.insert(s.text.lines.begin() + at(where), ended(s, line));
            return where;
          }};
}
Mutation insertedInHead(const std::string& line) {
  return {"in the head: " + line, [line](Subject& s, std::size_t, std::mt19937_64&) -> Line {
            const std::size_t where = s.read.motions[0].line;
            s.text.lines.insert(s.text.lines.begin() + at(where), ended(s, line));
            return where;
          }};
}

void structure(std::vector<Mutation>& all) {
  all.push_back({"a motion is missing", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   const std::size_t line = s.read.motions[m].line;
                   s.text.lines.erase(s.text.lines.begin() + at(line));
                   return line;
                 }});
  all.push_back(
      {"ten motions are missing", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
         const std::size_t line = s.read.motions[m].line;
         for (std::size_t n = 10; n-- > 0;)
           s.text.lines.erase(s.text.lines.begin() + at(s.read.motions[m + n].line));
         return line;
       }});
  all.push_back(
      {"two motions have changed places", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
         std::swap(lineOf(s, m), lineOf(s, m + 1));
         return s.read.motions[m].line;
       }});
  all.push_back({"two motions far apart have changed places",
                 [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   std::swap(lineOf(s, m), lineOf(s, m + 4));
                   return s.read.motions[m].line;
                 }});
  all.push_back({"a block is doubled", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   const std::size_t a = s.read.motions[m].line, b = s.read.motions[m + 4].line;
                   const std::vector<std::string> block(s.text.lines.begin() + at(a),
                                                        s.text.lines.begin() + at(b));
                   s.text.lines.insert(s.text.lines.begin() + at(b), block.begin(), block.end());
                   return b;
                 }});
  all.push_back({"a block is moved", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   const std::size_t a = s.read.motions[m].line, b = s.read.motions[m + 3].line;
                   std::rotate(s.text.lines.begin() + at(a), s.text.lines.begin() + at(b),
                               s.text.lines.begin() + at(s.read.motions[m + 6].line));
                   return a;
                 }});
  all.push_back({"the file ends early", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   s.text.lines.resize(s.read.motions[m].line);
                   return s.text.lines.size();
                 }});
  all.push_back(
      {"the file ends within a line", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
         s.text.lines.resize(s.read.motions[m].line);
         s.text.lines.back().resize(s.text.lines.back().size() / 2);
         return s.text.lines.size();
       }});
  all.push_back({"the last line is missing", [](Subject& s, std::size_t, std::mt19937_64&) -> Line {
                   s.text.lines.pop_back();
                   return s.text.lines.size();
                 }});
  all.push_back(
      {"a line of another language", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
         const std::size_t where = s.read.motions[m].line + 1;
         s.text.lines.insert(s.text.lines.begin() + at(where),
                             ended(s, s.text.format == "krl" ? "movel(p[1,2,3,0,0,0])"
                                                             : "LIN {X 1,Y 2,Z 3} C_DIS"));
         return where;
       }});
  all.push_back({"a character is lost at a line's begin",
                 [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   std::string& line = lineOf(s, m);
                   line.erase(line.find_first_not_of(' '), s.text.format == "csv" ? 4 : 1);
                   return s.read.motions[m].line;
                 }});
  all.push_back({"a binary character", [](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                   lineOf(s, m).insert(3, 1, '\x01');
                   return s.read.motions[m].line;
                 }});
}

void targets(std::vector<Mutation>& all, std::size_t numbers) {
  for (std::size_t k = 0; k < numbers; ++k) {
    all.push_back(ofNumber(k, "a little off", [](const std::string& n) {
      std::vector<std::string> more;
      for (const double off : {0.0015, 0.03, 0.3, 2.0})
        more.push_back(fixed(std::stod(n) + off));
      return more;
    }));
    all.push_back(ofNumber(k, "has the other sign",
                           [](const std::string& n) { return std::vector{fixed(-std::stod(n))}; }));
    all.push_back(ofNumber(k, "lost its point", [](const std::string& n) {
      const std::size_t point = n.find('.');
      return point == std::string::npos ? std::vector<std::string>{}
                                        : std::vector{n.substr(0, point) + n.substr(point + 1)};
    }));
  }
}

void words(std::vector<Mutation>& all, const std::string& format) {
  for (const std::string& line : linesDuringPrint(format))
    all.push_back(inserted(line));
  if (format == "urscript") {
    all.push_back(replaced("time ten times", ",t=([0-9])", ",t=9$1"));
    all.push_back(replaced("time a fifth more", ",t=0\\.0?", ",t=0.2"));
    all.push_back(replaced("a time becomes a speed", ",t=", ",v="));
    all.push_back(replaced("blend of 10 mm", ",r=0\\.0+", ",r=0.01"));
    all.push_back(replaced("motion by joints", "movel\\(", "movej("));
    all.push_back(replaced("tool 1 mm off", "set_tcp\\(p\\[0\\.000000000,0\\.000000000,0\\.100",
                           "set_tcp(p[0.000000000,0.000000000,0.101", true));
    all.push_back(replaced("load of 20 kg", "set_payload\\([0-9.]+", "set_payload(20", true));
    all.push_back(replaced("first motion fast", ",v=0\\.25", ",v=2.5", true));
    all.push_back(erased("the prime is missing", "sleep\\(", true));
    all.push_back(replaced("ten times the prime", "sleep\\(0\\.2", "sleep(2", true));
    all.push_back(erased("the extruder stays on", "digital_out\\(0,False\\)"));
    all.push_back(shifted("the extruder starts late", "digital_out\\(0,True\\)"));
    all.push_back(shifted("the extruder stops late", "digital_out\\(0,False\\)"));
    all.push_back(insertedInHead("  set_gravity([0,9.82,0])"));
  } else if (format == "rapid") {
    all.push_back(replaced("speed of 900", "\\]\\],\\[[0-9.]+", "]],[900"));
    all.push_back(replaced("speed of 1", "\\]\\],\\[[0-9.]+", "]],[1"));
    all.push_back(replaced("turn at no speed", "(\\]\\],\\[[0-9.]+),[0-9]+,", "$1,0,"));
    all.push_back(replaced("zone of 10 mm", "\\[FALSE,[0-9.]+,[0-9.]+,[0-9.]+", "[FALSE,10,10,10"));
    all.push_back(replaced("motion by joints", "MoveL|TriggL", "MoveJ"));
    all.push_back(replaced("tool 1 mm off", "\\[\\[0,0,100\\]", "[[0,0,101]", true));
    all.push_back(replaced("load of 20 kg", "\\],\\[0\\.5[0-9]*,", "],[20,", true));
    all.push_back(replaced("first motion fast", "\\[50,20,", "[900,900,", true));
    all.push_back(erased("the prime is missing", "WaitTime", true));
    all.push_back(replaced("ten times the prime", "WaitTime 0\\.2", "WaitTime 2", true));
    all.push_back(erased("the extruder stays on", "SetDO doExtruder,0"));
    all.push_back(shifted("the extruder starts late", "SetDO doExtruder,1"));
    all.push_back(shifted("the extruder stops late", "SetDO doExtruder,0"));
    all.push_back(insertedInHead("    AccSet 20,100;"));
  } else if (format == "krl") {
    all.push_back(replaced("speed of 0.9", "\\$VEL\\.CP=[0-9.]+", "$$VEL.CP=0.9"));
    all.push_back(replaced("speed of 0.001", "\\$VEL\\.CP=[0-9.]+", "$$VEL.CP=0.001"));
    all.push_back(replaced("a speed in mm/s", "\\$VEL\\.CP=0\\.0", "$$VEL.CP=1"));
    all.push_back(erased("a speed is missing", "\\$VEL\\.CP="));
    all.push_back(replaced("motion by joints", "^LIN", "PTP"));
    all.push_back(replaced("a motion of another kind", "^LIN", "LIN_REL"));
    all.push_back(replaced("another way to round", "C_DIS", "C_VEL"));
    all.push_back(
        replaced("tool 1 mm off", "\\$TOOL=\\{X 0,Y 0,Z ([0-9]+)", "$$TOOL={X 1,Y 0,Z $1", true));
    all.push_back(replaced("the modes are changed", "#TCP", "#BASE", true));
    all.push_back(replaced("load of 20 kg", "\\{M [0-9.]+", "{M 20", true));
    all.push_back(replaced("first motion fast", "VEL_PTP,10", "VEL_PTP,100", true));
    all.push_back(erased("the prime is missing", "WAIT SEC", true));
    all.push_back(replaced("ten times the prime", "WAIT SEC 0\\.2", "WAIT SEC 2", true));
    all.push_back(erased("the extruder stays on", "^\\$OUT\\[1\\]=FALSE"));
    all.push_back(shifted("the extruder starts late", "^\\$OUT\\[1\\]=TRUE"));
    all.push_back(shifted("the extruder stops late", "^\\$OUT\\[1\\]=FALSE"));
    all.push_back(insertedInHead("$OV_PRO=50"));
  } else if (format == "spel") {
    all.push_back(replaced("speed of 900", "SpeedS [0-9.]+", "SpeedS 900"));
    all.push_back(replaced("speed of 1", "SpeedS [0-9.]+", "SpeedS 1"));
    all.push_back(erased("the speed is missing", "SpeedS ", true));
    all.push_back(replaced("acceleration of 1", "AccelS [0-9.]+", "AccelS 1", true));
    all.push_back(replaced("motion by joints", "Move ", "Go "));
    all.push_back(replaced("a motion of another kind", "Move ", "BMove "));
    all.push_back(replaced("straight for the tool", " ECP", ""));
    all.push_back(replaced("until an input", " CP", " Till Sw(1) = On"));
    all.push_back(replaced("at no stop", " CP", " ROT CP"));
    all.push_back(replaced("tool 1 mm off", "TLSet 1, XY\\(0,0,", "TLSet 1, XY(1,0,", true));
    all.push_back(replaced("another tool", "Tool 1", "Tool 2", true));
    all.push_back(replaced("load of 20 kg", "Weight [0-9.]+", "Weight 20", true));
    all.push_back(replaced("first motion fast", "Speed 10", "Speed 100", true));
    all.push_back(erased("slow to the end", "Power High", true));
    all.push_back(erased("the prime is missing", "Wait ", true));
    all.push_back(replaced("ten times the prime", "Wait 0\\.2", "Wait 2", true));
    all.push_back(erased("the extruder stays on", "Off 1"));
    all.push_back(shifted("the extruder starts late", "On 1"));
    all.push_back(shifted("the extruder stops late", "Off 1"));
  } else if (format.starts_with("gcode")) {
    if (format == "gcode-bc") {
      all.push_back(replaced("a motion loses its time", " F[0-9.]+$", ""));
      all.push_back(replaced("a rapid motion", "^G1", "G0"));
      all.push_back(erased("speeds are no times", "^G93", true));
      all.push_back(erased("the nozzle is not up", "^G1 Z", true));
      all.push_back(erased("the table does not stand", "^G1 B", true));
      all.push_back(replaced("the place of the plate is broken", "tilt axis, mm: X0 Z0",
                             "tilt axis, mm: X0 Z", true));
      all.push_back(replaced("C a whole turn on", " C0", " C360.0"));
    }
    all.push_back(replaced("speed ten times", "F([0-9])", "F9$1"));
    all.push_back(replaced("speed of 60", "F[0-9.]+", "F60"));
    all.push_back(replaced("E is twice", "E([0-9.]+)", "E9$1"));
    all.push_back(replaced("E is missing", " E[0-9.]+", ""));
    all.push_back(replaced("a print becomes an arc", "^G1", "G2"));
    all.push_back(replaced("filament of 2.85 mm", "diameter 1\\.75", "diameter 2.85", true));
    all.push_back(replaced("heat of 400", "M104 S210", "M104 S400", true));
    all.push_back(erased("the prime is missing", "; prime", true));
    all.push_back(replaced("ten times the prime", "G1 E([0-9])", "G1 E9$1", true));
  } else if (format == "melfa") {
    all.push_back(replaced("speed ten times", "Spd ([0-9])", "Spd 9$1"));
    all.push_back(replaced("speed of 1", "Spd [0-9.]+", "Spd 1"));
    all.push_back(erased("a speed is missing", "Spd "));
    all.push_back(replaced("motion by joints", "EMvs 1,", "Mov "));
    all.push_back(replaced("the plate's own way", "EMvs 1,", "Mvs "));
    all.push_back(replaced("another nozzle", "EMvs 1,", "EMvs 2,"));
    all.push_back(replaced("tool 1 mm off", "Tool \\(0,0,[0-9]+", "Tool (0,0,777", true));
    all.push_back(replaced("first motion fast", "JOvrd [0-9.]+", "JOvrd 100", true));
    all.push_back(erased("the prime is missing", "Dly", true));
    all.push_back(replaced("ten times the prime", "Dly 0\\.2", "Dly 2", true));
    all.push_back(erased("the extruder stays on", "M_Out\\(10\\)=0"));
    all.push_back(shifted("the extruder starts late", "M_Out\\(10\\)=1"));
    all.push_back(shifted("the extruder stops late", "M_Out\\(10\\)=0"));
    all.push_back(replaced("two steps of one number", "^[0-9]+ ", "7 "));
    all.push_back(replaced("another output", "M_Out\\(10\\)", "M_Out(11)"));
    all.push_back(insertedInHead("Accel 20,20"));
    all.push_back(insertedInHead("Base (0,0,10,0,0,0)"));
  } else if (format == "melfa-datalink" || format == "krl-eki") {
    // Columns: target, speed, of KRL the turn, flow, blend.
    const bool turns = format == "krl-eki";
    const std::string target = "^((?:[^,]*,){6})",
                      speed = turns ? "^((?:[^,]*,){8})" : "^((?:[^,]*,){7})",
                      flow = turns ? "^((?:[^,]*,){9})" : "^((?:[^,]*,){8})",
                      on = turns ? "0.4" : "4000", start = turns ? ",10,0,0,-2" : ",8,0,-2",
                      still = turns ? ",0" : "";
    all.push_back(replaced("speed ten times", target + "([0-9])", "$019$2"));
    all.push_back(replaced("speed of 1", target + "[0-9.]+", "$011"));
    all.push_back(replaced("a motion becomes the end", target + "[0-9.]+", "$010"));
    all.push_back(replaced("a motion becomes a wait", target, "$01-"));
    all.push_back(replaced("more flow", speed + "[0-9.]+", turns ? "$010.9999" : "$019999"));
    all.push_back(replaced("no flow", speed + "[0-9.]+", "$010"));
    all.push_back(
        replaced("flow of more than all", speed + "[0-9.]+", turns ? "$011.0001" : "$0110001"));
    all.push_back(replaced("the extruder stays on", ",0,(0|-2)$", "," + on + ",$1"));
    all.push_back(replaced("blend of 10 mm", flow + "0\\.[0-9]+", "$0110"));
    all.push_back(replaced("motion by joints", flow + "0\\.[0-9]+", "$01-2"));
    all.push_back(replaced("a pose becomes joints", flow + "0\\.[0-9]+", "$01-1"));
    all.push_back(replaced("a blend that there is not", flow + "0\\.[0-9]+", "$01-3"));
    all.push_back(replaced("a column too many", ",", ",0,"));
    all.push_back(replaced("a column is missing", ",[^,]*,", ","));
    all.push_back(replaced("another header", "([zZ])_mm", "$1_m", true));
    all.push_back(replaced("no header", "^([xX]_mm)", "# $1", true));
    all.push_back(replaced("a line becomes a remark", "^(-?[0-9])", "# $1"));
    all.push_back(replaced("tool 1 mm off", "^tool,0,0,[0-9]+", "tool,0,0,777", true));
    all.push_back(erased("the tool is missing", "^tool", true));
    all.push_back(replaced("the nozzle stands elsewhere", "^nozzle,-?[0-9.]+", "nozzle,777", true));
    all.push_back(replaced("first motion fast", start, turns ? ",100,0,0,-2" : ",100,0,-2", true));
    all.push_back(erased("the start is missing", start, true));
    all.push_back(erased("the prime is missing", ",-0\\.2,", true));
    all.push_back(replaced("ten times the prime", ",-0\\.2,", ",-2,", true));
    if (turns) {
      const std::string rotation = "^((?:[^,]*,){7})";
      all.push_back(replaced("no turn", rotation + "[0-9.]+", "$010"));
      all.push_back(replaced("a turn back", rotation, "$01-"));
      all.push_back(erased("the nozzle is missing", "^nozzle", true));
      all.push_back(erased("the load is missing", "^load", true));
      all.push_back(replaced("load of 20 kg", "^load,[0-9.]+", "load,20", true));
      all.push_back(insertedInHead("base,0,0,10,0,0,0"));
    } else {
      all.push_back(replaced("a flow of a half", speed + "([0-9]+)", "$01$2.5"));
    }
    for (const std::string& wait : {",-600" + still + "," + on + ",0", ",-600" + still + ",0,0",
                                    ",-0.5" + still + "," + on + ",0", ",0" + still + ",0,0"})
      all.push_back({"amid, where the arm is: " + wait,
                     [wait](Subject& s, std::size_t m, std::mt19937_64&) -> Line {
                       const std::size_t line = s.read.motions[m].line;
                       std::smatch place;
                       std::regex_search(s.text.lines[line - 1], place,
                                         std::regex("^(?:[^,]*,){5}[^,]*"));
                       s.text.lines.insert(s.text.lines.begin() + at(line + 1), place.str() + wait);
                       return line + 1;
                     }});
  } else if (format == "tmscript") {
    all.push_back(replaced("time ten times", "(PVTPoint.*),0(\\.[0-9]+)\\)", "$1,9$2)"));
    all.push_back(replaced("time is missing", "(PVTPoint.*),[0-9.]+\\)", "$1)"));
    all.push_back(replaced("no time", "(PVTPoint.*),[0-9.]+\\)", "$1,0)"));
    const std::string pose = "(PVTPoint\\([^,]*,[^,]*,[^,]*,[^,]*,[^,]*,[^,]*),";
    all.push_back(replaced("velocity of 900", pose + "[^,]*", "$1,900"));
    all.push_back(replaced("velocity back", pose + "[^,]*,[^,]*", "$1,-90,-90"));
    all.push_back(replaced("a turn of 900", pose + "([^,]*,[^,]*,[^,]*),[^,]*", "$1,$2,900"));
    all.push_back(replaced("tool 1 mm off", "ChangeTCP\\(\\{0", "ChangeTCP({1", true));
    all.push_back(replaced("load of 20 kg", "\\},[0-9.]+\\)", "},20)", true));
    all.push_back(replaced("first motion fast", ",8,500,", ",100,500,", true));
    all.push_back(replaced("ten times the prime", ",0\\.2\\)", ",2)", true));
    all.push_back(erased("the extruder stays on", "DO\\[0\\]=0"));
    all.push_back(shifted("the extruder starts late", "DO\\[0\\]=1"));
    all.push_back(shifted("the extruder stops late", "DO\\[0\\]=0"));
    all.push_back(replaced("joints for a pose", "PVTEnter\\(1\\)", "PVTEnter(0)", true));
    all.push_back(insertedInHead("ChangeBase({0,0,10,0,0,0})"));
    all.push_back(insertedInHead("ChangeBase(\"table\")"));
  } else if (format.ends_with("-stream")) {
    const std::string row = "^(2(?:,[^,]*){7},[01],)";
    all.push_back(replaced("time ten times", "^2,0\\.0?", "2,9."));
    all.push_back(replaced("time is less", "^2,[0-9.]+", "2,0.001"));
    all.push_back(replaced("no time", "^2,[0-9.]+", "2,0"));
    all.push_back(replaced("time runs back", "^2,", "2,-"));
    all.push_back(replaced("a motion becomes a wait", "^2,", "3,"));
    all.push_back(replaced("a motion becomes the start", "^2,[0-9.]+", "1,0"));
    all.push_back(replaced("a motion becomes the end", "^2,[0-9.]+", "0,0"));
    all.push_back(replaced("a kind that there is not", "^2,", "4,"));
    all.push_back(replaced("more flow", row + "[0-9.]+", "$010.999"));
    all.push_back(replaced("no flow", row + "[0-9.]+", "$010"));
    all.push_back(replaced("flow of more than all", row + "[0-9.]+", "$011.5"));
    all.push_back(replaced("the extruder is off", ",1,([0-9.]+)$", ",0,$1"));
    all.push_back(replaced("the extruder stays on", ",0,0$", ",1,0.4"));
    all.push_back(replaced("half an extruder", ",1,([0-9.]+)$", ",0.5,$1"));
    all.push_back(replaced("a column too many", ",", ",0,"));
    all.push_back(replaced("a column is missing", ",[^,]*,", ","));
    all.push_back(replaced("another header", "j1_rad", "j1_deg", true));
    all.push_back(replaced("no header", "^kind", "# kind", true));
    all.push_back(replaced("a row becomes a remark", "^2", "# 2"));
    all.push_back(erased("the prime is missing", "^3,", true));
    all.push_back(replaced("ten times the prime", "^3,0\\.2", "3,2", true));
    all.push_back(erased("the start is missing", "^1,", true));
  } else {
    all.push_back(replaced("E is more", ",([0-9.]+),([0-9]+),print", ",9$1,$2,print"));
    all.push_back(replaced("E is less", ",[0-9.]+,([0-9]+),print", ",0,$1,print"));
    all.push_back(replaced("time is more", "^([0-9])", "9$1"));
    all.push_back(replaced("time is less", "^[0-9.]+", "0"));
    all.push_back(replaced("a column too many", ",", ",0,"));
    all.push_back(replaced("a column is missing", ",[^,]*,", ","));
    all.push_back(replaced("another header", "j1_deg", "j1_rad", true));
    all.push_back(replaced("no header", "^time_s", "# time_s", true));
    all.push_back(replaced("a row becomes a remark", "^([0-9])", "# $1"));
    all.push_back(replaced("another word for a move", "print$", "prnt"));
    all.push_back(replaced("a waypoint of a half", ",([0-9]+),print", ",$1.5,print"));
  }
}

} // namespace

std::vector<Mutation> harmfulMutations(const std::string& format) {
  std::vector<Mutation> all;
  structure(all);
  targets(all, format == "gcode-bc" ? 5 : format.starts_with("gcode") ? 3 : 6);
  words(all, format);
  all.push_back(lowerFlow(format, 0.8, 200));
  for (Mutation& mutation : statedMutations(format))
    all.push_back(std::move(mutation));
  return all;
}

} // namespace voluta::test
