#include "base/staged_folder.h"
#include "cli/commands.h"
#include "cli/run_interruptibly.h"
#include "pipeline/outputs.h"

#include <fmt/format.h>

namespace voluta::cli {

ExitCode resumeCommand(const ResumeOptions& options) {
  base::StagedFolder staged(options.folder);
  const std::filesystem::path folder = staged.path();
  auto outcome = runInterruptibly(
      [request = options.request, folder](const base::RunContext& ctx) {
        pipeline::ResumeResult resumed = pipeline::resumePrint(request, ctx.sub(0.0, 0.97));
        pipeline::writeOutputs(resumed.plan, folder, ctx.sub(0.97, 1.0));
        fmt::print("from bead {} of {}, waypoint {}; {:.0f} mm3 are laid, {:.0f} mm3 are left\n",
                   resumed.bead, resumed.plan.job.toolPlan->paths.size(), resumed.waypoint,
                   resumed.laidMm3, resumed.leftMm3);
        return resumed.plan.job.report;
      },
      options.threads, progressSink(options.progress), [&] { staged.discard(); });
  endProgress(options.progress);
  const auto report = settled(std::move(outcome), staged, options.folder);
  if (!report)
    return kCancelled;
  sayReport(*report);
  return pipeline::nothingBlocks(*report) ? kDone : kNotAll;
}

} // namespace voluta::cli
