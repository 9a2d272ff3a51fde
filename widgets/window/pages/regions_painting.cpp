// The strokes by which RegionsTool paints.
#include "base/error.h"
#include "base/units.h"
#include "document/planning.h"
#include "panels/paint_form.h"
#include "project/loaded_part.h"
#include "regions/region_kinds.h"
#include "regions/region_uses.h"
#include "window/pages/region_bodies.h"
#include "window/pages/regions_tool.h"
#include "window/presenters/presenter.h"

#include <utility>

namespace voluta::window {

using project::Region;

struct RegionsTool::Painted {
  std::shared_ptr<const regions::PaintableSurface> surface;
  Mesh mesh;
  std::shared_ptr<const scene::RegionsDrawing> bodies;
};

bool RegionsTool::isPainted() const {
  const auto at = panel_->selected();
  try {
    return at && regions::parsedShape(panel_->regions()[*at].shape).kind->mesh ==
                     regions::ShapeMesh::Painted;
  } catch (const base::Error&) { // shown as a problem
    return false;
  }
}

// Returns whether a stroke goes on.
bool RegionsTool::beginStroke() {
  const auto at = panel_->selected();
  if (!open_ || !isPosed_ || !at || (!isStroke_ && !isPainted()))
    return false;
  if (isStroke_)
    return true;
  isStroke_ = true;
  strokeEnds_ = false;
  rest_.stop();
  lastDabMm_.reset();
  strokeOf_ = *at;
  stroke_ = panel_->regions()[*at].mesh;
  return true;
}

void RegionsTool::paintRectangle(const std::array<viewer::Ray, 4>& corners, bool erases) {
  if (!beginStroke())
    return;
  const Eigen::Isometry3d file_T_work = work_T_file_.inverse();
  regions::SeenThrough through;
  through.eye = file_T_work * corners[0].origin / placed_.scale;
  for (std::size_t k = 0; k < corners.size(); ++k)
    through.corners[k] = file_T_work.linear() * corners[k].direction;
  constexpr double kFinestPoints = 3.0; // of the screen
  Dab dab;
  dab.radius =
      kFinestPoints * work_.viewport.mmPerPoint(work_.presenter.partBox().center()) / placed_.scale;
  dab.erases = erases;
  dab.through = through;
  dabs_.push_back(dab);
  strokeEnds_ = true;
  if (!painting_.running())
    paintDabs();
}

void RegionsTool::painted(const std::optional<scene::Hit>& hit, bool erases, bool finished) {
  if (!beginStroke())
    return;
  const panels::PaintChoices& with = panel_->paint();
  // Dabs that overlap nearly whole are not worth their time.
  constexpr double kApart = 0.3; // of the brush's radius
  if (hit && (!lastDabMm_ || (hit->point - *lastDabMm_).norm() > kApart * with.radiusMm)) {
    lastDabMm_ = hit->point;
    dabs_.push_back({work_T_file_.inverse() * hit->point / placed_.scale,
                     with.radiusMm / placed_.scale, base::degreesToRadians(with.angleDeg),
                     with.with == panels::PaintChoices::With::Faces, erases});
  }
  strokeEnds_ = strokeEnds_ || finished;
  if (!painting_.running())
    paintDabs();
}

void RegionsTool::paintDabs() {
  if (strokeOf_ >= panel_->regions().size()) { // undone meanwhile
    dropStroke();
    return;
  }
  if (dabs_.empty() || !bodies_) {
    if (strokeEnds_)
      endStroke();
    return;
  }
  const Mesh part = placed_.source->mesh;
  const Region& region = panel_->regions()[strokeOf_];
  painting_.run(
      [part, stroke = stroke_, dabs = std::exchange(dabs_, {}), bodies = bodies_, at = strokeOf_,
       look = lookOf(region), work_T_file = work_T_file_, scale = placed_.scale,
       surface = surfaceOf_ == part ? surface_ : nullptr](const base::RunContext&) {
        Painted made{surface, stroke, nullptr};
        if (!made.surface)
          made.surface = std::make_shared<const regions::PaintableSurface>(part);
        geometry::TriangleMesh mesh = stroke ? *stroke : geometry::TriangleMesh{};
        for (const Dab& dab : dabs) {
          if (dab.through) {
            const auto seen = made.surface->seen(*dab.through, dab.radius);
            mesh = dab.erases ? regions::withoutPaint(mesh, seen, dab.radius)
                              : regions::withPaint(mesh, seen, dab.radius);
          } else if (dab.faces) {
            const auto faces = made.surface->facesFrom(dab.place, dab.angleRad);
            mesh =
                dab.erases ? regions::withoutPaint(mesh, faces) : regions::withPaint(mesh, faces);
          } else {
            const regions::Brush brush{dab.place, dab.radius};
            mesh = dab.erases ? regions::withoutPaint(mesh, brush)
                              : regions::withPaint(mesh, made.surface->within(brush),
                                                   regions::finestOf(brush));
          }
        }
        const auto over =
            std::make_shared<const geometry::TriangleMesh>(overPart(mesh, work_T_file, scale));
        made.bodies = scene::withRegion(*bodies, at, {over, look});
        made.mesh = std::make_shared<const geometry::TriangleMesh>(std::move(mesh));
        return made;
      },
      [this, part](const base::Outcome<Painted>& outcome) {
        const auto* made = std::get_if<Painted>(&outcome);
        if (!made || !isStroke_) {
          dropStroke();
          return;
        }
        surface_ = made->surface;
        surfaceOf_ = part;
        stroke_ = made->mesh;
        bodies_ = made->bodies;
        work_.viewport.scene().setRegions(bodies_);
        work_.shell.showView();
        paintDabs();
      },
      1);
}

void RegionsTool::dropStroke() {
  isStroke_ = strokeEnds_ = false;
  stroke_ = nullptr;
  dabs_.clear();
}

// One edit for the whole stroke.
void RegionsTool::endStroke() {
  isStroke_ = strokeEnds_ = false;
  std::vector<Region> all = panel_->regions();
  if (strokeOf_ >= all.size() || !stroke_)
    return;
  all[strokeOf_].mesh = stroke_->empty() ? nullptr : std::exchange(stroke_, nullptr);
  set(all, tr("Paint region"));
  constexpr int kRestMs = 1000;
  if (open_)
    rest_.start(kRestMs);
}

// While the brush rests, as far as layers; a longer run that the user started goes on.
void RegionsTool::growLayers() {
  const auto at = panel_->selected();
  const bool isBusy = work_.planning.running() && work_.planning.until() > project::Stage::Layers;
  if (!open_ || isStroke_ || isBusy || !isPainted() || !panel_->paint().growsLayers ||
      !regions::findUse(panel_->regions()[*at].use).hasLayers())
    return;
  work_.planning.plan(project::Stage::Layers);
}

} // namespace voluta::window
