#include "replay/heat_facts.h"

#include "plan/finding_kinds.h"
#include "plan/fitted_tools.h"
#include "process/cooling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::FactKind, plan::StatedFact;

bool needs(const plan::ReadProgram& program, FactKind kind) {
  return std::ranges::find(program.neededFacts, kind) != program.neededFacts.end();
}

// A nozzle or the bed.
struct Heater {
  FactKind heat, wait;
  int tool = 0; // of nozzles
  double usualC = 0.0, toleranceC = 0.0;
  base::Message name, waitName, offName;
  bool isFittedLater = false;

  bool isNozzle() const { return heat == FactKind::NozzleHeat; }
};

// `plateTool` decides the plate's temperature: the first tool of the whole job, of a rest too.
std::vector<Heater> heatersOf(const process::Tooling& tooling, const std::vector<int>& used,
                              int plateTool) {
  std::vector<Heater> heaters;
  for (const int t : used)
    if (const process::Material& m = tooling.at(t).process.material; m.nozzleC)
      heaters.push_back({FactKind::NozzleHeat, FactKind::NozzleHeatWait, t,
                         static_cast<double>(*m.nozzleC), kNozzleToleranceC,
                         "the nozzle temperature, °C"_text, "a wait until the nozzle is hot"_text,
                         "turning off the nozzle's heating"_text});
  if (const double bed = tooling.at(plateTool).process.material.bedC.value_or(0); bed > 0.0)
    heaters.push_back({FactKind::BedHeat, FactKind::BedHeatWait, 0, bed, kBedToleranceC,
                       "the bed temperature, °C"_text, "a wait until the bed is hot"_text,
                       "turning off the bed's heating"_text});
  return heaters;
}

// Follows one heater through the program's statements.
class HeaterComparer {
public:
  HeaterComparer(const plan::ReadProgram& program, Heater heater, std::vector<TextFinding>& found)
      : program_(program), heater_(std::move(heater)), found_(found), motion_(program.firstMotion),
        isWaitNeeded_(needs(program, heater_.wait)) {}

  void compare() {
    for (const StatedFact& fact : program_.facts)
      if ((fact.kind == heater_.heat || fact.kind == heater_.wait) &&
          (!heater_.isNozzle() || fact.tool == heater_.tool)) {
        extrudeUntil(fact.before, fact.beforePause);
        take(fact);
      }
    extrudeUntil(program_.motions.size(), program_.pauses.size());
    if (celsius_ > 0.0 && program_.complete)
      found_.push_back(textFinding(program_, StatementMissing,
                                   placeOf(program_, program_.motions.size() - 1),
                                   {{"statement", heater_.offName}}));
  }

private:
  bool isHot() const { return isOn_ && (isWaited_ || !isWaitNeeded_); }

  void take(const StatedFact& fact) {
    if (fact.kind == heater_.wait) {
      isWaited_ = isOn_;
      return;
    }
    celsius_ = fact.number;
    isOn_ = fact.number > 0.0 && std::abs(fact.number - heater_.usualC) <= heater_.toleranceC;
    isWaited_ = isWaited_ && isOn_;
    if (isOn_)
      off_ = nullptr;
    else
      off_ = &fact;
  }

  bool isOf(int tool) const { return !heater_.isNozzle() || tool == heater_.tool; }
  // Checks what is extruded up to that motion and that pause.
  void extrudeUntil(std::size_t motion, std::size_t pause) {
    std::optional<std::size_t> used; // motion
    for (; pause_ < pause; ++pause_)
      if (const plan::ProgramPause& p = program_.pauses[pause_];
          !used && p.volumeMm3 > 0.0 && p.before >= program_.firstMotion && isOf(p.tool))
        used = std::min(p.before, program_.motions.size() - 1);
    for (; motion_ < motion; ++motion_)
      if (const plan::ProgramMotion& m = program_.motions[motion_];
          !used && m.extruding && isOf(m.tool))
        used = motion_;
    if (used && !isHot() && !isReported_)
      report(*used);
    isReported_ = isReported_ && !isHot();
  }

  void report(std::size_t motion) {
    isReported_ = true;
    if (off_) {
      found_.push_back(textFinding(program_, StatementChanged, {off_->file + 1U, off_->line},
                                   {{"statement", heater_.name},
                                    {"found", base::number(off_->number)},
                                    {"planned", base::number(heater_.usualC)}}));
      return;
    }
    // Nothing is hot when the program begins: the statement belongs before its first motion, or
    // into the change in which the tool is fitted.
    const std::size_t at = isFirst_ && !heater_.isFittedLater ? program_.firstMotion : motion;
    found_.push_back(textFinding(program_, StatementMissing, placeOf(program_, at),
                                 {{"statement", isOn_ ? heater_.waitName : heater_.name}}));
    isFirst_ = false;
  }

  const plan::ReadProgram& program_;
  const Heater heater_;
  std::vector<TextFinding>& found_;
  std::size_t motion_ = 0, pause_ = 0;
  const bool isWaitNeeded_;
  bool isOn_ = false, isWaited_ = false, isReported_ = false, isFirst_ = true;
  double celsius_ = 0.0;            // commanded last
  const StatedFact* off_ = nullptr; // that turned it off
};

} // namespace

std::vector<TextFinding> compareHeat(const plan::ReadProgram& program,
                                     const plan::Trajectory& trajectory,
                                     const process::Tooling& tooling, std::size_t firstPoint) {
  std::vector<TextFinding> found;
  if (program.firstMotion >= program.motions.size())
    return found;
  for (Heater& heater : heatersOf(tooling, tooling.usedAfter(trajectory, firstPoint),
                                  tooling.usedAfter(trajectory, 0).front()))
    if (needs(program, heater.heat)) {
      heater.isFittedLater = heater.isNozzle() && heater.tool != trajectory.toolAt(firstPoint) &&
                             plan::isFittedByHand(trajectory, heater.tool);
      HeaterComparer(program, std::move(heater), found).compare();
    }
  return found;
}

std::vector<TextFinding> compareFan(const plan::ReadProgram& program, const plan::ToolPlan& plan,
                                    const plan::Trajectory& trajectory, const Alignment& alignment,
                                    const process::Tooling& tooling) {
  std::vector<TextFinding> found;
  if (!needs(program, FactKind::NozzleHeat))
    return found;
  double fan = 0.0;
  std::size_t fact = 0, path = 0;
  double reportedFan = -1.0, reportedPlanned = -1.0; // -1: nothing is reported here
  for (std::size_t m = program.firstMotion;
       m < program.motions.size() && found.size() < kMaxFanFindings; ++m) {
    for (; fact < program.facts.size() && program.facts[fact].before <= m; ++fact)
      if (program.facts[fact].kind == FactKind::FanSpeed)
        fan = program.facts[fact].number;
    const std::size_t point = alignment.pointOf[m];
    if (!program.motions[m].extruding || point == kUnmatched ||
        trajectory.waypoint[point] == plan::kNoWaypoint)
      continue;
    while (path + 1 < plan.paths.size() && plan.paths[path + 1].first <= trajectory.waypoint[point])
      ++path;
    const double planned =
        process::fanShare(tooling.of(plan.paths[path]).process.material, plan.paths[path]);
    const bool isSame = std::abs(fan - planned) < process::kSameFan;
    if (!isSame && (fan != reportedFan || planned != reportedPlanned))
      found.push_back(textFinding(program, FanChanged, placeOf(program, m),
                                  {{"found", base::number(std::round(100.0 * fan))},
                                   {"planned", base::number(std::round(100.0 * planned))}}));
    reportedFan = isSame ? -1.0 : fan;
    reportedPlanned = isSame ? -1.0 : planned;
  }
  return found;
}

} // namespace voluta::replay
