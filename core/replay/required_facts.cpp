#include "replay/required_facts.h"

#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/filament.h"
#include "program/full_flow.h"
#include "replay/beside_motion.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::FactKind, plan::StatedFact;

constexpr double kSameFlow = 1e-3;     // relative
constexpr double kRoundedFlow = 5e-4;  // mm³/s: extruder heads write three decimals
constexpr std::size_t kMaxFlags = 100; // findings

base::Message nameOf(FactKind kind) {
  switch (kind) {
  case FactKind::OperatorStop:
    return "a stop until the operator continues"_text;
  case FactKind::Home:
    return "the reference run"_text;
  case FactKind::Millimetres:
    return "millimetres as the unit of length"_text;
  case FactKind::AbsolutePositions:
    return "absolute positions"_text;
  case FactKind::FilamentCount:
    return "the counting mode of the filament"_text;
  case FactKind::Payload:
    return "the payload"_text;
  case FactKind::FullFlow:
    return "the full flow"_text;
  case FactKind::FlowOutputRange:
    return "the range of the flow output"_text;
  case FactKind::TargetFrame:
    return "the frame of the targets"_text;
  case FactKind::MechanicalUnit:
    return "the mechanical unit"_text;
  case FactKind::OpenRounding:
    return "the rounding distances of corners"_text;
  case FactKind::FullPower:
    return "the motors' power for the first motion"_text;
  case FactKind::ToolSelected: // events: planned_events.h
  case FactKind::OwnStatement:
  case FactKind::ToolLocked:
  case FactKind::TapeCut:
  case FactKind::MarkSet:
  case FactKind::MarkAwaited:
  case FactKind::PassingOutput:
  case FactKind::NozzleHeat: // heat_facts.h
  case FactKind::NozzleHeatWait:
  case FactKind::BedHeat:
  case FactKind::BedHeatWait:
  case FactKind::FanSpeed:
  case FactKind::BeadStartWord: // bead_words.h
  case FactKind::BeadEndWord:
  case FactKind::Spindle: // milling/cut_verdict.h
  case FactKind::BlockTurned:
    break;
  }
  return "a trigger for the output"_text;
}

class Comparer {
public:
  Comparer(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
           const Alignment& alignment, const robot::Cell& cell, const process::Tooling& tooling)
      : program_(program), trajectory_(trajectory), alignment_(alignment), cell_(cell),
        fullFlowMm3PerS_(tooling.fullFlowMm3PerS()) {
    const auto flows = std::ranges::find_if(
        program.pauses, [](const plan::ProgramPause& p) { return p.volumeMm3 > 0.0; });
    firstFlow_ = static_cast<std::size_t>(flows - program.pauses.begin());
    firstBead_ = firstBeadOf(program);
  }

  std::vector<TextFinding> compare() {
    if (program_.firstMotion < program_.motions.size())
      for (const FactKind kind : program_.neededFacts)
        needed(kind);
    for (const StatedFact& fact : program_.facts)
      stated(fact);
    power();
    postures();
    return std::move(found_);
  }

private:
  void add(plan::FindingKind kind, TextPlace place, std::vector<plan::NamedValue> values) {
    found_.push_back(textFinding(program_, kind, place, std::move(values)));
  }
  static TextPlace placeOfFact(const StatedFact& fact) { return {fact.file + 1U, fact.line}; }
  void missing(FactKind kind, TextPlace place) {
    add(StatementMissing, place, {{"statement", nameOf(kind)}});
  }
  void changed(FactKind kind, TextPlace place, base::Value found, base::Value planned) {
    add(StatementChanged, place,
        {{"statement", nameOf(kind)},
         {"found", std::move(found)},
         {"planned", std::move(planned)}});
  }

  bool isBeforeMotion(const StatedFact& fact) const { return fact.before <= program_.firstMotion; }
  bool isBeforeFlow(const StatedFact& fact) const {
    return fact.before <= firstBead_ && fact.beforePause <= firstFlow_;
  }
  template <typename Fits> const StatedFact* first(FactKind kind, const Fits& fits) const {
    const auto fact = std::ranges::find_if(
        program_.facts, [&](const StatedFact& f) { return f.kind == kind && fits(f); });
    return fact == program_.facts.end() ? nullptr : &*fact;
  }

  void needed(FactKind kind) {
    const TextPlace firstMotion = placeOf(program_, program_.firstMotion);
    switch (kind) {
    case FactKind::OperatorStop:
      operatorStop(firstMotion);
      break;
    case FactKind::NozzleHeat: // heat_facts.h
    case FactKind::NozzleHeatWait:
    case FactKind::BedHeat:
    case FactKind::BedHeatWait:
      break;
    default:
      // Of the reference run: of all axes.
      if (!first(kind, [&](const StatedFact& f) {
            return isBeforeMotion(f) && isBeforeFlow(f) &&
                   (kind != FactKind::Home || f.number > 0.0);
          }))
        missing(kind, firstMotion);
    }
  }

  // The stop must come before the machine moves at all.
  void operatorStop(TextPlace firstMotion) {
    const StatedFact* home = first(FactKind::Home, [](const StatedFact&) { return true; });
    const auto inTime = [&](const StatedFact& f) {
      return isBeforeMotion(f) && (!home || &f < home);
    };
    if (first(FactKind::OperatorStop,
              [&](const StatedFact& f) { return inTime(f) && f.number > 0.0; }))
      return;
    if (const StatedFact* passing = first(FactKind::OperatorStop, inTime))
      changed(FactKind::OperatorStop, placeOfFact(*passing),
              "a stop that ends by itself or is skipped"_text,
              "a stop that the operator ends"_text);
    else
      missing(FactKind::OperatorStop,
              home && isBeforeMotion(*home) ? placeOfFact(*home) : firstMotion);
  }

  void stated(const StatedFact& fact) {
    const TextPlace place = placeOfFact(fact);
    switch (fact.kind) {
    case FactKind::FullFlow:
      fullFlow(fact);
      break;
    case FactKind::FlowOutputRange:
      if (fact.word != program::k0To10V)
        changed(fact.kind, place, fact.word, program::k0To10V);
      break;
    case FactKind::MechanicalUnit:
      unit(fact);
      break;
    case FactKind::OpenRounding:
      changed(fact.kind, place, "left to the controller"_text, "stated"_text);
      break;
    case FactKind::PassingOutput:
      add(OutputPasses, place, {});
      break;
    default:
      break;
    }
  }

  // The arm's position is unknown then.
  void power() {
    const StatedFact* last = nullptr;
    for (const StatedFact& fact : program_.facts)
      if (fact.kind == FactKind::FullPower && isBeforeMotion(fact))
        last = &fact;
    if (last && last->number > 0.0)
      changed(last->kind, placeOfFact(*last), "full"_text, "low"_text);
  }

  void fullFlow(const StatedFact& fact) {
    const std::string_view atFull = program::findDialect(program_.format).fullFlowAt;
    if (atFull.empty()) // no output carries the flow
      return;
    const double planned = fullFlowMm3PerS_;
    if (fact.word != atFull)
      changed(fact.kind, placeOfFact(fact), fact.word, atFull);
    else if (!(std::abs(fact.number - planned) <= kSameFlow * planned + kRoundedFlow))
      changed(fact.kind, placeOfFact(fact), base::Quantity{fact.number, base::Unit::Mm3PerS},
              base::Quantity{planned, base::Unit::Mm3PerS});
  }

  void unit(const StatedFact& fact) {
    const auto units = program::findDialect(program_.format).units;
    if (!units)
      return;
    const std::vector<std::string> known = units(cell_);
    if (std::ranges::find(known, fact.word) == known.end())
      changed(fact.kind, placeOfFact(fact), fact.word, known.empty() ? "-" : known.back());
  }

  void postures() {
    if (program_.postures.empty())
      return;
    const program::Dialect& dialect = program::findDialect(program_.format);
    if (!dialect.posture)
      return;
    const bool foreign = program::isForeign(dialect, cell_);
    std::size_t reported = 0;
    const auto text = [](const plan::ArmPosture& p) {
      return "(" + std::to_string(p.structure) + "," + std::to_string(p.turns) + ")";
    };
    for (const plan::StatedPosture& stated : program_.postures) {
      const std::size_t point = alignment_.pointOf[stated.motion];
      if (point == kUnmatched || reported == kMaxFlags)
        continue;
      const plan::ArmPosture planned = dialect.posture(cell_, foreign, trajectory_.at(point));
      if (planned == stated.posture)
        continue;
      ++reported;
      add(PostureChanged, placeOf(program_, stated.motion),
          {{"found", text(stated.posture)}, {"planned", text(planned)}});
    }
  }

  const plan::ReadProgram& program_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  const robot::Cell& cell_;
  const double fullFlowMm3PerS_;
  // pause in which material flows first; first extruding motion
  std::size_t firstFlow_ = 0, firstBead_ = 0;
  std::vector<TextFinding> found_;
};

} // namespace

std::vector<TextFinding> compareStatedFacts(const plan::ReadProgram& program,
                                            const plan::Trajectory& trajectory,
                                            const Alignment& alignment, const robot::Cell& cell,
                                            const process::Tooling& tooling) {
  return Comparer(program, trajectory, alignment, cell, tooling).compare();
}

} // namespace voluta::replay
