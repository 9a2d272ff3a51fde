#include "base/memory.h"
#include "base/run_context.h"
#include "plan/finding_kinds.h"
#include "replay/program_run.h"
#include "replay/replay_steps.h"
#include "replay/verdict_findings.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;
using enum plan::FindingKind;

// See Verification::massRatio.
double massRatio(double depositedMm3, double intendedMm3, double thinMm3) {
  const double most = std::max(intendedMm3, 1e-9), least = std::max(intendedMm3 - thinMm3, 1e-9);
  return depositedMm3 / std::clamp(depositedMm3, least, most);
}

// Completes a verdict by what was found in the run.
class VerdictWriter {
public:
  VerdictWriter(ComparedProgram& compared, const JudgedRun& run, const ReplayThresholds& limits)
      : compared_(compared), out_(compared.verdict), run_(run), path_(run.run.path),
        limits_(limits) {}

  void write() {
    addFigures();
    addBeads();
    addFindings(out_, std::move(compared_.times));
    addClashes();
    addFindings(out_, std::move(compared_.limits));
    addDeviation();
    conclude();
  }

private:
  void add(plan::FindingKind kind, std::vector<plan::NamedValue> values,
           std::optional<Vector3d> where = std::nullopt, std::size_t count = 1, int item = -1) {
    plan::Finding finding = plan::makeFinding(kind, std::move(values), where, count);
    finding.item = item;
    addFinding(out_, {std::move(finding), {}});
  }
  void atMotion(plan::FindingKind kind, std::size_t motion, std::vector<plan::NamedValue> values,
                const Vector3d& where, double whenS, std::size_t count = 1) {
    addFinding(out_, findingAtMotion(out_, kind, motion, std::move(values), where, whenS, count));
  }

  void addFigures() {
    const WorstPlaces ofText = out_.worst;
    static_cast<RunFigures&>(out_) = run_.figures;
    out_.worst.deviation = ofText.deviation;
    out_.worst.flowError = ofText.flowError;
    const double part = std::max(out_.partVolumeMm3, 1e-9);
    out_.excessFraction += compared_.standingMm3 / part;
    out_.overfillFraction += compared_.standingMm3 / part;
    out_.massRatio = massRatio(out_.depositedMm3, out_.intendedMm3, out_.thinMm3);
    for (std::size_t i = 0; i < out_.items.size(); ++i)
      out_.items[i].massRatio = massRatio(out_.depositedOfItemMm3.at(i), out_.items[i].intendedMm3,
                                          out_.items[i].thinMm3);
  }

  void addBeads() {
    for (const BeadFinding& f : run_.beads)
      addBead(f);
    for (const BeadFinding& f : run_.layerTimes)
      addBead(f);
    if (out_.items.empty())
      addMass(out_.massRatio, -1);
    for (std::size_t i = 0; i < out_.items.size(); ++i)
      addMass(out_.items[i].massRatio, static_cast<int>(i));
  }

  void addMass(double ratio, int item) {
    if (std::abs(ratio - 1.0) > limits_.massTolerance)
      add(Mass, {{"share", base::percent(100.0 * ratio)}}, std::nullopt, 1, item);
  }

  void addBead(const BeadFinding& f) {
    if (f.motion) {
      atMotion(f.kind, *f.motion, f.values, *f.where, path_.startS[*f.motion], f.count);
      out_.findings.back().item = f.item;
    } else {
      add(f.kind, f.values, f.where, f.count, f.item);
    }
  }

  void addClashes() {
    std::vector<Clash> clashes = run_.head;
    clashes.insert(clashes.end(), run_.arm.begin(), run_.arm.end());
    std::stable_sort(clashes.begin(), clashes.end(),
                     [](const Clash& a, const Clash& b) { return a.motion < b.motion; });
    for (std::size_t k = 0; k < clashes.size() && k < kMaxListed; ++k) {
      const Clash& c = clashes[k];
      atMotion(ReplayedCollision, c.motion, {{"first", c.first}, {"second", c.second}}, c.where,
               c.whenS, c.samples);
    }
    if (clashes.size() > kMaxListed)
      addFinding(out_, {plan::makeMoreFinding(ReplayedCollision, {}, std::nullopt,
                                              clashes.size() - kMaxListed),
                        {}});
  }

  void addDeviation() {
    const std::size_t motion = compared_.deviationMotion;
    if (out_.maxDeviationMm > limits_.deviationMaxMm && path_.motionCount() > 0)
      atMotion(plan::FindingKind::PathDeviation, motion,
               {{"distance", base::mm(out_.maxDeviationMm)}}, path_.targetTip[motion],
               path_.startS[motion]);
  }

  void conclude() {
    const auto atLeast = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value >= limit});
    };
    const auto atMost = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value <= limit});
    };
    const auto safe = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value <= limit, true});
    };
    // Of several items, the worst one decides.
    double covered = out_.coveredFraction, unsupported = out_.unsupportedFraction;
    double mass = out_.massRatio, thin = out_.thinFraction;
    for (const ItemFigures& item : out_.items) {
      covered = std::min(covered, item.coveredFraction);
      thin = std::max(thin, item.thinFraction);
      unsupported = std::max(unsupported, item.unsupportedFraction);
      if (std::abs(item.massRatio - 1.0) > std::abs(mass - 1.0))
        mass = item.massRatio;
    }
    atLeast("coveredFraction", covered, limits_.coveredMin);
    atMost("thinFraction", thin, limits_.thinMax);
    atMost("unsupportedFraction", unsupported, limits_.unsupportedMax);
    atMost("overfillFraction", out_.overfillFraction, limits_.overfillMax);
    atMost("massRatio", std::abs(mass - 1.0), limits_.massTolerance);
    out_.results.back().value = mass;
    safe("collisions", static_cast<double>(out_.collisions),
         static_cast<double>(limits_.collisionsMax));
    safe("limitViolations", static_cast<double>(out_.limitViolations),
         static_cast<double>(limits_.limitViolationsMax));
    safe("maxDeviationMm", out_.maxDeviationMm, limits_.deviationMaxMm);
    safe("flowErrorFraction", out_.flowErrorFraction, limits_.flowErrorMax);
    out_.safeToRun =
        out_.deviations == 0 && std::ranges::all_of(out_.results, [](const ThresholdResult& r) {
          return r.passed || !r.concernsSafety;
        });
    out_.passed = out_.safeToRun && std::ranges::all_of(out_.results, &ThresholdResult::passed);
  }

  ComparedProgram& compared_;
  Verification& out_;
  const JudgedRun& run_;
  const ExecutedPath& path_;
  const ReplayThresholds& limits_;
};

} // namespace

JudgedProgram judgeProgram(ComparedProgram compared, const ReplayInput& input,
                           const ReplayThresholds& thresholds, KnownResults known,
                           const base::RunContext& ctx) {
  JudgedRun run =
      judgeRun(std::move(compared.run), input, thresholds, std::move(known), ctx.sub(0.1, 1.0));
  VerdictWriter(compared, run, thresholds).write();
  ctx.report(1.0, "replayed"_text);
  return {std::move(compared.verdict), std::move(run)};
}

Verification replayProgram(ReplayInput input, const ReplayThresholds& thresholds,
                           const base::RunContext& ctx) {
  ComparedProgram compared = compareProgram(input, thresholds, ctx);
  Verification verdict = judgeProgram(std::move(compared), input, thresholds, {}, ctx).verdict;
  base::returnFreedMemory();
  return verdict;
}

} // namespace voluta::replay
