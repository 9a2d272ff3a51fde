#include "base/staged_folder.h"
#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "pipeline/outputs.h"
#include "plan/finding_kinds.h"

#include <fmt/format.h>

namespace voluta::cli {

namespace {
// The most pressing finding says in one line why the plan is not complete.
void sayFindings(const plan::Findings& findings) {
  std::size_t blocking = 0;
  const plan::Finding* first = nullptr;
  for (const plan::Finding& f : findings)
    if (f.blocking && blocking++ == 0)
      first = &f;
  if (!first)
    return;
  const std::string where = first->where
                                ? fmt::format(" at ({:.1f}, {:.1f}, {:.1f})", first->where->x(),
                                              first->where->y(), first->where->z())
                                : "";
  fmt::print(stderr, "{}: {}{} ({}){}\n", plan::stageName(plan::stageOf(*first)),
             plan::englishReason(*first), where, plan::englishRemedy(*first),
             blocking > 1 ? fmt::format("; {} findings more in report.json", blocking - 1) : "");
}

void sayResult(const project::Report& r) {
  const project::DecompositionReport& d = r.decomposition;
  for (const project::TriedReport& tried : r.tried)
    if (!tried.taken)
      fmt::print("mode {} on {} is not taken: {}\n", tried.mode, tried.platform,
                 base::english(tried.reason));
  fmt::print("mode {}; ", d.mode);
  if (d.voxels > 0)
    fmt::print("{} voxels, {} missed; ", d.voxels, d.missedAfterSupports);
  if (!d.pieceList.empty())
    fmt::print("{} pieces, {:.1f} of {:.1f} mm2 risky; ", d.pieces, d.riskyAreaMm2,
               d.riskyAreaBeforeMm2);
  fmt::print("{} layers; {} waypoints, {:.0f} s\n", r.layers.count, r.toolpath.waypoints,
             r.motion.durationS);
  if (r.replay.thresholds.covered > 0.0)
    fmt::print("replay {}: covered {:.4f}, unsupported {:.4f}, overfill {:.4f}, mass {:.4f}, "
               "{} collisions, deviation {:.4f} mm\n",
               r.replay.passed ? "passed" : "NOT passed", r.replay.coveredFraction,
               r.replay.unsupportedFraction, r.replay.overfillFraction, r.replay.massRatio,
               r.replay.collisions, r.replay.maxDeviationMm);
}
} // namespace

ExitCode reportingCommand(const ReportingWork& work, const std::filesystem::path& folder,
                          int threads, ProgressStyle progress) {
  base::StagedFolder staged(folder);
  auto outcome = runInterruptibly(
      [work, inside = staged.path()](const base::RunContext& ctx) { return work(inside, ctx); },
      threads, progressSink(progress), [&] { staged.discard(); });
  endProgress(progress);
  const auto report = settled(std::move(outcome), staged, folder);
  if (!report)
    return kCancelled;
  sayResult(*report);
  sayFindings(report->findings);
  return pipeline::nothingBlocks(*report) ? kDone : kNotAll;
}

ExitCode planCommand(const PlanOptions& options) {
  return reportingCommand(
      [request = options.request](const std::filesystem::path& folder,
                                  const base::RunContext& ctx) {
        pipeline::PlanResult result = pipeline::planPart(request, ctx.sub(0.0, 0.97));
        pipeline::writeOutputs(result, folder, ctx.sub(0.97, 1.0));
        return result.job.report;
      },
      options.folder, options.threads, options.progress);
}

} // namespace voluta::cli
