#include "base/error.h"
#include "curved/platform.h"
#include "geometry/diagnosis.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "pipeline/choices.h"
#include "pipeline/stages.h"
#include "robot/cell.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {
// Tilt to which every point of a part has to be within reach; layers that wrap the sides of a part
// ask for about this much.
constexpr double kReachTiltRad = 1.75;

// Largest scale <= 1 at which the ball about the part's box, standing on the plate, is in reach.
double fittingScale(const geometry::TriangleMesh& mesh, const geometry::Placement& placement,
                    const robot::Cell& cell) {
  geometry::Placement turned;
  turned.rotation = placement.rotation;
  const Eigen::AlignedBox3d box = geometry::bounds(geometry::place(mesh, 1.0, turned));
  const double radius = 0.5 * box.diagonal().norm();
  return std::min(1.0, robot::reachableBallRadius(cell, kReachTiltRad) / radius);
}
} // namespace

std::shared_ptr<const LoadStage> loadStage(const LoadedPart& loaded, const Choices& choices,
                                           const process::Process& process) {
  auto stage = std::make_shared<LoadStage>();
  const double wanted = parsedScale(choices.scale);
  stage->scale =
      wanted > 0.0
          ? wanted
          : fittingScale(*loaded.mesh, choices.placement,
                         robot::loadCell(choices.cell, process, curved::platformDisc(80.0)));
  stage->part = std::make_shared<geometry::TriangleMesh>(
      geometry::place(*loaded.mesh, stage->scale, choices.placement));
  const geometry::Diagnosis diagnosis = geometry::diagnose(*stage->part);
  stage->report.scale = stage->scale;
  stage->report.triangles = stage->part->triangles.size();
  stage->report.watertight = diagnosis.watertight;
  stage->report.volumeMm3 = diagnosis.volumeMm3;
  stage->report.boundsMm = diagnosis.boundsMm;
  return stage;
}

plan::Findings remainingDefects(const LoadedPart& loaded) {
  plan::Findings findings;
  for (const std::string& defect : loaded.remains) {
    plan::Finding finding;
    finding.stage = "load";
    finding.kind = "meshDefect";
    finding.reason = defect;
    finding.remedy = "mend the mesh in a modelling program if the result looks wrong";
    finding.blocking = false;
    findings.push_back(std::move(finding));
  }
  return findings;
}

} // namespace voluta::pipeline
