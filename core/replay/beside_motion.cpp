#include "replay/beside_motion.h"

#include "base/units.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "process/bead_model.h"
#include "program/extruder.h"
#include "replay/approach.h"
#include "replay/start_lock.h"
#include "robot/tool_changer.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

std::size_t firstBeadOf(const plan::ReadProgram& program) {
  const auto& motions = program.motions;
  const auto begin =
      motions.begin() + static_cast<std::ptrdiff_t>(std::min(program.firstMotion, motions.size()));
  return static_cast<std::size_t>(
      std::find_if(begin, motions.end(), [](const plan::ProgramMotion& m) { return m.extruding; }) -
      motions.begin());
}

namespace {

using enum plan::FindingKind;

constexpr double kMinMm3 = 0.005, kPrimeTolerance = 0.1;
// Tolerated sum of unplanned pauses [s]; and per pause the relative and absolute rounding error.
constexpr double kMaxPausesS = 0.1, kPauseShare = 0.05, kPauseS = 1e-3;
constexpr std::size_t kMaxPauses = 100; // maximum number of findings
constexpr double kPlateKg = 0.5, kHeadKg = 1.0, kLoadFactor = 3.0, kLoadSlackKg = 1.0,
                 kLoadCentreMm = 50.0;
constexpr double kFirstRadPerS2 = 2.0;
constexpr double kFlowSlack = 1.05; // as for motions
constexpr double kNozzleMm = 0.05, kNozzleRad = 0.01;
constexpr double kHarder = 1.5;
// Writers may let the speed change within half of the motion.
constexpr double kHalf = 2.0;

class Judge {
public:
  Judge(const plan::ReadProgram& program, const ExecutedPath& path, const plan::ToolPlan& plan,
        const plan::Trajectory& trajectory, const robot::Cell& cell,
        const process::Tooling& tooling, std::size_t firstPoint, const PlannedStops& planned)
      : program_(program), path_(path), plan_(plan), trajectory_(trajectory), cell_(cell),
        tooling_(tooling), firstPoint_(firstPoint), firstBead_(firstBeadOf(program)),
        planned_(planned) {}

  std::vector<TextFinding> judge() {
    pauses();
    flows();
    waits();
    prime();
    load();
    nozzle();
    firstMotion();
    for (std::size_t m = 1; m < program_.motions.size(); ++m)
      acceleration(m);
    return std::move(found_);
  }

private:
  void add(plan::FindingKind kind, TextPlace place, std::vector<plan::NamedValue> values) {
    found_.push_back(textFinding(program_, kind, place, std::move(values)));
  }
  static TextPlace placeOfPause(const plan::ProgramPause& p) { return {p.file + 1, p.line}; }

  void pauses() {
    for (const plan::ProgramPause& p : program_.pauses) {
      if (p.before <= firstBead_ || p.before > program_.motions.size())
        continue;
      if (p.volumeMm3 > kMinMm3 && planned_.purgeAt(p.before) <= 0.0)
        add(FlowsWhileStanding, placeOfPause(p),
            {{"volume", base::mm3(p.volumeMm3)}, {"time", base::seconds(p.durationS)}});
    }
  }

  // Material that flows out at rest: a prime, a purge, a shot.
  void flows() {
    for (const plan::ProgramPause& p : program_.pauses) {
      const double maximum = process::flowLimit(tooling_.at(p.tool).process);
      if (p.volumeMm3 <= kMinMm3 || p.volumeMm3 <= kFlowSlack * maximum * p.durationS)
        continue;
      const double flow = p.volumeMm3 / std::max(p.durationS, kPauseS);
      add(plan::FindingKind::Flow, placeOfPause(p),
          {{"flow", base::Quantity{flow, base::Unit::Mm3PerS}},
           {"limit", base::Quantity{maximum, base::Unit::Mm3PerS}}});
    }
  }

  // A hot nozzle drips while it dwells.
  void waits() {
    std::vector<const plan::ProgramPause*> unplanned;
    double seconds = 0.0;
    for (const plan::ProgramPause& p : program_.pauses) {
      const bool duringPrint =
          p.before > program_.firstMotion && p.before < program_.motions.size();
      const double over = p.durationS - (1.0 + kPauseShare) * plannedPauseS(p);
      if (!duringPrint || p.cuts || p.volumeMm3 > kMinMm3 || over <= kPauseS ||
          waitsBefore(p.before))
        continue;
      unplanned.push_back(&p);
      seconds += over;
    }
    if (seconds <= kMaxPausesS)
      return;
    unplanned.resize(std::min(unplanned.size(), kMaxPauses));
    for (const plan::ProgramPause* p : unplanned)
      add(StandsDuringPrint, placeOfPause(*p), {{"time", base::seconds(p->durationS)}});
  }
  bool waitsBefore(std::size_t motion) const { return planned_.secondsAt(motion) > 0.0; }
  // Planned duration of a pause without flow.
  double plannedPauseS(const plan::ProgramPause& p) const {
    return std::min(p.drawnMm, tooling_.at(p.tool).process.retractMm) / program::kDrawBackMmPerS +
           lockS(p);
  }

  double lockS(const plan::ProgramPause& p) const {
    return robot::hasChanger(cell_)
               ? fileLockS(program_, static_cast<std::size_t>(&p - program_.pauses.data()))
               : 0.0;
  }

  void prime() {
    const double planned = plannedPrimeMm3(
        plan_, trajectory_, tooling_.at(trajectory_.toolAt(firstPoint_)).process, firstPoint_);
    if (!program_.tellsPauses || program_.motions.empty())
      return;
    double volume = 0.0;
    const plan::ProgramPause* maximum = nullptr;
    for (const plan::ProgramPause& p : program_.pauses) {
      if (p.before > firstBead_ || planned_.purgeAt(p.before) > 0.0)
        continue;
      volume += p.volumeMm3;
      if (!maximum || p.volumeMm3 > maximum->volumeMm3)
        maximum = &p;
    }
    if (std::abs(volume - planned) <= std::max(kMinMm3, kPrimeTolerance * planned))
      return;
    // Programs prime where the arm is at the program's start.
    const std::size_t motion =
        std::min({program_.firstMotion + 1, firstBead_, program_.motions.size() - 1});
    add(PrimeChanged, maximum ? placeOfPause(*maximum) : placeOf(program_, motion),
        {{"volume", base::mm3(volume)}, {"planned", base::mm3(planned)}});
  }

  // Without it: stated_facts.h.
  void load() {
    if (!program_.load)
      return;
    const TextPlace place{program_.load->file + 1, program_.load->line};
    if (const auto& centre = program_.load->centreMm) {
      const Eigen::Vector3d planned = cell_.flange_T_moved().translation();
      if ((*centre - planned).norm() > kLoadCentreMm)
        add(StatementChanged, place,
            {{"statement", base::Message("the payload's centre, mm"_text)},
             {"found", textOf(*centre)},
             {"planned", textOf(planned)}});
    }
    const bool head = cell_.nozzleMount() != robot::Mount::World;
    const double part = 1e-3 * tooling_.printedG(trajectory_);
    const double carried = !cell_.carriedIsAssumed() ? cell_.carriedKg()
                           : head                    ? kHeadKg
                                                     : kPlateKg;
    const double planned = carried + (head ? 0.0 : part), kg = program_.load->kg;
    if (std::abs(kg - planned) <= kLoadSlackKg ||
        (kg <= kLoadFactor * planned && planned <= kLoadFactor * kg))
      return;
    add(LoadChanged, place, {{"mass", base::number(kg)}, {"planned", base::number(planned)}});
  }

  static base::Message textOf(const Eigen::Vector3d& mm) {
    return base::message("{x:.1f}, {y:.1f}, {z:.1f}"_text, base::number(mm.x()),
                         base::number(mm.y()), base::number(mm.z()));
  }

  // The arm's targets do not depend on the stated nozzle pose, but speeds and straight paths do.
  void nozzle() {
    if (!program_.base_T_nozzle || cell_.nozzleMount() != robot::Mount::World)
      return;
    const Eigen::Isometry3d away = cell_.base_T_fixed().inverse() * *program_.base_T_nozzle;
    const double mm = away.translation().norm(),
                 rad = std::acos(std::clamp(away.linear()(2, 2), -1.0, 1.0));
    if (mm > kNozzleMm || rad > kNozzleRad)
      add(NozzleElsewhere, {program_.nozzleAt.file + 1, program_.nozzleAt.line},
          {{"distance", base::mm(mm)}, {"angle", base::degrees(base::radiansToDegrees(rad))}});
  }

  void firstMotion() {
    const std::size_t first = program_.firstMotion;
    if (first >= program_.motions.size())
      return;
    const plan::ProgramMotion& m = program_.motions[first];
    // Machines without an arm travel so from home.
    const double maximum = m.target == plan::TargetKind::ToolPoint
                               ? firstMmPerS(tooling_.at(m.tool).process)
                               : kFirstMmPerS;
    if (m.jointSpeedRadPerS > kFirstRadPerS || m.jointAccelerationRadPerS2 > kFirstRadPerS2 ||
        m.speedMmPerS > maximum)
      add(FirstMotionFast, placeOf(program_, first), {});
  }

  void acceleration(std::size_t i) {
    const plan::ProgramMotion& m = program_.motions[i];
    double allowed = 0.0;
    const double asked = m.jointInterpolated ? m.jointAccelerationRadPerS2 : m.accelerationMmPerS2;
    if (m.jointInterpolated) {
      allowed = INFINITY;
      for (const robot::JointLimits& limit : cell_.limits())
        allowed = std::min(allowed, robot::asAngle(limit.kind, limit.acceleration));
    } else {
      const double time = path_.durationS[i], before = path_.durationS[i - 1];
      const double speed = time > 0.0 ? path_.commandedMm[i] / time : 0.0;
      const bool straight = !program_.motions[i - 1].jointInterpolated;
      const double last = straight && before > 0.0 ? path_.commandedMm[i - 1] / before : 0.0;
      allowed = tooling_.at(m.tool).process.accelerationMmPerS2;
      if (time > 0.0)
        allowed = std::max(
            {allowed, kHalf * std::abs(speed - last) / time, kHalf * std::abs(speed) / time});
    }
    if (asked > kHarder * allowed)
      add(AccelerationChanged, placeOf(program_, i), {{"times", base::number(asked / allowed)}});
  }

  const plan::ReadProgram& program_;
  const ExecutedPath& path_;
  const plan::ToolPlan& plan_;
  const plan::Trajectory& trajectory_;
  const robot::Cell& cell_;
  const process::Tooling& tooling_;
  std::size_t firstPoint_;
  std::size_t firstBead_;
  const PlannedStops& planned_;
  std::vector<TextFinding> found_;
};

} // namespace

double plannedPrimeMm3(const plan::ToolPlan& plan, const plan::Trajectory& trajectory,
                       const process::Process& process, std::size_t firstPoint) {
  if (!plan::primesAtStart(plan, trajectory, firstPoint))
    return 0.0;
  const double flow =
      process::beadArea(process.beadWidthMm, process.layerHeightMm) * process.speedMmPerS;
  return std::min(process::flowLimit(process), flow) * process.primeS;
}

double standingMm3(const plan::ReadProgram& program, const PlannedStops& planned) {
  const std::size_t firstBead = firstBeadOf(program);
  double volume = 0.0;
  for (const plan::ProgramPause& p : program.pauses)
    if (p.before > firstBead && planned.purgeAt(p.before) <= 0.0)
      volume += p.volumeMm3;
  return volume;
}

std::vector<TextFinding> judgeBesideMotion(const plan::ReadProgram& program,
                                           const ExecutedPath& path, const plan::ToolPlan& plan,
                                           const plan::Trajectory& trajectory,
                                           const robot::Cell& cell, const process::Tooling& tooling,
                                           std::size_t firstPoint, const PlannedStops& planned) {
  return Judge(program, path, plan, trajectory, cell, tooling, firstPoint, planned).judge();
}

} // namespace voluta::replay
