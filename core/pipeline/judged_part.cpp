#include "pipeline/judged_part.h"

#include "geometry/append_mesh.h"
#include "pipeline/given_paths.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "planar/slicing/corrected_mesh.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/job.h"

namespace voluta::pipeline {

namespace {
planar::SizeCorrection correctionOf(const project::Job& job, std::size_t item,
                                    const process::Tooling& tooling) {
  if (job.report.item(item).decomposition.mode != "flat")
    return {};
  const project::Choices own = project::onlyItem(job.choices, item);
  // The tool-paths of a file are not corrected.
  if (job.item(item).loaded && takesGivenPaths(*job.item(item).loaded, parameterValues(own)))
    return {};
  const process::Process& process = tooling.at(static_cast<int>(ownTool(own))).process;
  return {process.scaleX, process.scaleY, process.outlineOffsetMm, process.holeOffsetMm};
}
} // namespace

std::shared_ptr<const geometry::TriangleMesh> judgedPart(const project::Job& job,
                                                         const Resolved& resolved) {
  bool isCorrected = false;
  auto all = std::make_shared<geometry::TriangleMesh>();
  // Layers along the user's planes are not corrected.
  for (std::size_t i = 0; i < job.items.size() && resolved.values.text("layerPlanes").empty();
       ++i) {
    const planar::SizeCorrection correction = correctionOf(job, i, resolved.tooling);
    isCorrected = isCorrected || !correction.isNeutral();
    if (!isCorrected && job.items.size() == 1)
      break;
    geometry::appendMesh(*all, correction.isNeutral()
                                   ? job.items[i].printed()
                                   : planar::correctedMesh(job.items[i].printed(), correction));
  }
  return isCorrected ? all : project::printedOf(job);
}

} // namespace voluta::pipeline
