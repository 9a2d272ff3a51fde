#include "program/program_builder.h"

#include "plan/marks.h"
#include "program/common/tape_cut.h"
#include "program/filament.h"
#include "program/gcode/castelli_serial.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace voluta::program {

ProgramBuilder::ProgramBuilder(std::string_view format, process::Tooling tooling)
    : tooling_(std::move(tooling)), defects_(program_.defects), places_(defects_) {
  program_.format = format;
}

void ProgramBuilder::expectMotionsOf(const std::vector<plan::ProgramFile>& files) {
  // minimum length of a line with a motion; shorter ones have none
  constexpr std::size_t kMinBytes = 16;
  std::size_t upperBound = 0;
  for (const plan::ProgramFile& one : files)
    upperBound += std::min(static_cast<std::size_t>(std::ranges::count(one.text, '\n')) + 1,
                           one.text.size() / kMinBytes + 1);
  program_.motions.reserve(upperBound);
}

void ProgramBuilder::beginOutputs() {
  outputs_.begin();
  places_.begin();
  program_.tellsPauses = true;
}

bool ProgramBuilder::tool(const Eigen::Isometry3d& flange_T_tcp,
                          const std::optional<Eigen::Isometry3d>& base_T_nozzle) {
  constexpr double kSame = 1e-9;
  const std::optional<Eigen::Isometry3d>& before = program_.base_T_nozzle;
  if (toolSet_ && (!flange_T_tcp.isApprox(program_.flange_T_tcp, kSame) ||
                   base_T_nozzle.has_value() != before.has_value() ||
                   (before && !base_T_nozzle->isApprox(*before, kSame))))
    return false;
  if (base_T_nozzle && !before)
    program_.nozzleAt = {file, line};
  toolSet_ = true;
  program_.flange_T_tcp = flange_T_tcp;
  program_.base_T_nozzle = base_T_nozzle;
  return true;
}

void ProgramBuilder::setExtruder(bool on) {
  const std::size_t happened = program_.motions.size() + program_.pauses.size();
  // Switched on and off with nothing in between: a prime whose wait is missing.
  if (outputs_.on() && !on && happened == onSince_)
    pause(0.0, 0.0);
  if (on && !outputs_.on())
    onSince_ = happened;
  outputs_.setExtruder(on);
}

void ProgramBuilder::send(std::string_view text, std::string_view to) {
  need(plan::FactKind::NozzleHeat);
  if (!sentTo_)
    sentTo_ = to;
  else if (*sentTo_ != to)
    defect("this text does not go to the extruder as those before it"_text);
  const auto command = readCastelli(text);
  if (!command) {
    defect(base::message("'{text}' is not an extruder command"_text, text.substr(0, 40)));
    return;
  }
  const double value = static_cast<double>(command->value);
  switch (command->word) {
  case 'G':
    setExtruder(command->value > 0);
    flow(std::max(0.0, castelliFlowMm3PerS(command->value)) / tooling_.fullFlowMm3PerS());
    drawsMm3PerS_ = std::max(0.0, -castelliFlowMm3PerS(command->value));
    return;
  case 'M':
    if (value != 0.0 && !prints(material(), value))
      defect(base::message("{celsius} °C is outside the printing range of {material}"_text,
                           base::number(value), material().label));
    state(plan::FactKind::NozzleHeat, value);
    wordAt("M", kOutsidePrint);
    return;
  case 'R':
    wordAt("R", kSetUp);
    return;
  case 'F':
    state(plan::FactKind::FanSpeed, std::min(1.0, value / kCastelliFullFan));
    wordAt(text, kAnywhere);
    return;
  default: // queries
    wordAt(text, kAnywhere);
  }
}

void ProgramBuilder::motionByOutputs(plan::ProgramMotion m) {
  if (!outputs_.moveWith(m, tooling_.fullFlowMm3PerS()))
    defect("the extruder's outputs are not set before this motion"_text);
  if (drawsMm3PerS_ > 0.0)
    defect("the extruder reverses while the nozzle moves"_text);
  if (m.extruding && std::exchange(drawnMm3_, 0.0) > kDrawnBackLeftMm3)
    defect("the retracted filament is not returned before the bead"_text);
  motion(std::move(m));
}

void ProgramBuilder::motion(plan::ProgramMotion m) {
  settleTool();
  reportCutterOut();
  const std::optional<Statement> speed = std::exchange(jointSpeed_, std::nullopt);
  if (speed && !m.jointInterpolated && !program_.motions.empty())
    defects_.add(
        speed->file, speed->line,
        base::message("'{word}' is not followed by a joint motion: it changes the speed of "
                      "a later travel"_text,
                      speed->word));
  m.file = static_cast<std::uint32_t>(file);
  m.line = static_cast<std::uint32_t>(line);
  m.tool = static_cast<std::uint8_t>(selected_);
  places_.motion();
  shown_.clear();
  if (m.extruding)
    places_.material();
  program_.motions.push_back(std::move(m));
}

void ProgramBuilder::pauseByOutputs(double seconds) {
  const double pushed =
      (outputs_.flowShare() * tooling_.fullFlowMm3PerS() - drawsMm3PerS_) * seconds;
  const double before = drawnMm3_;
  double out = 0.0;
  std::tie(out, drawnMm3_) = pushedOut(pushed, drawnMm3_);
  reportDrawn(drawnMm3_ / filamentArea(kCastelliFilamentMm));
  pause(seconds, out, std::abs(drawnMm3_ - before) / filamentArea(kCastelliFilamentMm));
}

void ProgramBuilder::reportDrawn(double mm) {
  if (mm > kMaxDrawnBackMm)
    defect(
        base::message("{length:.0f} of filament retracted: out of the hot end"_text, base::mm(mm)));
}

void ProgramBuilder::zeroAxis() {
  axis_.set(0.0);
  axisZeroed_ = true;
}

void ProgramBuilder::motionByAxis(plan::ProgramMotion m, double mm) {
  if (!std::exchange(axisZeroed_, true))
    defect("the extruder's axis is not set to 0 before this motion"_text);
  const double before = axis_.mm(), drawnMm = axis_.drawnBackMm();
  const double outMm = axis_.to(mm);
  if (mm < before)
    defect("the extruder reverses while the nozzle moves"_text);
  if (mm > before && drawnMm * filamentArea() > kDrawnBackLeftMm3)
    defect("the retracted filament is not returned before the bead"_text);
  m.volumeMm3 = outMm * filamentArea();
  m.extruding = outMm > 0.0;
  motion(std::move(m));
}

void ProgramBuilder::pauseByAxis(double seconds, double mm) {
  const double before = axis_.drawnBackMm(), outMm = axis_.to(mm);
  reportDrawn(axis_.drawnBackMm());
  pause(seconds, outMm * filamentArea(), std::abs(axis_.drawnBackMm() - before));
}

void ProgramBuilder::pause(double seconds, double volumeMm3, double drawnMm) {
  settleTool();
  if (volumeMm3 > 0.0)
    places_.material();
  program_.pauses.push_back(
      {file, line, program_.motions.size(), seconds, volumeMm3, drawnMm, selected_});
}

void ProgramBuilder::need(plan::FactKind kind) {
  std::vector<plan::FactKind>& needed = program_.neededFacts;
  if (std::ranges::find(needed, kind) == needed.end())
    needed.push_back(kind);
}

void ProgramBuilder::state(plan::FactKind kind, double number, std::string_view word) {
  settleTool();
  program_.facts.push_back({kind, static_cast<std::uint32_t>(file),
                            static_cast<std::uint32_t>(line), program_.motions.size(),
                            program_.pauses.size(), number, std::string(word), selected_});
}

void ProgramBuilder::stateOf(int tool, plan::FactKind kind, double number) {
  state(kind, number);
  program_.facts.back().tool = tool;
}

void ProgramBuilder::operatorStop(bool waits) {
  state(plan::FactKind::OperatorStop, waits ? 1.0 : 0.0, shown_);
  shown_.clear();
}

void ProgramBuilder::selectTool(int tool) {
  if (tool < 0 || static_cast<std::size_t>(tool) >= tooling_.tools().size()) {
    defect("a tool other than the printing one"_text);
    return;
  }
  selected_ = tool;
  state(plan::FactKind::ToolSelected);
}

namespace {
bool isMark(int signal) {
  return signal >= kMarkOutput && signal < kMarkOutput + plan::kMarkSignals;
}
} // namespace

bool ProgramBuilder::toolOutput(int tool, bool on) {
  // In a job of one tool the cell may have no changer: then it is another output.
  if (tool == kChangerOutput) {
    state(plan::FactKind::ToolLocked, on ? 1.0 : 0.0);
    return on || toolOutputs_.size() > 1;
  }
  if (isMark(tool)) {
    statePassingOutput();
    state(plan::FactKind::MarkSet, plan::markCode(tool - kMarkOutput, on));
    return true;
  }
  if (tool < 1 || static_cast<std::size_t>(tool) >= toolOutputs_.size())
    return false;
  const std::optional<bool> before =
      std::exchange(toolOutputs_[static_cast<std::size_t>(tool)], on);
  if (before != on || !outputLine_)
    outputLine_ = line;
  return true;
}

bool ProgramBuilder::awaitInput(int input, bool on) {
  if (!isMark(input))
    return false;
  state(plan::FactKind::MarkAwaited, plan::markCode(input - kMarkOutput, on));
  return true;
}

void ProgramBuilder::setCutter(bool on) {
  if (on) {
    if (cutterOut_)
      defect("the tape's cutter is out already"_text);
    state(plan::FactKind::TapeCut);
    cutterOut_ = Statement{file, line, program_.pauses.size()};
    return;
  }
  if (!cutterOut_) {
    if (!program_.motions.empty())
      defect("the tape's cutter is not out"_text);
    return;
  }
  double seconds = 0.0;
  for (std::size_t p = cutterOut_->pause; p < program_.pauses.size(); ++p) {
    program_.pauses[p].cuts = true;
    seconds += program_.pauses[p].durationS;
  }
  cutterOut_.reset();
  reportCutLasts(seconds);
}

void ProgramBuilder::cutFor(double seconds) {
  state(plan::FactKind::TapeCut);
  reportCutLasts(seconds);
}

void ProgramBuilder::reportCutLasts(double seconds) {
  if (!(seconds >= kMinCutPulseS && seconds <= kMaxCutPulseS))
    defect(base::message("the tape's cutter is out for {time:.2f}: it needs {least:.1f} to "
                         "{most:.1f}"_text,
                         base::seconds(seconds), base::seconds(kMinCutPulseS),
                         base::seconds(kMaxCutPulseS)));
}

void ProgramBuilder::reportCutterOut() {
  if (const auto out = std::exchange(cutterOut_, std::nullopt))
    defects_.add(out->file, out->line, "the tape's cutter is not drawn back"_text);
}

void ProgramBuilder::setJointSpeed(std::string_view word) {
  jointSpeed_ = Statement{file, line, 0, std::string(word)};
}

void ProgramBuilder::settleTool() {
  if (!outputLine_)
    return;
  const std::size_t here = std::exchange(line, *std::exchange(outputLine_, std::nullopt));
  const auto on = std::ranges::count(toolOutputs_, true);
  if (std::find(toolOutputs_.begin() + 1, toolOutputs_.end(), std::nullopt) != toolOutputs_.end())
    defect("the output of a tool is not set: an earlier run may have left it on"_text);
  else if (on > 1)
    defect("the outputs of several tools are on"_text);
  else
    selectTool(
        on == 0 ? 0
                : static_cast<int>(std::ranges::find(toolOutputs_, true) - toolOutputs_.begin()));
  line = here;
}

void ProgramBuilder::statePassingOutput() {
  if (!program_.motions.empty() && program_.motions.back().blendMm > 0.0)
    state(plan::FactKind::PassingOutput);
}

bool ProgramBuilder::word(std::span<const KnownWord> table, std::string_view word) {
  const KnownWord* known = findWord(table, word);
  if (known)
    wordAt(word, known->places);
  return known != nullptr;
}

void ProgramBuilder::wordAt(std::string_view word, std::uint8_t places) {
  places_.word(word, places, file, line, outputs_.on());
}

void ProgramBuilder::load(std::string_view word, double kg,
                          const std::optional<Eigen::Vector3d>& centreMm) {
  state(plan::FactKind::Payload, kg);
  if (!program_.load)
    program_.load = {file, line, kg, std::nullopt};
  else if (program_.load->kg != kg)
    defect(base::message("'{word}' sets a different load"_text, word));
  if (centreMm)
    loadCentre(word, *centreMm);
}

void ProgramBuilder::loadCentre(std::string_view word, const Eigen::Vector3d& centreMm) {
  constexpr double kSameMm = 1e-6, kMaxMm = 1e5;
  if (!(centreMm.cwiseAbs().maxCoeff() < kMaxMm))
    defect("a payload's centre is no sensible place"_text);
  else if (program_.load && !program_.load->centreMm)
    program_.load->centreMm = centreMm;
  else if (program_.load && (*program_.load->centreMm - centreMm).norm() > kSameMm)
    defect(base::message("'{word}' sets a different load"_text, word));
}

plan::ReadProgram ProgramBuilder::take(bool complete) {
  reportCutterOut();
  program_.complete = complete;
  return std::move(program_);
}

} // namespace voluta::program
