#include "program/gcode/gcode_reader.h"

#include "base/units.h"
#include "program/common/arc.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::program {

using enum plan::FactKind;

namespace {
constexpr double kSwitchPin = 42.0; // M42

bool heats(double m) {
  return m == 104.0 || m == 109.0;
}

// Returns whether the command names axes by a letter alone (G28 X): homing, the bed, motors.
bool namesAxes(GcodeWords& w) {
  if (w['G'])
    return *w['G'] == 28.0 || *w['G'] == 29.0;
  return w['M'] && (*w['M'] == 17.0 || *w['M'] == 18.0 || *w['M'] == 84.0);
}
} // namespace

GcodeReader::GcodeReader(std::string_view format, const process::Tooling& tooling,
                         const base::RunContext& ctx)
    : out_(format, tooling), tooling_(tooling), ctx_(ctx), nozzles_(tooling.tools().size()) {
  out_.program().tellsPauses = true;
}

plan::ReadProgram GcodeReader::read(const std::vector<plan::ProgramFile>& files) {
  out_.expectMotionsOf(files);
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
  finish();
  if (out_.file > 0)
    --out_.file; // missing items are reported at the end of the last file
  const bool complete = isCold() && motorsOff_ && ended_;
  if (!complete)
    defect("the end sequence (M104 S0, M84, '; end') is missing: the file is truncated"_text);
  return out_.take(complete);
}

void GcodeReader::readLine(std::string_view line) {
  if (isEnd(trimmed(line))) {
    ended_ = true;
    return;
  }
  std::string_view code = line;
  if (const std::size_t semicolon = code.find(';'); semicolon != std::string_view::npos) {
    comment(code.substr(semicolon + 1));
    code = code.substr(0, semicolon);
  }
  code = trimmed(code.substr(0, code.find('*'))); // checksums are not verified
  if (code.empty())
    return;
  if (ended_)
    defect("text after the end"_text);
  if (isMessage(code))
    return;
  GcodeWords words;
  if (!wordsOf(code, words)) {
    if (takeStop(code))
      return;
    defect(base::message("not understood: '{code}'"_text, code.substr(0, 60)));
    return;
  }
  execute(words);
}

bool GcodeReader::takeStop(std::string_view code) {
  constexpr std::string_view kStop = "M0 ";
  if (!code.starts_with(kStop))
    return false;
  inTable('M', 0.0);
  const std::string_view text = trimmed(code.substr(kStop.size()));
  bool endsByItself = false;
  for (std::size_t i = 0; i < text.size(); ++i)
    endsByItself = endsByItself || endsStop(text, i);
  out_.state(OperatorStop, endsByItself ? 0.0 : 1.0, text);
  return true;
}

bool GcodeReader::isMessage(std::string_view code) const {
  return code.starts_with("M117") || code.starts_with("M118");
}

void GcodeReader::comment(std::string_view text) {
  text = trimmed(text);
  note(text);
  if (!text.starts_with(kDiameterNote))
    return;
  text.remove_prefix(kDiameterNote.size());
  double diameter = 0.0;
  if (!takeNumber(text, diameter) || diameter < 0.1 || diameter > 20.0)
    defect("invalid filament diameter"_text);
  else
    filamentMm2_ = filamentArea(diameter);
}

void GcodeReader::execute(GcodeWords& w) {
  w['N'].reset();
  if (w['G'] && w['M']) {
    defect("two commands in one line"_text);
    return;
  }
  if (!w.bare.empty() && !namesAxes(w)) {
    defect(base::message("the letter {letter} has no number"_text, w.bare));
    return;
  }
  if (w['G'])
    executeG(*w['G'], w);
  else if (w['M'])
    executeM(*w['M'], w);
  else if (!w['T'])
    defect("a line without a command"_text);
  // With M201 to M205, T sets limits of travels; with M104 and M109, it is the heated tool.
  const bool isOther = w['M'] && ((*w['M'] > 200.0 && *w['M'] < 206.0) || heats(*w['M']));
  if (!w['T'] || isOther)
    return;
  if (w['G'] || w['M'])
    defect("a tool is selected together with a command"_text);
  else if (*w['T'] != std::floor(*w['T']))
    defect("a tool other than the printing one"_text);
  else
    out_.selectTool(static_cast<int>(std::clamp(*w['T'], -1.0, 255.0)));
}

double GcodeReader::dwellS(GcodeWords& w) const {
  return w['S'].value_or(0.0) + 1e-3 * w['P'].value_or(0.0);
}

void GcodeReader::executeG(double g, GcodeWords& w) {
  if (g == 0.0 || g == 1.0 || (hasArcs() && (g == 2.0 || g == 3.0)))
    motion(g, w);
  else if (g == 4.0)
    wait(w);
  else if (g == 92.0)
    setPosition(w);
  else if (g == 20.0)
    defect("inches are not understood"_text);
  else if (g == 91.0)
    defect("relative positions are not understood"_text);
  else if (!command(g) && !inTable('G', g))
    defect("unknown G command"_text);
  if (g == 21.0)
    out_.state(Millimetres);
  else if (g == 28.0)
    home(w);
  else if (g == 90.0)
    out_.state(AbsolutePositions);
}

void GcodeReader::executeM(double m, GcodeWords& w) {
  if (m == 82.0 || m == 83.0) {
    relativeE_ = m == 83.0;
    out_.state(FilamentCount);
  } else if (heats(m)) {
    heat(m, w);
  } else if (m == kSwitchPin && w['P'] == static_cast<double>(kGcodeCutPin)) {
    switchCutter(w);
  } else if (!inTable('M', m)) {
    defect("unknown M command"_text);
  }
  isSettled_ = isSettled_ || m == 400.0;
  if (m == 140.0 || m == 190.0)
    heatBed(m, w);
  else if (m == 106.0 || m == 107.0)
    cool(m, w);
  // M1 stops only if a switch is set; with P or S a stop ends by itself.
  if (m == 0.0 || m == 1.0)
    out_.state(OperatorStop, m == 0.0 && !w['P'] && !w['S'] ? 1.0 : 0.0);
  if (m == 84.0 || m == 18.0)
    motorsOff_ = true;
}

void GcodeReader::wait(GcodeWords& w) {
  isSettled_ = false;
  out_.pause(std::max(0.0, dwellS(w)), 0.0);
}

// M42 acts at once, while motions and waits are queued.
void GcodeReader::switchCutter(GcodeWords& w) {
  const double value = w['S'].value_or(-1.0);
  if (value != 0.0 && value != kGcodeFullPin)
    defect("the cutter's output needs S255 or S0"_text);
  else if (!isSettled_)
    defect("the cutter's output runs ahead of the motions: M400 is missing before it"_text);
  out_.setCutter(value > 0.0);
}

bool GcodeReader::inTable(char letter, double number) {
  std::string word(1, letter);
  appendFixed(word, std::clamp(number, -1e6, 1e6), 3, true);
  return out_.word(ownWords(), word) || out_.word(gcodeWords(), word);
}

std::optional<int> GcodeReader::heatedTool(GcodeWords& w) const {
  if (!w['T'])
    return out_.selectedTool();
  for (int tool = 0; tool < static_cast<int>(nozzles_.size()); ++tool)
    if (*w['T'] == static_cast<double>(tool))
      return tool;
  return std::nullopt;
}

// The heat of a tool is part of the change to it.
bool GcodeReader::isJustSelected(int tool) {
  const plan::ReadProgram& program = out_.program();
  for (auto fact = program.facts.rbegin();
       fact != program.facts.rend() && fact->before == program.motions.size(); ++fact)
    if (fact->kind == ToolSelected)
      return fact->tool == tool;
  return false;
}

void GcodeReader::heat(double m, GcodeWords& w) {
  const std::optional<int> tool = heatedTool(w);
  if (!tool) {
    defect("a tool other than the printing one"_text);
    return;
  }
  Nozzle& nozzle = nozzleOf(*tool);
  const process::Material& material = tooling_.at(*tool).process.material;
  const double celsius = w['S'] ? *w['S'] : w['R'].value_or(0.0);
  const std::string_view word = m == 104.0 ? "M104" : "M109";
  // Of several tools, one that is taken off is turned off while another one prints.
  if (celsius == 0.0)
    out_.wordAt(word, nozzles_.size() > 1 ? kAtRest : kBeforeMotion | kAtEnd);
  else if (celsius != nozzle.celsius && !isJustSelected(*tool))
    out_.wordAt(word, kOutsidePrint);
  if (celsius != 0.0 && !prints(material, celsius))
    defect(base::message("{celsius} °C is outside the printing range of {material}"_text,
                         base::number(celsius), material.label));
  out_.stateOf(*tool, NozzleHeat, celsius);
  if (m == 109.0 && celsius > 0.0)
    out_.stateOf(*tool, NozzleHeatWait);
  nozzle.celsius = celsius;
  nozzle.cold = celsius == 0.0;
  nozzle.used = nozzle.used || celsius > 0.0;
}

void GcodeReader::heatBed(double m, GcodeWords& w) {
  const double celsius = w['S'] ? *w['S'] : w['R'].value_or(0.0);
  out_.state(BedHeat, celsius);
  if (m == 190.0 && celsius > 0.0)
    out_.state(BedHeatWait);
}

// P numbers the fans of a machine; the first one cools the part.
void GcodeReader::cool(double m, GcodeWords& w) {
  if (w['P'] && *w['P'] != std::floor(*w['P']))
    defect("an output needs a number and a value"_text);
  if (w['P'].value_or(0.0) == 0.0)
    out_.state(FanSpeed,
               m == 107.0 ? 0.0
                          : std::clamp(w['S'].value_or(kGcodeFullFan) / kGcodeFullFan, 0.0, 1.0));
}

bool GcodeReader::isCold() const {
  return std::ranges::all_of(nozzles_, [](const Nozzle& n) { return n.cold || !n.used; });
}

void GcodeReader::setPosition(GcodeWords& w) {
  const auto isTarget = [&](char c) { return w[c] && isTargetWord(c); };
  const bool turns = isTarget('A') || isTarget('B') || isTarget('C');
  if (w.any("XYZ") || (turns && !setsCount(w)))
    defect("a shifted origin is not understood"_text);
  if (w['E'])
    e_.set(*w['E']);
}

// Without letters all axes go home. Where that is, a program does not state.
void GcodeReader::home(GcodeWords& w) {
  const bool isAll = !w.any("XYZ");
  for (const char axis : {'X', 'Y', 'Z', 'A', 'B', 'C'})
    if (w[axis] && w.bare.empty() && !isHomeNumber(*w[axis]))
      defect("G28 with a number goes to a place first: give letters alone, or none"_text);
  for (std::size_t k = 0; k < homed_.size(); ++k)
    if (isAll || w[static_cast<char>('X' + k)]) {
      homed_[k] = true;
      known_[k] = false;
    }
  out_.state(Home, homed_[0] && homed_[1] && homed_[2] ? 1.0 : 0.0);
}

double GcodeReader::secondsOf(GcodeWords&, double filamentMm) {
  return perS_ > 0.0 ? filamentMm / perS_ : 0.0;
}

void GcodeReader::motion(double g, GcodeWords& w) {
  isSettled_ = false;
  const bool isArc = g > 1.0;
  for (const char c : std::string_view("ABCDHIJKLOPQRSTUVW"))
    if (w[c] && !isTargetWord(c) && !(isArc && (c == 'I' || c == 'J'))) {
      defect(
          base::message("a motion with a word {letter} is not understood"_text, std::string(1, c)));
      return;
    }
  if (w['F']) {
    if (!(*w['F'] > 0.0)) {
      defect("a speed that is not positive"_text);
      return;
    }
    perS_ = *w['F'] / 60.0;
  }
  double pushedMm = 0.0, filamentMm = 0.0;
  if (w['E']) {
    const double before = e_.mm();
    pushedMm = e_.to(relativeE_ ? before + *w['E'] : *w['E']);
    filamentMm = std::abs(e_.mm() - before);
    if (e_.drawnBackMm() > kMaxDrawnBackMm && e_.mm() < before)
      defect(base::message("{length:.0f} of filament retracted: out of the hot end"_text,
                           base::mm(e_.drawnBackMm())));
  }
  const bool moves = w.any("XYZ") || isArc || movesBeside(w);
  // Material that is extruded at rest: a prime, a purge, or a blob.
  if (!moves) {
    nozzleOf(out_.selectedTool()).used |= pushedMm > 0.0;
    out_.pause(secondsOf(w, filamentMm), pushedMm * filamentMm2_, filamentMm - pushedMm);
    return;
  }
  plan::ProgramMotion m;
  m.target = plan::TargetKind::ToolPoint;
  m.volumeMm3 = pushedMm * filamentMm2_;
  m.extruding = pushedMm > 0.0;
  const bool fromKnown = knows('X') && knows('Y') && knows('Z');
  const Eigen::Vector3d from = position_;
  if (isArc && !fromKnown) {
    defect("an arc from a position that is not known"_text);
    return;
  }
  if (!target(w, g, m.extruding, m) || (isArc && !arc(from, g, w, m)))
    return;
  if (perS_ == 0.0)
    defect("a motion before any speed (F)"_text);
  out_.motion(std::move(m));
  nozzleOf(out_.selectedTool()).used |= pushedMm > 0.0;
  for (Nozzle& nozzle : nozzles_)
    nozzle.cold = false;
  motorsOff_ = ended_ = false;
}

// I and J lead from the start to the centre, in the plane of X and Y.
bool GcodeReader::arc(const Eigen::Vector3d& from, double g, GcodeWords& w,
                      plan::ProgramMotion& m) {
  constexpr double kSameMm = 0.01;
  const Eigen::Vector3d offset(w['I'].value_or(0.0), w['J'].value_or(0.0), 0.0);
  const double side = g == 3.0 ? 1.0 : -1.0;
  const std::optional<Arc> arc =
      arcAbout(from + offset, side * Eigen::Vector3d::UnitZ(), from, m.position);
  if (!arc || (!w['I'] && !w['J'])) {
    defect("an arc without its centre, I and J"_text);
    return false;
  }
  if (std::abs(m.position.z() - from.z()) > kSameMm) {
    defect("an arc that changes its height is not understood"_text);
    return false;
  }
  if (arc->distanceMm(m.position) > kSameMm) {
    defect("the end of an arc is not at the distance of its start from the centre"_text);
    return false;
  }
  for (const Eigen::Vector3d& point : pointsAlong(*arc))
    m.viaPoints.push_back({point, m.direction});
  return true;
}

void GcodeReader::approach(GcodeWords& w) {
  if (perS_ == 0.0)
    defect("a motion before any speed (F)"_text);
  plan::ProgramApproach start{.file = out_.file, .line = out_.line};
  if (knows('Z'))
    start.heightMm = position_.z();
  (w.any("XYZ") ? start.mmPerS : start.radPerS) =
      w.any("XYZ") ? perS_ : base::degreesToRadians(perS_);
  out_.program().approaches.push_back(start);
}

bool GcodeReader::takePosition(GcodeWords& w) {
  for (const char c : {'X', 'Y', 'Z'})
    if (w[c]) {
      const auto k = static_cast<std::size_t>(c - 'X');
      position_[static_cast<Eigen::Index>(k)] = *w[c];
      known_[k] = true;
    }
  return known_[0] && known_[1] && known_[2];
}

} // namespace voluta::program
