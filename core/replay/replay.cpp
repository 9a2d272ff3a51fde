#include "base/error.h"
#include "base/memory.h"
#include "base/run_context.h"
#include "base/units.h"
#include "plan/finding_kinds.h"
#include "replay/alignment.h"
#include "replay/beads.h"
#include "replay/beside_motion.h"
#include "replay/comparison.h"
#include "replay/controller_time.h"
#include "replay/executed_path.h"
#include "replay/planned_events.h"
#include "replay/run.h"
#include "replay/section_errors.h"
#include "replay/stated_facts.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;
using enum plan::FindingKind;

constexpr std::size_t kMaxListed = 100; // of one kind; further ones are only counted

class Judge {
public:
  Judge(ReplayInput in, const ReplayThresholds& limits, const base::RunContext& ctx)
      : in_(std::move(in)), limits_(limits), ctx_(ctx) {}

  Verification judge(JudgedRuns& judged) {
    check();
    ctx_.report(0.0, "running the program"_text);
    Run run;
    run.path = executeProgram(in_.program, in_.cell, ctx_);
    path_ = &run.path;
    out_.armChecked = path_->arm;
    seconds_ = controllerTimes(in_.program, *path_, TurnLaw::Text);
    out_.durationS = std::accumulate(seconds_.begin(), seconds_.end(), 0.0);
    for (const plan::ProgramPause& p : in_.program.pauses)
      out_.durationS += p.durationS;
    run.volumeMm3.reserve(path_->motionCount());
    for (std::size_t m = 0; m < path_->motionCount(); ++m)
      run.volumeMm3.push_back(motionVolume(in_.program, *path_, m));
    base::returnFreedMemory();
    compare(run);
    computeMassRatio(run);
    const CollectedFindings times = collect([&] { tellTimes(run); });
    const CollectedFindings limits = collect([&] { tellLimits(run); });
    base::freeStorage(in_.program.motions);
    base::returnFreedMemory();
    JudgedRun mine = judgeRun(std::move(run), in_, limits_, judged, ctx_.sub(0.1, 1.0));
    path_ = &mine.run.path;
    tellBeads(mine);
    tell(times);
    tellClashes(mine);
    tell(limits);
    conclude();
    judged.push_back(std::make_shared<const JudgedRun>(strippedForReuse(std::move(mine))));
    base::returnFreedMemory();
    out_.motionS = std::move(seconds_);
    ctx_.report(1.0, "replayed"_text);
    return std::move(out_);
  }

private:
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

  struct CollectedFindings {
    plan::Findings findings;
    std::vector<TextPlace> places; // one per finding
  };
  // Returns the findings that `find` adds, so that they can be reported later in order.
  template <typename Find> CollectedFindings collect(const Find& find) {
    CollectedFindings before{std::exchange(out_.findings, {}), std::exchange(out_.places, {})};
    find();
    return {std::exchange(out_.findings, std::move(before.findings)),
            std::exchange(out_.places, std::move(before.places))};
  }
  void tell(const CollectedFindings& told) {
    out_.findings.insert(out_.findings.end(), told.findings.begin(), told.findings.end());
    out_.places.insert(out_.places.end(), told.places.begin(), told.places.end());
  }

  void add(plan::FindingKind kind, std::vector<plan::NamedValue> values,
           std::optional<Vector3d> where = std::nullopt, TextPlace place = {},
           std::size_t count = 1) {
    out_.findings.push_back(plan::makeFinding(kind, std::move(values), where, count));
    out_.places.push_back(place);
  }
  // Adds a finding with the line of that motion.
  void atMotion(plan::FindingKind kind, std::size_t motion, std::vector<plan::NamedValue> values,
                const Vector3d& where, double whenS, std::size_t count = 1) {
    add(kind, std::move(values), where, place(motion), count);
    out_.findings.back().whenS = whenS;
    out_.findings.back().program = programLine(place(motion), out_.motionPlaces.back());
  }
  TextPlace place(std::size_t motion) const { return out_.motionPlaces[motion]; }

  void deviates(std::vector<TextFinding> found) {
    for (TextFinding& f : found) {
      ++out_.deviations;
      out_.findings.push_back(std::move(f.finding));
      out_.places.push_back(f.place);
    }
  }

  void compare(Run& run) {
    ctx_.report(0.06, "comparing with the plan"_text);
    out_.motionPlaces.reserve(in_.program.motions.size());
    for (std::size_t m = 0; m < in_.program.motions.size(); ++m)
      out_.motionPlaces.push_back(placeOf(in_.program, m));
    const PlannedNozzle planned = plannedNozzle(in_.trajectory, in_.cell, ctx_);
    Alignment alignment =
        alignProgram(in_.program, *path_, planned, in_.trajectory, in_.cell, ctx_);
    deviates(compareWithPlan(in_.program, *path_, planned, in_.trajectory, alignment,
                             ComparisonOptions{}));
    deviates(compareStatedFacts(in_.program, in_.trajectory, alignment, in_.cell, in_.process));
    deviates(compareEvents(in_.program, in_.trajectory, alignment));
    deviates(judgeBesideMotion(in_.program, *path_, in_.plan, in_.trajectory, in_.cell, in_.process,
                               in_.firstPoint));
    const struct PathDeviation deviation =
        pathDeviation(*path_, planned, in_.trajectory, in_.program, alignment, ctx_);
    out_.maxDeviationMm = deviation.mm;
    out_.maxDeviationRad = deviation.rad;
    deviationMotion_ = deviation.motion;
    if (deviation.mm > 0.0)
      deviationAt_ = path_->targetTip[deviation.motion];
    run.knowledge =
        beadKnowledge(alignment.pointOf, in_.trajectory, in_.plan, in_.process.layerHeightMm);
    out_.pointOf = alignment.pointOf;
    run.pointOf = std::move(alignment.pointOf);
    run.commonPoint = run.pointOf;
    if (!in_.commonPoint.empty())
      for (std::size_t& point : run.commonPoint)
        point = point == kUnmatched ? kUnmatched : in_.commonPoint[point];
  }

  // Computes the material that the program deposits.
  void computeMassRatio(const Run& run) {
    const std::vector<double> volume = flowingMm3(in_.program, seconds_);
    for (std::size_t m = 0; m < volume.size(); ++m)
      (run.knowledge[m].ofPart ? out_.depositedMm3 : out_.supportMm3) += volume[m];
    standing_ = standingMm3(in_.program);
    out_.depositedMm3 += standing_;
  }

  void tellBeads(const JudgedRun& run) {
    static_cast<RunFigures&>(out_) = run.figures;
    out_.worst.deviation = deviationAt_;
    out_.worst.flowError = flowErrorAt_;
    const double part = std::max(out_.partVolumeMm3, 1e-9);
    out_.excessFraction += standing_ / part;
    out_.overfillFraction += standing_ / part;
    out_.massRatio = out_.depositedMm3 / std::max(out_.partVolumeMm3, 1e-9);
    for (const BeadFinding& f : run.beads)
      if (f.motion)
        atMotion(f.kind, *f.motion, f.values, *f.where, path_->startS[*f.motion], f.count);
      else
        add(f.kind, f.values, f.where, {}, f.count);
    if (std::abs(out_.massRatio - 1.0) > limits_.massTolerance)
      add(Mass, {{"share", base::percent(100.0 * out_.massRatio)}});
  }

  void tellTimes(const Run& run) {
    SectionErrors worst;
    for (const TurnLaw law : {TurnLaw::Text, TurnLaw::WaySpeed}) {
      if (law == TurnLaw::WaySpeed && in_.program.time.turnMmPerRad <= 0.0)
        continue;
      const SectionErrors errors = sectionErrors(
          in_.program, *path_, in_.trajectory, run.pointOf,
          law == TurnLaw::Text ? seconds_ : controllerTimes(in_.program, *path_, law));
      if (errors.fraction > worst.fraction)
        worst = errors;
    }
    out_.flowErrorFraction = worst.fraction;
    if (worst.worst)
      flowErrorAt_ = path_->targetTip[*worst.worst];
    if (worst.first && worst.fraction > limits_.flowErrorMax)
      atMotion(FlowErrors, *worst.first, {{"share", base::percent(100.0 * worst.fraction)}},
               path_->targetTip[*worst.first], path_->startS[*worst.first]);
    for (std::size_t m = 1; m < seconds_.size(); ++m)
      tellSlow(m, run.pointOf);
  }

  // A travel deposits nothing, but a very slow one is not the planned one.
  void tellSlow(std::size_t m, const std::vector<std::size_t>& pointOf) {
    constexpr double kTimes = 2.0, kSlackS = 1.0;
    const std::size_t j = pointOf[m];
    if (j == 0 || j >= in_.trajectory.pointCount() || pointOf[m - 1] + 1 != j)
      return;
    const double planned = in_.trajectory.timeS[j] - in_.trajectory.timeS[j - 1];
    if (seconds_[m] <= kTimes * planned + kSlackS ||
        // already reported for the programmed speeds
        path_->durationS[m] > kTimes * planned + kSlackS)
      return;
    ++out_.deviations;
    atMotion(SpeedChanged, m,
             {{"time", base::seconds(seconds_[m])}, {"planned", base::seconds(planned)}},
             path_->targetTip[m], path_->startS[m]);
  }

  void tellClashes(const JudgedRun& run) {
    std::vector<Clash> clashes = run.head;
    clashes.insert(clashes.end(), run.arm.begin(), run.arm.end());
    std::stable_sort(clashes.begin(), clashes.end(),
                     [](const Clash& a, const Clash& b) { return a.motion < b.motion; });
    for (std::size_t k = 0; k < clashes.size() && k < kMaxListed; ++k) {
      const Clash& c = clashes[k];
      atMotion(ReplayedCollision, c.motion, {{"first", c.first}, {"second", c.second}}, c.where,
               c.whenS, c.samples);
    }
    if (clashes.size() > kMaxListed)
      add(MoreReplayedCollisions, {{"collisions", clashes.size() - kMaxListed}}, std::nullopt, {},
          clashes.size() - kMaxListed);
  }

  void tellLimits(const Run& run) {
    std::vector<LimitViolation> all = path_->violations;
    for (std::size_t m = 0; m < path_->motionCount(); ++m) {
      const plan::ProgramMotion& motion = in_.program.motions[m];
      const double volume = run.volumeMm3[m];
      const double flow = motion.volumeMm3 >= 0.0 && path_->durationS[m] > 0.0
                              ? volume / path_->durationS[m]
                              : (motion.extruding ? motion.flowMm3PerS : 0.0);
      if (flow > 1.05 * in_.process.maxFlowMm3PerS)
        all.push_back({LimitKind::Flow, m, -1, flow, in_.process.maxFlowMm3PerS});
    }
    std::stable_sort(all.begin(), all.end(), [](const LimitViolation& a, const LimitViolation& b) {
      return a.motion < b.motion;
    });
    std::size_t listed = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const LimitViolation& v = all[k];
      // A violation that continues over the following motions counts once.
      const bool goesOn = k > 0 && all[k - 1].kind == v.kind && all[k - 1].joint == v.joint &&
                          all[k - 1].motion + 1 >= v.motion;
      if (goesOn)
        continue;
      ++out_.limitViolations;
      if (++listed > kMaxListed)
        continue;
      const plan::Finding f = findingOf(v);
      atMotion(f.kind, v.motion, f.values, path_->targetTip[v.motion], path_->startS[v.motion]);
    }
    if (listed > kMaxListed)
      add(MoreLimits, {{"violations", listed - kMaxListed}}, std::nullopt, {}, listed - kMaxListed);
  }

  plan::Finding findingOf(const LimitViolation& v) const {
    const robot::JointKind kind = v.joint >= 0
                                      ? in_.cell.limits()[static_cast<std::size_t>(v.joint)].kind
                                      : robot::JointKind::Turning;
    const bool slides = kind == robot::JointKind::Sliding;
    const auto place = [&](double value) {
      return base::Quantity{robot::shownValue(kind, value),
                            slides ? base::Unit::Mm : base::Unit::Degree};
    };
    const auto speed = [&](double value) {
      return base::Quantity{robot::shownValue(kind, value),
                            slides ? base::Unit::Mm : base::Unit::DegreePerS};
    };
    const int external = v.joint - in_.cell.armDof();
    const base::Value joint =
        external < 0
            ? base::Value(base::message("joint {number}"_text, v.joint + 1))
            : base::Value(in_.cell.externalAxes()[static_cast<std::size_t>(external)].name);
    switch (v.kind) {
    case LimitKind::OutOfReach:
      break;
    case LimitKind::JointRange:
      return plan::makeFinding(
          JointRange, {{"joint", joint}, {"angle", place(v.value)}, {"limit", place(v.limit)}});
    case LimitKind::JointSpeed:
      return plan::makeFinding(
          slides ? SlideSpeed : JointSpeed,
          {{"joint", joint}, {"speed", speed(v.value)}, {"limit", speed(v.limit)}});
    case LimitKind::BranchJump:
      return plan::makeFinding(BranchJump, {{"joint", joint}, {"angle", place(v.value)}});
    case LimitKind::BlendOverlap:
      return plan::makeFinding(BlendOverlap,
                               {{"blend", base::mm(v.value)}, {"way", base::mm(v.limit)}});
    case LimitKind::Flow:
      return plan::makeFinding(plan::FindingKind::Flow,
                               {{"flow", base::Quantity{v.value, base::Unit::Mm3PerS}},
                                {"limit", base::Quantity{v.limit, base::Unit::Mm3PerS}}});
    }
    return plan::makeFinding(OutOfReach);
  }

  void conclude() {
    if (out_.maxDeviationMm > limits_.deviationMaxMm && path_->motionCount() > 0)
      atMotion(plan::FindingKind::PathDeviation, deviationMotion_,
               {{"distance", base::mm(out_.maxDeviationMm)}}, path_->targetTip[deviationMotion_],
               path_->startS[deviationMotion_]);
    const auto atLeast = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value >= limit});
    };
    const auto atMost = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value <= limit});
    };
    atLeast("coveredFraction", out_.coveredFraction, limits_.coveredMin);
    atMost("unsupportedFraction", out_.unsupportedFraction, limits_.unsupportedMax);
    atMost("overfillFraction", out_.overfillFraction, limits_.overfillMax);
    atMost("massRatio", std::abs(out_.massRatio - 1.0), limits_.massTolerance);
    out_.results.back().value = out_.massRatio;
    atMost("collisions", static_cast<double>(out_.collisions),
           static_cast<double>(limits_.collisionsMax));
    atMost("limitViolations", static_cast<double>(out_.limitViolations),
           static_cast<double>(limits_.limitViolationsMax));
    atMost("maxDeviationMm", out_.maxDeviationMm, limits_.deviationMaxMm);
    atMost("flowErrorFraction", out_.flowErrorFraction, limits_.flowErrorMax);
    out_.passed =
        out_.deviations == 0 && std::all_of(out_.results.begin(), out_.results.end(),
                                            [](const ThresholdResult& r) { return r.passed; });
  }

  ReplayInput in_;
  const ReplayThresholds& limits_;
  const base::RunContext& ctx_;
  Verification out_;
  const ExecutedPath* path_ = nullptr;
  std::vector<double> seconds_; // of each motion, on its controller
  double standing_ = 0.0;       // [mm³] deposited while the arm is at rest
  std::size_t deviationMotion_ = 0;
  std::optional<Vector3d> deviationAt_, flowErrorAt_;
};

} // namespace

Verification replayProgram(ReplayInput input, const ReplayThresholds& thresholds,
                           const base::RunContext& ctx, JudgedRuns* judged) {
  JudgedRuns own;
  return Judge(std::move(input), thresholds, ctx).judge(judged ? *judged : own);
}

} // namespace voluta::replay
