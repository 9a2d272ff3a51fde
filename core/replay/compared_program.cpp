#include "base/error.h"
#include "base/memory.h"
#include "base/run_context.h"
#include "plan/finding_kinds.h"
#include "replay/alignment.h"
#include "replay/approach.h"
#include "replay/beads.h"
#include "replay/beside_motion.h"
#include "replay/controller_time.h"
#include "replay/executed_path.h"
#include "replay/extruder_lag.h"
#include "replay/heat_facts.h"
#include "replay/limit_findings.h"
#include "replay/planned_events.h"
#include "replay/purge_drops.h"
#include "replay/replay_steps.h"
#include "replay/required_bead_words.h"
#include "replay/required_facts.h"
#include "replay/section_errors.h"
#include "replay/start_lock.h"
#include "replay/verdict_findings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;

class TextJudge {
public:
  TextJudge(ReplayInput& in, const ReplayThresholds& limits, const base::RunContext& ctx)
      : in_(in), limits_(limits), ctx_(ctx) {}

  ComparedProgram judge() {
    check();
    execute();
    base::returnFreedMemory();
    compare();
    addMaterial();
    addTimes();
    addLimits();
    return std::move(out_);
  }

private:
  const ExecutedPath& path() const { return out_.run.path; }
  const std::vector<double>& seconds() const { return out_.verdict.motionS; }

  void check() const {
    const plan::Trajectory& t = in_.trajectory;
    const std::size_t n = t.pointCount();
    base::require(t.dof == in_.cell.dof(), "replay: the trajectory is the cell's");
    base::require(t.joints.size() == n * static_cast<std::size_t>(t.dof) && t.move.size() == n &&
                      t.waypoint.size() == n && t.extrudedMm3.size() == n,
                  "replay: the trajectory's arrays have one length");
    base::require(in_.commonPoint.empty() || in_.commonPoint.size() == n,
                  "replay: a common number a point");
    base::require(!in_.part.empty(), "replay: the part has triangles");
    base::require(in_.platform.known(), "replay: the platform is known");
  }

  // Returns the least acceleration of the arm's turning joints.
  double armRadPerS2() const {
    double minimum = std::numeric_limits<double>::infinity();
    for (const robot::JointLimits& limits : in_.cell.robot().limits)
      if (limits.kind == robot::JointKind::Turning)
        minimum = std::min(minimum, limits.acceleration);
    return std::isfinite(minimum) ? minimum : 0.0;
  }

  // Returns the distance of samples: as many per width of the narrowest bead as for 1.2 mm.
  double printSampleMm() const {
    constexpr double kTunedWidthMm = 1.2;
    double narrowest = in_.tooling.first().process.beadWidthMm;
    for (const process::Tool& tool : in_.tooling.tools())
      narrowest = std::min(narrowest, tool.process.beadWidthMm);
    return kPrintSampleMm * std::max(1.0, narrowest / kTunedWidthMm);
  }

  void execute() {
    ctx_.report(0.0, "running the program"_text);
    out_.run.path = executeProgram(in_.program, in_.cell, ctx_, printSampleMm());
    planned_ = plannedNozzle(in_.trajectory, in_.cell, ctx_);
    alignment_ = alignProgram(in_.program, path(), planned_, in_.trajectory, in_.cell, ctx_);
    followLags(in_.program, path(), in_.trajectory, alignment_, in_.tooling);
    Verification& verdict = out_.verdict;
    verdict.armChecked = path().arm;
    verdict.motionS = controllerTimes(in_.program, path(), RotationLaw::Text);
    verdict.durationS = std::accumulate(seconds().begin(), seconds().end(), 0.0);
    for (const plan::ProgramPause& p : in_.program.pauses)
      verdict.durationS += p.durationS;
    out_.run.volumeMm3.reserve(path().motionCount());
    out_.run.tool.reserve(path().motionCount());
    for (std::size_t m = 0; m < path().motionCount(); ++m) {
      out_.run.volumeMm3.push_back(motionVolume(in_.program, path(), m));
      out_.run.tool.push_back(in_.program.motions[m].tool);
    }
    setClock();
  }

  void setClock() {
    std::vector<double> pauseS(path().motionCount() + 1, 0.0);
    for (const plan::ProgramPause& p : in_.program.pauses)
      pauseS[std::min(p.before, path().motionCount())] += p.durationS;
    out_.run.firstMotion = in_.program.firstMotion;
    double now = 0.0;
    for (std::size_t m = 0; m < path().motionCount(); ++m) {
      now += pauseS[m];
      out_.run.beginS.push_back(now);
      now += seconds()[m];
      out_.run.endS.push_back(now);
    }
  }

  void addDeviations(std::vector<TextFinding> found) {
    out_.verdict.deviations += found.size();
    addFindings(out_.verdict, std::move(found));
  }

  void compare() {
    ctx_.report(0.06, "comparing with the plan"_text);
    Verification& verdict = out_.verdict;
    verdict.motionPlaces.reserve(in_.program.motions.size());
    for (std::size_t m = 0; m < in_.program.motions.size(); ++m)
      verdict.motionPlaces.push_back(placeOf(in_.program, m));
    ComparisonOptions options;
    options.armRadPerS2 = armRadPerS2();
    addDeviations(
        compareWithPlan(in_.program, path(), planned_, in_.trajectory, alignment_, options));
    addDeviations(
        compareStatedFacts(in_.program, in_.trajectory, alignment_, in_.cell, in_.tooling));
    addDeviations(compareStartLock(in_.program, in_.cell));
    addDeviations(compareHeat(in_.program, in_.trajectory, in_.tooling, in_.firstPoint));
    addFindings(verdict,
                compareFan(in_.program, in_.plan, in_.trajectory, alignment_, in_.tooling));
    addDeviations(compareEvents(in_.program, in_.trajectory, alignment_, in_.tooling, in_.cell,
                                in_.firstPoint));
    addFindings(verdict, ownStatements(in_.program, in_.trajectory, alignment_, in_.firstPoint));
    addDeviations(compareBeadWords(in_.program, in_.trajectory, alignment_, in_.tooling));
    stops_ = plannedStops(in_.program, in_.trajectory, alignment_);
    addDrops();
    addDeviations(judgeApproach(in_.program, in_.plan, in_.platform, in_.tooling));
    addDeviations(judgeBesideMotion(in_.program, path(), in_.plan, in_.trajectory, in_.cell,
                                    in_.tooling, in_.firstPoint, stops_));
    const std::optional<WholePath> whole = wholePath(in_.whole, in_.trajectory, in_.cell, ctx_);
    const struct PathDeviation deviation = pathDeviation(
        path(), planned_, in_.trajectory, in_.program, alignment_, ctx_, whole ? &*whole : nullptr);
    verdict.maxDeviationMm = deviation.mm;
    verdict.maxDeviationRad = deviation.rad;
    out_.deviationMotion = deviation.motion;
    if (deviation.mm > 0.0)
      verdict.worst.deviation = path().targetTip[deviation.motion];
    numberPoints(std::move(alignment_.pointOf));
  }

  // Material that falls on the part is a reason to refuse the program; on the plate, to look.
  void addDrops() {
    std::vector<TextFinding> refused, reported;
    for (TextFinding& drop :
         purgeDrops(in_.program, in_.trajectory, alignment_, stops_,
                    dropTargets(in_.plan, in_.platform), in_.cell, in_.firstPoint))
      (drop.finding.kind == PurgeOnPart ? refused : reported).push_back(std::move(drop));
    addDeviations(std::move(refused));
    addFindings(out_.verdict, std::move(reported));
  }

  void numberPoints(std::vector<std::size_t> pointOf) {
    Run& run = out_.run;
    run.knowledge =
        beadKnowledge(pointOf, in_.trajectory, in_.plan, in_.tooling.first().process.layerHeightMm);
    out_.verdict.pointOf = pointOf;
    run.pointOf = std::move(pointOf);
    run.commonPoint = run.pointOf;
    if (!in_.commonPoint.empty())
      for (std::size_t& point : run.commonPoint)
        point = point == kUnmatched ? kUnmatched : in_.commonPoint[point];
  }

  // Computes the material that the program deposits.
  void addMaterial() {
    Verification& verdict = out_.verdict;
    const std::vector<double> volume = flowingMm3(in_.program, seconds());
    verdict.depositedOfItemMm3.assign(in_.firstTriangle.size() > 1 ? in_.firstTriangle.size() : 0,
                                      0.0);
    for (std::size_t m = 0; m < volume.size(); ++m) {
      const BeadKnowledge& known = out_.run.knowledge[m];
      (known.ofPart ? verdict.depositedMm3
       : known.tape ? verdict.tapeMm3
                    : verdict.supportMm3) += volume[m];
      if (known.ofPart && known.item < verdict.depositedOfItemMm3.size())
        verdict.depositedOfItemMm3[known.item] += volume[m];
    }
    addShots();
    out_.standingMm3 = standingMm3(in_.program, stops_);
    verdict.depositedMm3 += out_.standingMm3;
  }

  // Adds the material that the program extrudes at rest where a pocket is to be filled.
  void addShots() {
    Run& run = out_.run;
    for (const plan::ProgramPause& p : in_.program.pauses) {
      if (p.volumeMm3 <= 0.0 || p.before == 0 || !stops_.shotAt(p.before))
        continue;
      run.shotMm3.resize(path().motionCount(), 0.0);
      run.shotMm3[p.before - 1] += p.volumeMm3;
      out_.verdict.depositedMm3 += p.volumeMm3;
      const std::size_t item = run.knowledge[p.before - 1].item;
      if (item < out_.verdict.depositedOfItemMm3.size())
        out_.verdict.depositedOfItemMm3[item] += p.volumeMm3;
    }
  }

  TextFinding atMotion(plan::FindingKind kind, std::size_t motion,
                       std::vector<plan::NamedValue> values) const {
    return findingAtMotion(out_.verdict, kind, motion, std::move(values), path().targetTip[motion],
                           path().startS[motion]);
  }

  void addTimes() {
    SectionErrors worst;
    for (const RotationLaw law : {RotationLaw::Text, RotationLaw::PathSpeed}) {
      if (law == RotationLaw::PathSpeed && in_.program.time.rotationMmPerRad <= 0.0)
        continue;
      const SectionErrors errors = sectionErrors(
          in_.program, path(), in_.trajectory, out_.run.pointOf,
          law == RotationLaw::Text ? seconds() : controllerTimes(in_.program, path(), law));
      if (errors.fraction > worst.fraction)
        worst = errors;
    }
    out_.verdict.flowErrorFraction = worst.fraction;
    if (worst.worst)
      out_.verdict.worst.flowError = path().targetTip[*worst.worst];
    if (worst.first && worst.fraction > limits_.flowErrorMax)
      out_.times.push_back(
          atMotion(FlowErrors, *worst.first, {{"share", base::percent(100.0 * worst.fraction)}}));
    for (std::size_t m = 1; m < seconds().size(); ++m)
      addSlow(m);
  }

  // A travel deposits nothing, but a very slow one is not the planned one.
  void addSlow(std::size_t m) {
    constexpr double kTimes = 2.0, kSlackS = 1.0;
    const std::vector<std::size_t>& pointOf = out_.run.pointOf;
    const std::size_t j = pointOf[m];
    if (j == 0 || j >= in_.trajectory.pointCount() || pointOf[m - 1] + 1 != j)
      return;
    const double planned = in_.trajectory.timeS[j] - in_.trajectory.timeS[j - 1];
    if (seconds()[m] <= kTimes * planned + kSlackS ||
        // already reported for the programmed speeds
        path().durationS[m] > kTimes * planned + kSlackS)
      return;
    ++out_.verdict.deviations;
    out_.times.push_back(
        atMotion(SpeedChanged, m,
                 {{"time", base::seconds(seconds()[m])}, {"planned", base::seconds(planned)}}));
  }

  // Returns the path's violations and those of the flow, in motion order.
  std::vector<LimitViolation> violations() const {
    std::vector<LimitViolation> all = path().violations;
    for (std::size_t m = 0; m < path().motionCount(); ++m) {
      const plan::ProgramMotion& motion = in_.program.motions[m];
      const double volume = out_.run.volumeMm3[m];
      const double flow = motion.volumeMm3 >= 0.0 && path().durationS[m] > 0.0
                              ? volume / path().durationS[m]
                              : (motion.extruding ? motion.flowMm3PerS : 0.0);
      const double maximum = process::flowLimit(in_.tooling.at(out_.run.tool[m]).process);
      if (flow > 1.05 * maximum)
        all.push_back({LimitKind::Flow, m, -1, flow, maximum});
    }
    std::stable_sort(all.begin(), all.end(), [](const LimitViolation& a, const LimitViolation& b) {
      return a.motion < b.motion;
    });
    return all;
  }

  void addLimits() {
    const std::vector<LimitViolation> all = violations();
    std::size_t listed = 0;
    plan::FindingKind further{};
    for (std::size_t k = 0; k < all.size(); ++k) {
      const LimitViolation& v = all[k];
      // A violation that continues over the following motions counts once.
      const bool continues = k > 0 && all[k - 1].kind == v.kind && all[k - 1].joint == v.joint &&
                             all[k - 1].motion + 1 >= v.motion;
      if (continues)
        continue;
      ++out_.verdict.limitViolations;
      if (++listed > kMaxListed + 1)
        continue;
      const plan::Finding f = limitFinding(v, in_.cell);
      if (listed <= kMaxListed)
        out_.limits.push_back(atMotion(f.kind, v.motion, f.values));
      else
        further = f.kind;
    }
    if (listed > kMaxListed)
      out_.limits.push_back(
          {plan::makeMoreFinding(further, {}, std::nullopt, listed - kMaxListed), {}});
  }

  ReplayInput& in_;
  const ReplayThresholds& limits_;
  const base::RunContext& ctx_;
  PlannedNozzle planned_;
  Alignment alignment_;
  PlannedStops stops_;
  ComparedProgram out_;
};

} // namespace

ComparedProgram compareProgram(ReplayInput& input, const ReplayThresholds& thresholds,
                               const base::RunContext& ctx) {
  ComparedProgram compared = TextJudge(input, thresholds, ctx).judge();
  base::freeStorage(input.program.motions);
  base::returnFreedMemory();
  return compared;
}

} // namespace voluta::replay
