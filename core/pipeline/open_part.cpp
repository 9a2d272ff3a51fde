#include "pipeline/open_part.h"

#include "base/key_text.h"
#include "geometry/repair/open_surface.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"

#include <utility>

namespace voluta::pipeline {

namespace {
constexpr const char* kClose = "close";
constexpr const char* kThicken = "thicken";
constexpr double kWallBeads = 2.0;
} // namespace

base::ParameterTable openSurfaceParameters() {
  return base::ParameterTable({
      base::choiceParameter(
          "openSurfaces", kRefuseOpenSurfaces,
          {{kRefuseOpenSurfaces, "refuse"_text},
           {kClose, "close"_text},
           {kThicken, "thicken"_text}},
          "Placement"_text, "Open surfaces"_text,
          "How a part whose surface has wide openings or no thickness is handled: "
          "refuse it, close the openings with patches, or thicken the surface to a "
          "wall two beads wide."_text,
          true),
  });
}

double openSurfaceWallMm(const process::Process& process) {
  return kWallBeads * process.beadWidthMm;
}

std::string openSurfacesKey(const base::ParameterValues& values, const process::Process& process) {
  const std::string choice = values.text("openSurfaces");
  return choice == kRefuseOpenSurfaces ? std::string()
                                       : base::keyText(choice, openSurfaceWallMm(process));
}

OpenPart::OpenPart(const project::LoadedPart& loaded, const base::ParameterValues& values,
                   const process::Process& process)
    : loaded_(loaded), choice_(values.text("openSurfaces")), wallMm_(openSurfaceWallMm(process)) {}

std::shared_ptr<const geometry::TriangleMesh> OpenPart::mesh(double scale,
                                                             const base::RunContext& ctx) {
  if (!loaded_.open || choice_ == kRefuseOpenSurfaces)
    return loaded_.mesh;
  if (mesh_ && (choice_ == kClose || scale == scale_))
    return mesh_;
  make(scale, ctx);
  return mesh_;
}

void OpenPart::make(double scale, const base::RunContext& ctx) {
  scale_ = scale;
  if (choice_ == kClose) {
    geometry::RepairResult closed = project::closedPart(loaded_, ctx);
    repairs_ = std::move(closed.repairs);
    remains_ = std::move(closed.remains);
    mesh_ = std::make_shared<geometry::TriangleMesh>(std::move(closed.mesh));
    return;
  }
  geometry::TriangleMesh wall = geometry::thickened(*loaded_.mesh, wallMm_ / scale, ctx);
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
