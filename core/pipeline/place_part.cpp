#include "base/error.h"
#include "base/key_text.h"
#include "curved/platform_polygon.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "geometry/repair/diagnosis.h"
#include "modes/growth_plate.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/cell_plate.h"
#include "pipeline/given_paths.h"
#include "pipeline/item_regions.h"
#include "pipeline/open_part.h"
#include "pipeline/part_size.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "pipeline/turned_part.h"
#include "plan/finding_kinds.h"
#include "robot/kinematics/reachable_ball.h"
#include "voxel/solid_voxels.h"
#include "voxel/voxel_object.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

namespace voluta::pipeline {

namespace {
// Tilt up to which every point of a part has to be reachable by a fixed nozzle; layers that wrap
// around the sides of a part need about this much. A nozzle carried by the arm tilts this far in
// few places only, and flat layers need no tilt: there the part only has to be reachable from
// above. Motion planning reports places that need more tilt than the arm reaches.
constexpr double kReachTiltRad = 1.75;

// Returns the largest scale at which the bounding sphere of the part's box, standing on the plate,
// is within reach; returns `enough` if the scale is at least that.
double reachingScale(const geometry::TriangleMesh& mesh, double unit,
                     const geometry::Placement& placement, const robot::Cell& cell,
                     std::optional<double> enough = std::nullopt) {
  geometry::Placement turned;
  turned.rotation = placement.rotation;
  const Eigen::AlignedBox3d box = geometry::bounds(geometry::place(mesh, unit, turned));
  const double radius = 0.5 * box.diagonal().norm();
  const bool tilts = cell.nozzleMount() == robot::Mount::World && cell.tilts();
  const double tilt = tilts ? kReachTiltRad : 0.0;
  if (enough && robot::reachesBall(cell, tilt, *enough * radius))
    return *enough;
  return robot::reachableBallRadius(cell, tilt) / radius;
}

// Sets the object's voxels and platform at the position of `stage.part`.
void placeCells(const project::LoadedPart& loaded, double pitch,
                const geometry::Placement& placement, const base::RunContext& ctx,
                modes::LoadStage& stage) {
  const voxel::VoxelObject& object = *loaded.cells;
  const Eigen::Matrix3d rotation = placement.rotation.normalized().toRotationMatrix();
  constexpr double kSame = 1e-6;
  const Eigen::Matrix3d quarter = rotation.array().round();
  const double lift = placement.liftMm / pitch;
  const bool turned = (rotation - quarter).cwiseAbs().maxCoeff() > kSame;
  const bool lifted = std::abs(lift - std::round(lift)) > kSame;
  if (turned || lifted) {
    stage.voxels =
        std::make_shared<voxel::SolidVoxels>(voxel::solidVoxels(*stage.part, pitch, ctx));
    stage.findings.push_back(plan::makeFinding(turned ? plan::FindingKind::CellsTurned
                                                      : plan::FindingKind::CellsLifted));
  } else {
    stage.voxels = std::make_shared<voxel::SolidVoxels>(
        voxel::solidVoxels(object, quarter.cast<int>(), pitch, placement.centreMm,
                           static_cast<int>(std::lround(lift))));
  }
  if (rotation(2, 2) < 1.0 - kSame)
    return;
  const Eigen::Vector3d origin =
      stage.part->vertices[0] - pitch * (rotation * loaded.mesh->vertices[0]);
  std::vector<Eigen::Vector2d> corners;
  for (const auto& [i, j] : object.platform)
    for (int c = 0; c < 4; ++c)
      corners.push_back(
          (origin + pitch * (rotation * Eigen::Vector3d(i + c % 2, j + c / 2, 0.0))).head<2>());
  stage.platform = geometry::convexPolygon(std::move(corners));
}

bool isUntouched(const geometry::Placement& p) {
  return p.rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs() &&
         p.centreMm == Eigen::Vector2d::Zero() && p.liftMm == 0.0;
}
} // namespace

bool keepsGivenPlacement(const project::LoadedPart& loaded, const Resolved& resolved) {
  return loaded.inWorkFrame && takesGivenPaths(loaded, resolved.values) &&
         !resolved.isBesideOthers && isUntouched(resolved.choices.item().placement);
}

geometry::Placement placementByHandOrMode(const geometry::TriangleMesh& mesh, double scale,
                                          const modes::ModeChoices& in) {
  const geometry::Placement& own = in.choices.item().placement;
  const auto& place = modes::findMode(in.choices.item().mode).place;
  return place && isUntouched(own) ? place(in, mesh, scale) : own;
}

platform::PlatformSolid plannedPlatform(const modes::LoadStage& placed, const Resolved& resolved) {
  const auto& [choices, values, process] = resolved.modeChoices();
  if (const auto& platform = modes::findMode(choices.item().mode).platform)
    return platform(resolved.modeChoices(), placed);
  const bool asksForCells = choices.item().platform.marginMm() && placed.platform.empty();
  const voxel::SolidVoxels cells =
      !asksForCells   ? voxel::SolidVoxels{}
      : placed.voxels ? *placed.voxels
                      : voxel::solidVoxels(*placed.part, values.number("voxelMm"), {});
  return modes::plateOf(choices.item().platform, cells, placed.platform);
}

std::string plannedPlatformKey(const Resolved& resolved) {
  const auto& [choices, values, process] = resolved.modeChoices();
  if (const auto& platform = modes::findMode(choices.item().mode).platform)
    return base::keyText(choices.item().mode) + platform.key(resolved.modeChoices());
  return base::keyText(choices.item().mode, choices.item().platform, values.number("voxelMm"));
}

std::shared_ptr<const modes::LoadStage> loadStage(const project::LoadedPart& loaded,
                                                  const Resolved& resolved,
                                                  const base::RunContext& ctx) {
  auto stage = std::make_shared<modes::LoadStage>();
  const modes::ModeChoices in = resolved.modeChoices();
  const auto& [choices, values, process] = in;
  const double unit = unitMm(loaded, choices);
  const double wanted = project::parsedScale(choices.item().scale);
  const modes::Mode& mode = modes::findMode(choices.item().mode);
  const auto scaleFor = [&](const geometry::Placement& how) {
    return wanted > 0.0        ? wanted
           : mode.fittingScale ? mode.fittingScale(in, *loaded.mesh, unit)
                               : std::min(1.0, reachingScale(*loaded.mesh, unit, how,
                                                             fittingCell(choices, process), 1.0));
  };
  OpenPart shape(loaded, values, process, mode.upright);
  const auto place = [&](const geometry::Placement& how) {
    stage->placement = how;
    stage->scale = scaleFor(how);
    const double scale = stage->scale * unit;
    stage->part = std::make_shared<geometry::TriangleMesh>(
        geometry::place(*shape.mesh(scale, how.rotation, ctx), scale, how));
  };
  const std::optional<geometry::Placement> given =
      keepsGivenPlacement(loaded, resolved) ? givenPlacement(loaded) : std::nullopt;
  place(given ? *given
              : placementByHandOrMode(*loaded.mesh, scaleFor(choices.item().placement) * unit, in));
  if (values.text("orient") != "none") {
    const auto cutsLeave =
        [&](const geometry::Placement& how) -> std::optional<placement::CutOutcome> {
      modes::LoadStage placed;
      placed.placement = how;
      const double scale = scaleFor(how) * unit;
      try {
        placed.part = std::make_shared<geometry::TriangleMesh>(
            geometry::place(*shape.mesh(scale, how.rotation, ctx), scale, how));
        if (choices.item().platform.isOfCell())
          placed.platform = cellPlate(fittingCell(choices, process), *placed.part, plateNeeds(in));
        const auto cut = mode.decompose(in, {placed, {}, {}}, ctx.quiet());
        return placement::CutOutcome{cut->report.riskyAreaMm2,
                                     static_cast<std::size_t>(cut->report.pieces)};
      } catch (const base::Error&) { // does not fit the plate
        return std::nullopt;
      }
    };
    std::shared_ptr<const ItemLoad> load;
    if (values.text("orient") == "leastTension") {
      load = loadOf(*stage, *loaded.mesh, resolved, unit, ctx);
      if (!load)
        throw base::Error(base::ErrorCode::Usage,
                          "`orient=leastTension` needs a region that pushes the part"_text, {},
                          "give regions with the uses 'hold' and 'load'"_text);
    }
    TurnedPart turned =
        turnedPart(*stage->part, choices.item().placement, orientationPlan(in),
                   loaded.cells ? stage->scale * unit : values.number("voxelMm"),
                   loaded.cells != nullptr, mode.cuts ? CheckedCuts(cutsLeave) : CheckedCuts(),
                   load ? placement::TensionOf(
                              [load](const Eigen::Vector3d& up) { return load->tension.along(up); })
                        : placement::TensionOf(),
                   ctx);
    place(turned.placement);
    std::ranges::copy(turned.findings, std::back_inserter(stage->findings));
    stage->timings.decompose = turned.seconds;
  }
  if (loaded.cells)
    placeCells(loaded, stage->scale * unit, stage->placement, ctx, *stage);
  if (choices.item().platform.isOfCell())
    stage->platform = cellPlate(fittingCell(choices, process), *stage->part, plateNeeds(in));
  // Insert them first. They describe the mesh that was placed last.
  const plan::Findings open = shape.findings();
  stage->findings.insert(stage->findings.begin(), open.begin(), open.end());
  stage->report = modelReport(*stage->part);
  stage->report.repairs = shape.repairs();
  stage->report.scale = stage->scale;
  return stage;
}

project::ModelReport modelReport(const geometry::TriangleMesh& part) {
  project::ModelReport report;
  report.triangles = part.triangles.size();
  report.watertight = geometry::isWatertight(part);
  report.volumeMm3 = geometry::volume(part);
  report.boundsMm = geometry::bounds(part);
  return report;
}

bool takesAnyScale(const project::LoadedPart& loaded, const project::Choices& choices) {
  return !loaded.cells && !choices.item().platform.isBody() &&
         !modes::findMode(choices.item().mode).aroundRod;
}

std::shared_ptr<const SizeStage> sizeStage(const project::LoadedPart& loaded,
                                           const modes::LoadStage& placed, const Resolved& resolved,
                                           const base::RunContext& ctx) {
  const auto& [choices, values, process] = resolved.modeChoices();
  const auto reach = [&] {
    return takesAnyScale(loaded, choices)
               ? reachingScale(*loaded.mesh, unitMm(loaded, choices), placed.placement,
                               fittingCell(choices, process))
               : 0.0;
  };
  auto stage = std::make_shared<SizeStage>();
  stage->findings = sizeFindings(*placed.part, placed.scale, reach, process, ctx);
  // Across a slanting wall one bead is thinner than its width.
  if (isPrintedAsWall(loaded, values))
    std::erase_if(stage->findings, [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::ThinPart || f.kind == plan::FindingKind::ThinPartInReach;
    });
  return stage;
}

plan::Findings remainingDefects(const project::LoadedPart& loaded) {
  return loaded.open ? plan::Findings() : defectFindings(loaded.remains);
}

plan::Findings defectFindings(const std::vector<base::Message>& remains) {
  plan::Findings findings;
  for (const base::Message& defect : remains)
    findings.push_back(plan::makeFinding(plan::FindingKind::MeshDefect, {{"defect", defect}}));
  return findings;
}

} // namespace voluta::pipeline
