#include "program/gcode_extended.h"

#include "base/error.h"
#include "base/units.h"
#include "program/job_head.h"
#include "program/joint_pieces.h"
#include "program/motion_targets.h"
#include "program/program_builder.h"
#include "program/text.h"
#include "program/walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::program {

namespace {
constexpr int kPositionDecimals = 4, kDirectionDecimals = 6, kFilamentDecimals = 5;
constexpr std::string_view kDiameterNote = "filament diameter ";
constexpr std::string_view kEnd = "; end";

double filamentArea(double diameterMm) {
  return base::kPi / 4.0 * diameterMm * diameterMm;
}

// Usual nozzle temperatures; a process says nothing about it yet.
std::optional<int> nozzleCelsius(std::string_view material) {
  if (material == "PLA")
    return 210;
  if (material == "PETG")
    return 240;
  if (material == "ABS")
    return 245;
  return std::nullopt;
}

// Between which a nozzle prints it; makers' data sheets and what print heads stand.
std::pair<double, double> nozzleRange(std::string_view material) {
  if (material == "PLA")
    return {170.0, 250.0};
  if (material == "PETG")
    return {200.0, 280.0};
  if (material == "ABS")
    return {200.0, 290.0};
  return {100.0, 450.0};
}

// Longer than any path from an extruder's gear to the melt that slicers draw back on (they use 0.5
// to 10 mm).
constexpr double kMostDrawnBackMm = 20.0;

// ---- writer

class GcodeWriter : private Speller {
public:
  GcodeWriter(const ProgramInput& input, const base::RunContext& ctx)
      : in_(input), ctx_(ctx), targets_(motionTargets(input, ctx)) {
    program_.format = "gcode-extended";
    program_.foreign = input.foreign;
  }

  plan::Program write() {
    walkTrajectory(in_, {"gcode-extended", cutsOf(in_.trajectory, 0)}, *this, ctx_);
    return std::move(program_);
  }

private:
  void word(std::string_view letter, double value, int decimals, bool trim = false) {
    out_ += letter;
    appendFixed(out_, value, decimals, trim);
  }

  void beginFile(std::size_t) override {
    out_.reserve(targets_.size() * 90 + 1024);
    const process::Process& p = in_.process;
    out_ +=
        "; Robot program for printing, extended G-code: X Y Z and the nozzle's direction nX nY nZ"
        " in the work frame\n";
    for (const std::string& head : headLines(in_))
      out_ += joined({"; ", head, "\n"});
    if (program_.foreign)
      out_ += "; FOREIGN: not the language of the cell's controller\n";
    out_ += "; ";
    out_ += kDiameterNote;
    word("", kFilamentDiameterMm, 3, true);
    out_ += " mm\nG21\nG90\nM82\n";
    out_ += joined({"M117 ", kStartQuestion, "\nM0\n"});
    const std::optional<int> celsius = nozzleCelsius(p.material);
    if (celsius)
      out_ += joined(
          {"M104 S", std::to_string(*celsius), " ; assumed for ", plainText(p.material), "\n"});
    out_ += "G28\n";
    if (celsius)
      out_ += joined({"M109 S", std::to_string(*celsius), "\n"});
    out_ += "G92 E0\n";
    if (p.primeS > 0.0 && in_.trajectory.extrudedMm3.back() > 0.0) {
      const double mmPerS = primeFlowMm3PerS(p) / filamentArea(kFilamentDiameterMm);
      word("G1 E", mmPerS * p.primeS, kFilamentDecimals, true);
      word(" F", mmPerS * 60.0, 3, true);
      out_ += " ; prime\nG92 E0\n";
    }
  }

  void endFile(std::size_t) override {
    out_ += "M104 S0\nM84\n";
    out_ += kEnd;
    out_ += '\n';
    program_.files.push_back({identifierOf(in_.name) + ".gcode", std::move(out_)});
  }

  void remark(std::string_view text) override { out_ += joined({"; ", text, "\n"}); }
  // The nozzle's way is not a straight one: it is said in pieces.
  void jointMotion(std::size_t i) override {
    const int pieces = i == 0 ? 1 : jointPieces(in_, i);
    for (int k = 1; k < pieces; ++k)
      line("G0", jointPiece(in_, i, static_cast<double>(k) / pieces),
           motionSeconds(in_.trajectory, i) / pieces);
    motion(i, pieces);
  }
  void straightMotion(std::size_t i, bool) override { motion(i); }

  void motion(std::size_t i, int pieces = 1) {
    const plan::Trajectory& t = in_.trajectory;
    std::optional<double> filamentMm;
    if (isPrint(t, i))
      filamentMm = t.extrudedMm3[i] / filamentArea(kFilamentDiameterMm);
    line(filamentMm ? "G1" : "G0", targets_[i], motionSeconds(t, i) / pieces, filamentMm);
  }

  // In `s` seconds from the last one; 0: untimed.
  void line(std::string_view command, const MotionTarget& target, double s,
            std::optional<double> filamentMm = std::nullopt) {
    Eigen::Vector3d tip;
    for (int k = 0; k < 3; ++k)
      tip[k] = roundedTo(target.tipMm[k], kPositionDecimals);
    out_ += command;
    word(" X", tip.x(), kPositionDecimals);
    word(" Y", tip.y(), kPositionDecimals);
    word(" Z", tip.z(), kPositionDecimals);
    word(" nX", target.direction.x(), kDirectionDecimals);
    word(" nY", target.direction.y(), kDirectionDecimals);
    word(" nZ", target.direction.z(), kDirectionDecimals);
    if (filamentMm)
      word(" E", *filamentMm, kFilamentDecimals);
    // The speed between the targets as written, so that rounding doesn't become speed.
    const double length = (tip - lastTip_).norm();
    double speed = s > 0.0 ? length / s : 0.0;
    if (speed < 1e-3) // on the spot, or untimed
      speed = in_.process.travelSpeedMmPerS;
    word(" F", speed * 60.0, 3, true);
    out_ += '\n';
    lastTip_ = tip;
  }

  const ProgramInput& in_;
  const base::RunContext& ctx_;
  std::vector<MotionTarget> targets_;
  plan::Program program_;
  std::string out_;
  Eigen::Vector3d lastTip_ = Eigen::Vector3d::Zero();
};

// ---- reader

// The words of one line: a value for each letter, nX nY nZ apart.
struct Words {
  std::array<std::optional<double>, 26> letter;
  std::array<std::optional<double>, 3> direction;

  std::optional<double>& operator[](char c) { return letter[static_cast<std::size_t>(c - 'A')]; }
  bool any(std::string_view letters) {
    return std::any_of(letters.begin(), letters.end(),
                       [&](char c) { return (*this)[c].has_value(); });
  }
};

class GcodeReader {
public:
  GcodeReader(const process::Process& process, const base::RunContext& ctx)
      : process_(process), ctx_(ctx), out_("gcode-extended", process) {
    out_.program().tellsPauses = true;
  }

  plan::ReadProgram read(const std::vector<plan::ProgramFile>& files) {
    for (out_.file = 0; out_.file < files.size(); ++out_.file) {
      LineReader lines(files[out_.file].text);
      std::string_view line;
      while (lines.next(line)) {
        out_.line = lines.number();
        if (out_.line % 4096 == 0)
          ctx_.checkpoint();
        readLine(line);
      }
    }
    if (out_.file > 0)
      --out_.file; // what is missing is missing at the end of the last file
    const bool complete = cold_ && motorsOff_ && ended_;
    if (!complete)
      defect("the end sequence (M104 S0, M84, '; end') is missing: the file was cut short"_text);
    return out_.take(complete);
  }

private:
  void defect(base::Message reason) { out_.defect(std::move(reason)); }

  void readLine(std::string_view line) {
    if (trimmed(line) == kEnd) {
      ended_ = true;
      return;
    }
    std::string_view code = line;
    if (const std::size_t semicolon = code.find(';'); semicolon != std::string_view::npos) {
      comment(code.substr(semicolon + 1));
      code = code.substr(0, semicolon);
    }
    code = trimmed(code.substr(0, code.find('*'))); // a checksum is not looked at
    if (code.empty())
      return;
    if (ended_)
      defect("text behind the end"_text);
    Words words;
    if (code.starts_with("M117") || code.starts_with("M118"))
      return;
    if (!wordsOf(code, words)) {
      defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
      return;
    }
    execute(words);
  }

  void comment(std::string_view text) {
    text = trimmed(text);
    if (!text.starts_with(kDiameterNote))
      return;
    text.remove_prefix(kDiameterNote.size());
    double diameter = 0.0;
    if (!takeNumber(text, diameter) || diameter < 0.1 || diameter > 20.0)
      defect("not a filament's diameter"_text);
    else
      filamentMm2_ = filamentArea(diameter);
  }

  static bool wordsOf(std::string_view rest, Words& words) {
    while (!(rest = trimmed(rest)).empty()) {
      if (rest.front() == '(') {
        const std::size_t end = rest.find(')');
        if (end == std::string_view::npos)
          return false;
        rest.remove_prefix(end + 1);
        continue;
      }
      std::optional<double>* slot = nullptr;
      char c = rest.front();
      if (c == 'n' && rest.size() > 1 && rest[1] >= 'X' && rest[1] <= 'Z') {
        slot = &words.direction[static_cast<std::size_t>(rest[1] - 'X')];
        rest.remove_prefix(2);
      } else {
        if (c >= 'a' && c <= 'z')
          c = static_cast<char>(c - 'a' + 'A');
        if (c < 'A' || c > 'Z')
          return false;
        slot = &words[c];
        rest.remove_prefix(1);
      }
      double value = 0.0;
      // A blank may stand between a letter and its number.
      if (const std::string_view behind = trimmed(rest);
          !behind.empty() &&
          std::string_view("+-.0123456789").find(behind.front()) != std::string_view::npos)
        rest = behind;
      // Words with nothing behind the letter (G28 X) count as 0; given twice: which one holds?
      if (!rest.empty() && rest.front() != ' ' && !takeNumber(rest, value))
        return false;
      if (slot->has_value() || std::abs(value) > 1e9)
        return false;
      *slot = value;
    }
    return true;
  }

  void execute(Words& w) {
    w['N'].reset();
    if (w['G'] && w['M']) {
      defect("two commands in one line"_text);
      return;
    }
    if (w['G'])
      executeG(*w['G'], w);
    else if (w['M'])
      executeM(*w['M'], w);
    else if (!w['T'])
      defect("a line without a command"_text);
    if (w['T'] && *w['T'] != 0.0)
      defect("another tool than the one that prints"_text);
  }

  void executeG(double g, Words& w) {
    if (g == 0.0 || g == 1.0)
      motion(w);
    else if (g == 4.0)
      out_.pause(std::max(0.0, w['S'].value_or(0.0) + 1e-3 * w['P'].value_or(0.0)), 0.0);
    else if (g == 92.0)
      setPosition(w);
    else if (g == 20.0)
      defect("inches are not understood"_text);
    else if (g == 91.0)
      defect("relative positions are not understood"_text);
    else if (!inTable('G', g))
      defect("a G command that is not known to the reader"_text);
  }

  void executeM(double m, Words& w) {
    if (m == 82.0 || m == 83.0)
      relativeE_ = m == 83.0;
    else if (m == 104.0 || m == 109.0)
      heat(m, w);
    else if (!inTable('M', m))
      defect("an M command that is not known to the reader"_text);
    if (m == 84.0 || m == 18.0)
      motorsOff_ = true;
  }

  bool inTable(char letter, double number) {
    std::string word(1, letter);
    appendFixed(word, std::clamp(number, -1e6, 1e6), 3, true);
    return out_.word(gcodeWords(), word);
  }

  void heat(double m, Words& w) {
    const double celsius = w['S'] ? *w['S'] : w['R'].value_or(0.0);
    const std::string_view word = m == 104.0 ? "M104" : "M109";
    if (celsius == 0.0)
      out_.wordAt(word, kBeforeMotion | kAtEnd);
    else if (celsius != celsius_)
      out_.wordAt(word, kAside);
    if (const auto [least, most] = nozzleRange(process_.material);
        celsius != 0.0 && !(celsius >= least && celsius <= most))
      defect(base::message("{celsius} °C is no heat to print {material} with"_text,
                           base::number(celsius), process_.material));
    celsius_ = celsius;
    cold_ = celsius == 0.0;
  }

  void setPosition(Words& w) {
    if (w.any("XYZ"))
      defect("a shifted origin is not understood"_text);
    if (w['E'])
      e_ = farthestE_ = *w['E'];
  }

  void motion(Words& w) {
    for (const char c :
         {'A', 'B', 'C', 'D', 'H', 'I', 'J', 'K', 'L', 'O', 'P', 'Q', 'R', 'S', 'T', 'U', 'V', 'W'})
      if (w[c]) {
        defect(base::message("a motion with a word {letter} is not understood"_text,
                             std::string(1, c)));
        return;
      }
    if (w['F']) {
      if (!(*w['F'] > 0.0)) {
        defect("a speed that is not above 0"_text);
        return;
      }
      mmPerS_ = *w['F'] / 60.0;
    }
    double pushedMm = 0.0, filamentMm = 0.0;
    if (w['E']) {
      const double before = e_;
      e_ = relativeE_ ? e_ + *w['E'] : *w['E'];
      filamentMm = std::abs(e_ - before);
      if (farthestE_ - e_ > kMostDrawnBackMm && e_ < before)
        defect(base::message("{length:.0f} of filament are drawn back: out of the hot end"_text,
                             base::mm(farthestE_ - e_)));
      pushedMm = std::max(0.0, e_ - farthestE_);
      farthestE_ = std::max(farthestE_, e_);
    }
    const bool turns = w.direction[0] || w.direction[1] || w.direction[2];
    const bool moves = w.any("XYZ") || turns;
    // Before the first target material is pushed out at home (prime); later it would be a blob.
    if (!moves && (pushedMm == 0.0 || out_.program().motions.empty())) {
      out_.pause(mmPerS_ > 0.0 ? filamentMm / mmPerS_ : 0.0, pushedMm * filamentMm2_);
      return;
    }
    if (!target(w, turns))
      return;
    plan::ProgramMotion m;
    m.target = plan::TargetKind::ToolPoint;
    m.position = position_;
    m.direction = direction_;
    m.speedMmPerS = mmPerS_;
    m.volumeMm3 = pushedMm * filamentMm2_;
    m.extruding = pushedMm > 0.0;
    if (mmPerS_ == 0.0)
      defect("a motion before any speed (F)"_text);
    out_.motion(std::move(m));
    cold_ = motorsOff_ = ended_ = false;
  }

  // Takes over the words of a target; false (and a defect) when there is none.
  bool target(Words& w, bool turns) {
    for (const char c : {'X', 'Y', 'Z'}) {
      const auto k = static_cast<std::size_t>(c - 'X');
      if (w[c]) {
        position_[static_cast<Eigen::Index>(k)] = *w[c];
        known_[k] = true;
      }
    }
    if (!known_[0] || !known_[1] || !known_[2]) {
      defect("a motion before X, Y and Z are all known"_text);
      return false;
    }
    if (!turns)
      return true;
    if (!w.direction[0] || !w.direction[1] || !w.direction[2]) {
      defect("a direction needs nX, nY and nZ"_text);
      return false;
    }
    const Eigen::Vector3d n(*w.direction[0], *w.direction[1], *w.direction[2]);
    const double length = n.norm();
    if (!(std::abs(length - 1.0) <= kDirectionTolerance))
      defect("a direction whose length is not 1"_text);
    if (!(length > 0.1 && length < 10.0))
      return false;
    direction_ = n / length;
    return true;
  }

  const process::Process& process_;
  const base::RunContext& ctx_;
  ProgramBuilder out_;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero(), direction_ = Eigen::Vector3d::UnitZ();
  std::array<bool, 3> known_{};
  double mmPerS_ = 0.0, filamentMm2_ = filamentArea(kFilamentDiameterMm);
  double e_ = 0.0, farthestE_ = 0.0, celsius_ = 0.0;
  bool relativeE_ = false, cold_ = false, motorsOff_ = false, ended_ = false;
};

} // namespace

plan::Program writeExtendedGcode(const ProgramInput& input, const base::RunContext& ctx) {
  return GcodeWriter(input, ctx).write();
}

plan::ReadProgram readExtendedGcode(const std::vector<plan::ProgramFile>& files,
                                    const process::Process& process, const base::RunContext& ctx) {
  return GcodeReader(process, ctx).read(files);
}

bool looksLikeExtendedGcode(std::string_view text) {
  LineReader lines(text.substr(0, 16384));
  std::string_view line;
  while (lines.next(line)) {
    line = trimmed(line);
    if (line.empty() || line.front() == ';')
      continue;
    double number = 0.0;
    std::string_view rest = line.substr(1);
    return (line.front() == 'G' || line.front() == 'M' || line.front() == 'N') &&
           takeNumber(rest, number);
  }
  return false;
}

bool mayBeMissingInExtendedGcode(const std::vector<std::string>& lines, std::size_t i) {
  // E is 0 before the prime, not behind it.
  if (lines[i] == "G92 E0")
    return lines[i - 1].find("prime") == std::string::npos;
  for (const char* word : {"G21", "G90", "M82", "G28", "M104 S2", "M109", "M117", "M0"})
    if (lines[i].find(word) != std::string::npos)
      return true;
  return primes(lines, i);
}

} // namespace voluta::program
