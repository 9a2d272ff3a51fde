#include "cli/commands.h"
#include "cli/result_folder.h"
#include "pictures/job_picture.h"
#include "pipeline/outputs.h"
#include "plan/tool_plan.h"

#include <fmt/format.h>

namespace voluta::cli {

ExitCode resumeCommand(const ResumeOptions& options) {
  keepStoppedPrint(options.request.job, options.folder, options.replace);
  return reportingCommand(
      [request = options.request](const std::filesystem::path& folder,
                                  const base::RunContext& ctx) {
        pipeline::ResumeResult resumed = pipeline::resumePrint(request, ctx.sub(0.0, 0.97));
        pipeline::writeOutputs(resumed.plan, folder, ctx.sub(0.97, 1.0),
                               {.pictures = pictures::proofPictures});
        fmt::print("from bead {} of {}, waypoint {}; {:.0f} mm3 printed, {:.0f} mm3 left\n",
                   resumed.bead, resumed.plan.job.toolPlan->paths.size(), resumed.waypoint,
                   resumed.depositedMm3, resumed.leftMm3);
        return resumed.plan.job.report;
      },
      options.folder, options.replace, options.threads, options.progress);
}

} // namespace voluta::cli
