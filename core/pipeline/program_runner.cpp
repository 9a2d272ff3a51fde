#include "pipeline/program_runner.h"

#include "base/error.h"
#include "pipeline/avoided.h"
#include "pipeline/checked_program.h"
#include "pipeline/given_paths.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/judged_part.h"
#include "pipeline/replay_stage.h"
#include "pipeline/replayed/shared_runs.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "program/bead_words.h"
#include "program/dialect.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace voluta::pipeline {

namespace {

class ProgramRun {
public:
  ProgramRun(PlanResult& result, const ProgramHooks& hooks, const base::RunContext& ctx)
      : result_(result), hooks_(hooks), ctx_(ctx),
        formats_(chosenFormats(result.job.choices, *result.cell)) {}

  ProgramsOutcome run() {
    constexpr int kRounds = 6; // of planning the motion again
    Avoided avoided;
    result_.checked.clear();
    for (int round = 0;; ++round) {
      const bool mayPlanAgain = hooks_.planWithout && round < kRounds;
      write(mayPlanAgain);
      std::vector<std::size_t> found;
      for (const auto& checked : result_.checked)
        std::ranges::copy(collidingIn(*checked), std::back_inserter(found));
      const std::vector<std::size_t> skipped = avoided.next(*result_.job.toolPlan, found);
      if (skipped.empty() || !mayPlanAgain || isHopeless() || !hooks_.planWithout(skipped))
        break;
    }
    return report();
  }

private:
  // `untilCollision`: stop after the first program with collisions.
  void write(bool untilCollision) {
    const project::Job& job = result_.job;
    const auto printed = judgedPart(job, result_.resolved());
    const platform::PlatformSolid platform = project::platformOf(job);
    const ProgramStageInput in =
        programStageInput(job, *printed, platform, *result_.cell, result_.resolved());
    for (const auto& before : result_.checked)
      replaced_ += before->timings;
    result_.checked.clear();
    SharedRuns shared;
    const double count = static_cast<double>(formats_.size());
    for (std::size_t i = 0; i < formats_.size(); ++i) {
      if (i > 0 &&
          ((untilCollision && !collidingIn(*result_.checked.back()).empty()) || isHopeless()))
        return;
      const double at = static_cast<double>(i);
      const auto make = [&] {
        return programStage(formats_[i], in, ctx_.sub(at / count, (at + 1.0) / count), &shared);
      };
      result_.checked.push_back(hooks_.take ? hooks_.take(formats_[i], make) : make());
    }
  }

  ProgramsOutcome report() {
    ProgramsOutcome out;
    out.timings = replaced_;
    bool hasVerdict = false;
    for (const auto& checked : result_.checked) {
      out.timings += checked->timings;
      const bool counts = decides(*checked), isFirst = !hasVerdict && counts;
      hasVerdict = hasVerdict || isFirst;
      reportProgram(*checked, isFirst, counts, result_.job.report, out.findings);
      if (const auto without = program::withoutForce(checked->program.format, result_.tooling());
          without && counts)
        out.findings.push_back(*without);
    }
    const project::Job& job = result_.job;
    if (job.items.size() > 1)
      nameItems(out.findings, job.items, result_.tooling().first().process.beadWidthMaxMm);
    std::vector<bool> isGiven;
    for (std::size_t i = 0; i < job.items.size(); ++i)
      isGiven.push_back(takesGivenPaths(*job.item(i).loaded, result_.item(i).resolved->values));
    out.findings = withRemediesForGiven(std::move(out.findings), isGiven);
    out.isHopeless = isHopeless();
    return out;
  }

  // In a trial: returns whether a program fails for another reason than collisions, which no other
  // motion can repair.
  bool isHopeless() const {
    return hooks_.isTrial && std::ranges::any_of(result_.checked, [this](const auto& checked) {
             return decides(*checked) &&
                    checked->failed.size() > (checked->collidingWaypoints.empty() ? 0 : 1);
           });
  }

  bool decides(const CheckedProgram& checked) const {
    return program::decidesOnPlan(checked.program.format, formats_, *result_.cell);
  }

  // Returns the colliding waypoints to skip. In a program for another controller, which moves
  // differently, many collisions are not worth replanning; only isolated ones are, so that they
  // alone do not get the program refused.
  std::vector<std::size_t> collidingIn(const CheckedProgram& checked) const {
    constexpr double kIsolatedShare = 0.002; // of the waypoints
    const auto waypoints = static_cast<double>(result_.job.toolPlan->waypointCount());
    return decides(checked) || static_cast<double>(checked.collidingWaypoints.size()) <=
                                   kIsolatedShare * waypoints
               ? checked.collidingWaypoints
               : std::vector<std::size_t>();
  }

  PlanResult& result_;
  const ProgramHooks& hooks_;
  const base::RunContext& ctx_;
  project::Timings replaced_; // of programs written before the motion was planned again
  const std::vector<std::string> formats_;
};

} // namespace

ProgramsOutcome runPrograms(PlanResult& result, const ProgramHooks& hooks,
                            const base::RunContext& ctx) {
  base::require(result.cell && result.job.toolPlan && result.job.trajectory, "a job with a motion");
  return ProgramRun(result, hooks, ctx).run();
}

} // namespace voluta::pipeline
