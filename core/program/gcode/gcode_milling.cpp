#include "program/gcode/gcode_milling.h"

#include "program/common/program_text.h"
#include "program/gcode/gcode_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voluta::program {

using enum plan::FactKind;

namespace {

constexpr double kRapid = 0.0, kStraight = 1.0, kMachine = 53.0;

std::string nameOf(char letter, double number) {
  std::string name(1, letter);
  appendFixed(name, std::clamp(number, -1e6, 1e6), 3, true);
  return name;
}

class MillingReader {
public:
  MillingReader() : defects_(out_.defects) { out_.format = kMillingFormat; }

  plan::ReadProgram read(std::string_view text) {
    LineReader lines(text);
    std::string_view line;
    while (lines.next(line)) {
      line_ = lines.number();
      readLine(trimmed(line.substr(0, line.find(';'))));
    }
    return std::move(out_);
  }

private:
  // A setting that a program states before it moves.
  struct Setting {
    double code;
    std::string_view name;
    bool isStated = false;
  };

  void defect(base::Message reason) { defects_.add(0, line_, std::move(reason)); }
  void state(plan::FactKind kind, double number, std::string_view word = {}) {
    out_.facts.push_back({.kind = kind,
                          .line = static_cast<std::uint32_t>(line_),
                          .before = out_.motions.size(),
                          .number = number,
                          .word = std::string(word)});
  }

  void readLine(std::string_view code) {
    GcodeScanner scanner(code);
    GcodeWord word;
    GcodeWords words; // all but G and M
    std::vector<double> commands, functions;
    bool isSound = true;
    while (isSound && scanner.next(word)) {
      isSound = !word.isBare && !word.isDirection;
      if (word.letter == 'G' || word.letter == 'M')
        (word.letter == 'G' ? commands : functions).push_back(word.value);
      else if (std::optional<double>& slot = words[word.letter]; slot)
        isSound = false; // a word given twice is ambiguous
      else
        slot = word.value;
    }
    if (!isSound || !scanner.ended())
      return defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
    words['N'].reset();
    if (commands.empty() && functions.empty() && !hasWords(words))
      return;
    if (out_.complete)
      return defect("text after the end"_text);
    execute(words, commands, functions);
  }

  static bool hasWords(const GcodeWords& words) {
    return std::ranges::any_of(words.letter, [](const auto& slot) { return slot.has_value(); });
  }

  // In the order of RS-274: feed, speed, spindle on, coordinates, motion, spindle off, end.
  void execute(GcodeWords& words, const std::vector<double>& commands,
               const std::vector<double>& functions) {
    for (char c = 'A'; c <= 'Z'; ++c)
      if (words[c] && std::string_view("AFSXYZ").find(c) == std::string_view::npos)
        return defect(base::message("unknown word {word}"_text, nameOf(c, *words[c])));
    if (words['F'] && !(*words['F'] > 0.0))
      return defect("a speed that is not positive"_text);
    feed_ = words['F'].value_or(feed_);
    if (words['S'])
      setSpindle(*words['S'], isTurning_);
    for (const double m : functions)
      if (m == 3.0)
        setSpindle(rpm_, true);
      else if (m != 5.0 && m != 30.0)
        defect(base::message("unknown word {word}"_text, nameOf('M', m)));
    bool isMachine = false;
    std::size_t motions = 0;
    for (const double g : commands)
      if (g == kRapid || g == kStraight) {
        motion_ = g;
        ++motions;
      } else if (g == kMachine) {
        isMachine = true;
      } else {
        set(g);
      }
    if (motions > 1)
      defect("two commands in one line"_text);
    else if (words['A'] || words.any("XYZ"))
      move(words, isMachine);
    for (const double m : functions)
      if (m == 5.0)
        setSpindle(rpm_, false);
      else if (m == 30.0)
        out_.complete = true;
  }

  void setSpindle(double rpm, bool isTurning) {
    rpm_ = rpm;
    isTurning_ = isTurning;
    state(Spindle, isTurning ? rpm : 0.0);
  }

  void set(double g) {
    if (g == 54.0 || g == 55.0) {
      known_ = {}; // the machine stands where it is, at other coordinates
      return state(TargetFrame, g, g == 54.0 ? "G54" : "G55");
    }
    const auto setting = std::ranges::find(settings_, g, &Setting::code);
    if (setting == settings_.end())
      return defect(base::message("unknown word {word}"_text, nameOf('G', g)));
    setting->isStated = true;
  }

  void move(GcodeWords& words, bool isMachine) {
    if (!motion_)
      return defect("a line without a command"_text);
    for (const Setting& setting : settings_)
      if (!setting.isStated)
        return defect(base::message("a motion before {word}"_text, setting.name));
    if (words['A'] && words.any("XYZ"))
      return defect(
          base::message("a motion with a word {letter} is not understood"_text, std::string("A")));
    if (words['A'])
      return state(BlockTurned, *words['A']);
    if (isMachine)
      return goHome(words);
    for (std::size_t k = 0; k < known_.size(); ++k)
      if (const std::optional<double> to = words[static_cast<char>('X' + k)]) {
        at_[static_cast<Eigen::Index>(k)] = *to;
        known_[k] = true;
      }
    if (std::ranges::find(known_, false) != known_.end())
      return defect("a motion before X, Y and Z are all known"_text);
    const bool isRapid = *motion_ == kRapid;
    if (!isRapid && feed_ == 0.0)
      return defect("a motion before any speed (F)"_text);
    plan::ProgramMotion m;
    m.line = static_cast<std::uint32_t>(line_);
    m.target = plan::TargetKind::ToolPoint;
    m.position = at_;
    m.speedMmPerS = isRapid ? 0.0 : feed_ / 60.0;
    out_.motions.push_back(std::move(m));
  }

  // Elsewhere the machine's own coordinates depend on where the block is clamped.
  void goHome(GcodeWords& words) {
    if (words.any("XY") || words['Z'].value_or(1.0) != 0.0)
      return defect("G53 with another position than Z0 is not understood"_text);
    known_[2] = false;
    state(Home, 1.0);
  }

  plan::ReadProgram out_;
  Defects defects_;
  std::size_t line_ = 0;
  std::array<Setting, 3> settings_{{{21.0, "G21"}, {90.0, "G90"}, {94.0, "G94"}}};
  std::optional<double> motion_; // G0 or G1
  Eigen::Vector3d at_ = Eigen::Vector3d::Zero();
  std::array<bool, 3> known_{}; // X Y Z, in the present coordinates
  double feed_ = 0.0, rpm_ = 0.0;
  bool isTurning_ = false;
};

} // namespace

plan::ReadProgram readMillingGcode(std::string_view text) {
  return MillingReader().read(text);
}

} // namespace voluta::program
