#include "pipeline/open_part.h"

#include "base/key_text.h"
#include "geometry/repair/open_surface.h"
#include "geometry/repair/repair.h"
#include "geometry/repair/surface_wall.h"
#include "modes/mode_table.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"

#include <utility>

namespace voluta::pipeline {

namespace {
constexpr const char* kAuto = "auto";
constexpr const char* kClose = "close";
constexpr const char* kThicken = "thicken";
constexpr const char* kWall = "wall";
constexpr double kWallBeads = 2.0;

// The choice, with the one that `auto` stands for.
std::string choiceFor(const project::LoadedPart& loaded, const base::ParameterValues& values) {
  const std::string choice = values.text("openSurfaces");
  if (choice != kAuto)
    return choice;
  return loaded.open && loaded.open->isPlain() ? kClose : kRefuseOpenSurfaces;
}

// Width of the sections of a wall of one bead [mm]: beads of the nominal width fill it.
double oneBeadMm(const process::Process& process) {
  return process::hatchOf(process.beadWidthMm, process.layerHeightMm);
}
} // namespace

base::ParameterTable openSurfaceParameters() {
  return base::ParameterTable({
      base::choiceParameter(
          "openSurfaces", kAuto,
          {{kAuto, "automatic"_text},
           {kRefuseOpenSurfaces, "refuse"_text},
           {kClose, "close"_text},
           {kThicken, "thicken"_text},
           {kWall, "one wall"_text}},
          "Placement"_text, "Open surfaces"_text,
          "How a part whose surface has wide openings or no thickness is handled: "
          "close openings that are flat or small and refuse others, refuse it, close the openings "
          "with patches, thicken the surface to a "
          "wall two beads wide, or print it as one wall, one bead wide."_text,
          true),
  });
}

double openSurfaceWallMm(const process::Process& process) {
  return kWallBeads * process.beadWidthMm;
}

bool isPrintedAsWall(const project::LoadedPart& loaded, const base::ParameterValues& values) {
  return loaded.open && values.text("openSurfaces") == kWall;
}

std::string openSurfacesKey(const project::Choices& choices, const base::ParameterValues& values,
                            const process::Process& process) {
  const std::string choice = values.text("openSurfaces");
  if (choice == kAuto)
    return {};
  if (choice == kRefuseOpenSurfaces)
    return base::keyText(choice);
  if (choice != kWall)
    return base::keyText(choice, openSurfaceWallMm(process));
  return base::keyText(choice, oneBeadMm(process), process.layerHeightMm,
                       modes::findMode(choices.item().mode).upright,
                       choices.item().placement.rotation.coeffs());
}

OpenPart::OpenPart(const project::LoadedPart& loaded, const base::ParameterValues& values,
                   const process::Process& process, bool levelLayers)
    : loaded_(loaded), choice_(choiceFor(loaded, values)),
      wallMm_(choice_ == kWall ? oneBeadMm(process) : openSurfaceWallMm(process)),
      beadMm_(process.beadWidthMm), layerHeightMm_(levelLayers ? process.layerHeightMm : 0.0) {}

std::shared_ptr<const geometry::TriangleMesh>
OpenPart::mesh(double scale, const Eigen::Quaterniond& rotation, const base::RunContext& ctx) {
  if (!loaded_.open || choice_ == kRefuseOpenSurfaces)
    return loaded_.mesh;
  const Eigen::Vector3d up = rotation.normalized().conjugate() * Eigen::Vector3d::UnitZ();
  if (mesh_ && (choice_ == kClose || (scale == scale_ && (choice_ != kWall || up == up_))))
    return mesh_;
  scale_ = scale;
  up_ = up;
  make(ctx);
  return mesh_;
}

void OpenPart::make(const base::RunContext& ctx) {
  if (choice_ == kClose) {
    geometry::RepairResult closed = project::closedPart(loaded_, ctx);
    repairs_ = std::move(closed.repairs);
    remains_ = std::move(closed.remains);
    mesh_ = std::make_shared<geometry::TriangleMesh>(std::move(closed.mesh));
    return;
  }
  geometry::TriangleMesh wall =
      choice_ == kWall ? geometry::surfaceWall(
                             *loaded_.mesh, {wallMm_ / scale_, layerHeightMm_ / scale_, up_}, ctx)
                       : geometry::thickened(*loaded_.mesh, wallMm_ / scale_, ctx);
  remains_ = geometry::diagnose(wall, ctx).sentences();
  mesh_ = std::make_shared<geometry::TriangleMesh>(std::move(wall));
}

plan::Findings OpenPart::findings() const {
  if (!loaded_.open)
    return {};
  plan::Findings findings = doneFindings();
  const plan::Findings defects = defectFindings(remains_);
  findings.insert(findings.end(), defects.begin(), defects.end());
  return findings;
}

plan::Findings OpenPart::doneFindings() const {
  using plan::FindingKind;
  const geometry::OpenSurface& open = *loaded_.open;
  if (choice_ == kWall)
    return {plan::makeFinding(FindingKind::SurfaceAsWall, {{"width", base::mm(beadMm_)}})};
  if (choice_ == kThicken)
    return {plan::makeFinding(FindingKind::SurfaceThickened, {{"wall", base::mm(wallMm_)}})};
  const std::vector<plan::NamedValue> sheets{{"share", base::percent(100.0 * open.sheetShare)},
                                             {"triangles", open.sheetTriangles}};
  if (choice_ == kClose) {
    plan::Findings findings;
    if (open.hasOpenRims())
      findings.push_back(plan::makeFinding(FindingKind::RimsClosed,
                                           {{"share", base::percent(100.0 * open.capShare)}}));
    if (open.isSheetModel())
      findings.push_back(plan::makeFinding(FindingKind::SheetsLeftOut, sheets));
    return findings;
  }
  if (open.isSheetModel())
    return {plan::makeFinding(FindingKind::SheetModel, sheets)};
  return {plan::makeFinding(FindingKind::OpenRims,
                            {{"rims", open.rims}, {"width", base::mm(open.widestMm)}})};
}

} // namespace voluta::pipeline
