#include "replay/statement_mutations.h"

#include "program/common/program_text.h"
#include "program/dialect.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <regex>
#include <set>

namespace voluta::test {

namespace {

bool has(const std::string& line, const char* pattern) {
  return std::regex_search(line, std::regex(pattern));
}

// Statements that only prepare the next motion or the flow, or show a message: they may be anywhere
// between two motions; so may heat that a wait for it states again.
bool isSetting(const std::string& line) {
  return has(line,
             R"(analog_out|ANOUT|aoFlow|AIO_Out|M_Outw|\.AO\[|VEL|APO\.CDIS|SpeedS|AccelS)") ||
         has(line, R"(Spd |Cnt |Speed [0-9]|JOvrd|MsgNotify|Print |Open |Close |QueueTag|PVTE)") ||
         has(line, R"(^M10[467]|^M140|^M117|VEL_PTP)");
}
// Statements that take time.
bool isTimed(const std::string& line) {
  return has(line, R"(sleep\(|WaitTime|WAIT SEC|Wait [0-9]|Dly|PVTPoint|^G4|^,-|^3,)") ||
         has(line, R"(popup|UIMsgBox|^HALT|  Pause|Hlt|^M0|Pause\(\)|^M109|^M190)");
}
bool isOfCut(const std::string& line) {
  return has(line, R"(out\(7|PULSE|PulseDO|sleep\(0\.2\)|M42|M400|^G4 P200)");
}
bool isText(const std::string& line) {
  return has(line, R"("[^"]{9,}"|^M0)");
}
// A second one changes nothing.
bool isRepeatable(const std::string& line) {
  return has(line, R"(^M109|^M190|PVTPoint)") || isOfCut(line);
}

class Statements {
public:
  Statements(const ProgramText& whole, const plan::ReadProgram& read) : whole_(whole), read_(read) {
    for (const plan::ProgramMotion& motion : read.motions)
      motions_.insert(motion.line);
    for (const plan::StatedFact& fact : read.facts)
      if (fact.kind == plan::FactKind::MarkSet || fact.kind == plan::FactKind::MarkAwaited)
        marks_.insert(fact.line);
  }

  std::vector<StatementEdit> edits() {
    for (const std::size_t l : lines()) {
      removed(l);
      doubled(l);
      exchanged(l);
      moved(l);
      numbers(l);
    }
    return std::move(edits_);
  }

private:
  const std::string& line(std::size_t number) const { return whole_.lines[number - 1]; }
  bool isStatement(std::size_t number) const {
    if (number > whole_.lines.size() || motions_.contains(number))
      return false;
    const std::string bare = std::regex_replace(line(number), std::regex("^[0-9]+ "), "");
    const std::string_view text = program::trimmed(bare);
    return !text.empty() && !text.starts_with(program::findDialect(whole_.format).remark);
  }
  // Of all places between two motions at which something happens.
  std::vector<std::size_t> lines() const {
    std::set<std::size_t> places;
    for (const plan::StatedFact& fact : read_.facts)
      places.insert(fact.before);
    for (const plan::ProgramPause& pause : read_.pauses)
      places.insert(pause.before);
    std::vector<std::size_t> found;
    for (const std::size_t m : places)
      if (m > 1 && m < read_.motions.size())
        for (std::size_t l = read_.motions[m - 1].line + 1; l < read_.motions[m].line; ++l)
          if (isStatement(l) && !isSetting(line(l)))
            found.push_back(l);
    return found;
  }

  std::ptrdiff_t at(std::size_t number) const { return static_cast<std::ptrdiff_t>(number) - 1; }
  StatementEdit& add(std::string kind, std::size_t first, std::size_t last) {
    return edits_.emplace_back(StatementEdit{std::move(kind), whole_, first, last});
  }

  // Where the change of a line should be found: a cut at any of its lines, an amount where filament
  // is next needed.
  std::size_t firstOf(std::size_t l) const {
    return isOfCut(line(l)) ? *std::prev(motions_.upper_bound(l)) + 1 : l;
  }
  std::size_t lastOf(std::size_t l) const {
    const auto bead = std::ranges::find_if(
        read_.motions, [&](const plan::ProgramMotion& m) { return m.extruding && m.line > l; });
    return has(line(l), "^G92") && bead != read_.motions.end() ? bead->line : l;
  }

  void removed(std::size_t l) {
    // The pulse takes no time, so that the extruder may run.
    if (has(line(l), R"(doExtruder,0|OUT\[1\]=FALSE)") && has(line(l + 1), "PulseDO|PULSE"))
      return;
    std::vector<std::string>& lines = add("removed", firstOf(l), lastOf(l)).text.lines;
    lines.erase(lines.begin() + at(l));
  }
  void doubled(std::size_t l) {
    if ((!isTimed(line(l)) && !marks_.contains(l)) || isRepeatable(line(l)))
      return;
    std::vector<std::string>& lines = add("doubled", l, l + 1).text.lines;
    lines.insert(lines.begin() + at(l), line(l));
  }
  // Whether the order of two lines is free.
  bool isFree(std::size_t a, std::size_t b) const {
    const std::string &one = line(a), &other = line(b);
    if (one == other || isSetting(other) || isOfCut(one) != isOfCut(other))
      return true;
    const bool isOrdered = isTimed(one) || isTimed(other) || isOfCut(one) ||
                           has(one, "^G1 E|^G92") || has(other, "^G1 E|^G92") ||
                           (marks_.contains(a) && marks_.contains(b));
    return !isOrdered;
  }
  void exchanged(std::size_t l) {
    if (!isStatement(l + 1) || isFree(l, l + 1))
      return;
    std::vector<std::string>& lines = add("exchanged with the next", l, l + 1).text.lines;
    std::swap(lines[l - 1], lines[l]);
  }
  void moveTo(const std::string& kind, std::size_t l, std::size_t to) {
    std::vector<std::string>& lines = add(kind, std::min(l, to), std::max(l, to)).text.lines;
    if (to > l)
      std::rotate(lines.begin() + at(l), lines.begin() + at(l + 1), lines.begin() + at(to + 1));
    else
      std::rotate(lines.begin() + at(to), lines.begin() + at(l), lines.begin() + at(l + 1));
  }
  void moved(std::size_t l) {
    if (has(line(l), "^G92")) // matters to the next amount only
      return;
    const auto behind = motions_.upper_bound(l);
    moveTo("behind a motion", l, *behind);
    moveTo("before a motion", l, *std::prev(behind));
    if (std::distance(behind, motions_.end()) > 2)
      moveTo("behind three motions", l, *std::next(behind, 2));
  }
  void numbers(std::size_t l) {
    const std::string& text = line(l);
    if (isText(text))
      return;
    auto found = numbersIn(text.substr(0, text.find_first_of("{#;'"))); // before a remark
    if (whole_.format == "melfa" && !found.empty())
      found.erase(found.begin()); // of the step
    if (found.size() > 4)
      found.erase(found.begin(), found.end() - 1); // the time of a point
    for (const auto& where : found) {
      const double value = std::stod(text.substr(where.first));
      if (value == 0.0)
        continue;
      // The duration of a cut is free within limits.
      const bool isPulse = isOfCut(text) && (value == 0.2 || value == 200.0);
      for (const double times : {-1.0, isPulse ? 10.0 : 1.3}) {
        const double other = times * value;
        StatementEdit& edit =
            add(times < 0.0 ? "the other sign" : "1.3 times a number", firstOf(l), lastOf(l));
        edit.text.lines[l - 1] = other == std::floor(other)
                                     ? text.substr(0, where.first) +
                                           std::to_string(static_cast<long>(other)) +
                                           text.substr(where.second)
                                     : withNumber(text, where, other);
      }
    }
  }

  const ProgramText& whole_;
  const plan::ReadProgram& read_;
  std::set<std::size_t> motions_, marks_; // lines
  std::vector<StatementEdit> edits_;
};

} // namespace

std::vector<StatementEdit> statementEdits(const ProgramText& whole, const plan::ReadProgram& read) {
  return Statements(whole, read).edits();
}

} // namespace voluta::test
