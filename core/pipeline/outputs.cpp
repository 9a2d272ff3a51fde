#include "pipeline/outputs.h"

#include "base/files.h"
#include "base/stopwatch.h"
#include "layers/vtp_writer.h"
#include "motion/trajectory_csv.h"
#include "pipeline/vti_writer.h"
#include "toolpath/vtp_writer.h"

#include <sys/resource.h>

namespace voluta::pipeline {

namespace {
double peakResidentMb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0; // Linux gives KiB
}

void writeDebug(const PlanResult& result, const std::filesystem::path& folder,
                const base::RunContext& ctx) {
  if (result.decomposition)
    base::writeFile(folder / "voxels.vti", voxelsVti(*result.decomposition));
  ctx.checkpoint();
  if (result.layers)
    base::writeFile(folder / "layers.vtp", layers::writeLayersVtp(*result.layers));
  ctx.checkpoint();
  if (result.job.toolPlan)
    base::writeFile(folder / "toolpath.vtp", toolpath::writeToolpathVtp(*result.job.toolPlan));
  ctx.checkpoint();
  if (result.job.trajectory)
    base::writeFile(folder / "trajectory.csv", motion::trajectoryCsv(*result.job.trajectory));
}
} // namespace

void writeOutputs(PlanResult& result, const std::filesystem::path& folder,
                  const base::RunContext& ctx) {
  base::Stopwatch writing;
  ctx.report(0.0, "write files");
  base::writeFile(folder / "job.voluta", jobBytes(result.job));
  for (const plan::Program& program : result.programs)
    for (const plan::ProgramFile& file : program.files) {
      ctx.checkpoint();
      base::writeFile(folder / file.name, file.text);
    }
  if (result.debug)
    writeDebug(result, folder, ctx);
  ctx.checkpoint();
  result.report.timings.write += writing.seconds();
  result.report.timings.total += writing.seconds();
  result.report.peakRssMb = peakResidentMb();
  base::writeFile(folder / "report.json", reportJson(result.report));
}

} // namespace voluta::pipeline
