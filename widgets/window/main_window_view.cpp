// The picture: what a page shows in the viewport, and how findings and handles move it.
#include "window/main_window.h"

#include "geometry/placement.h"
#include "modes/mode_table.h"
#include "panels/export_panel.h"
#include "panels/pieces_panel.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/legend_view.h"
#include "window/program_preview.h"

#include <algorithm>
#include <limits>

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kFindingRadiusMm = 15.0;
} // namespace

bool MainWindow::shows(panels::SceneItem item) const {
  return tree_->isShown(item);
}

scene::ViewState MainWindow::viewState() const {
  using panels::SceneItem;
  scene::ViewState v;
  const ViewChoices& chosen = options_->choices();
  v.platform = shows(SceneItem::Platform);
  v.marker = marker_;
  v.pieceNumbers = piecesPanel_->numbers();
  v.colourBy = chosen.colourBy;
  v.beads = chosen.beads;
  v.sectionOn = chosen.section && !presenter_->partBox().isEmpty();
  if (v.sectionOn) {
    const Eigen::AlignedBox3d& box = presenter_->partBox();
    v.sectionNormal =
        (chosen.sectionFlipped ? -1.0 : 1.0) * Eigen::Vector3d::Unit(chosen.sectionAxis);
    v.sectionOrigin = box.min() + chosen.sectionPlace * box.sizes();
  }
  switch (page()) {
  case Page::Prepare:
    // While the part is handled it is in sight itself.
    v.voxels = document_.voxelsAhead() && document_.voxelsInPlace() && presenter_->hasVoxels() &&
               viewport_->tool() == viewer::Tool::None && shows(SceneItem::Part);
    v.pieces = document_.voxelsAhead() && document_.voxelsInPlace() && presenter_->hasPieces() &&
               viewport_->tool() == viewer::Tool::None && shows(SceneItem::Part);
    v.part = !v.voxels && !v.pieces && shows(SceneItem::Part);
    v.cell = false;
    break;
  case Page::Layers: {
    const LayerSubject subject = shownSubject();
    v.voxels = subject == LayerSubject::Voxels && presenter_->hasVoxels();
    v.layers = subject == LayerSubject::Layers && presenter_->hasLayers();
    v.paths = subject == LayerSubject::Paths && presenter_->hasPaths();
    v.pieces = subject == LayerSubject::Pieces && presenter_->hasPieces();
    if (v.pieces) {
      v.explodeMm = explodeMm();
      v.basePlanes = piecesPanel_->basePlanes();
      if (piecesPanel_->selected() >= 0)
        v.piece = static_cast<std::size_t>(piecesPanel_->selected());
      v.moved_T_base = movedBase();
    }
    const bool planned = v.voxels || v.pieces || v.layers || v.paths;
    v.part = (chosen.part && shows(SceneItem::Part)) || !planned;
    v.partOpacity = planned ? 0.25 : 1.0;
    v.travels = chosen.travels;
    v.firstLayer = layers_->first();
    v.lastLayer = layers_->layerCount() > 0 ? layers_->last() : scene::kAllLayers;
    v.seeThrough = lookingAtMissed_;
    if (replaysGrowth()) {
      v.growthStep = timeline_->step();
      v.front = chosen.front;
      v.ghosts = chosen.ghosts;
    }
    if (v.paths && timeline_->move() < presenter_->movesOf(layers_->last()))
      v.moves = static_cast<std::size_t>(timeline_->move());
    break;
  }
  case Page::Compare:
    break;
  case Page::Simulate:
  case Page::Export:
    v.part = false;
    v.sectionOn = false;
    v.paths = presenter_->hasPaths() && shows(SceneItem::Part);
    v.materialColour = true;
    if (const auto& clock = presenter_->clock(); clock && !clock->empty()) {
      v.world = scene::World::Base;
      v.cell = shows(SceneItem::Cell);
      const auto role = [&](robot::BodyRole r) -> bool& {
        return v.roles[static_cast<std::size_t>(r)];
      };
      role(robot::BodyRole::Link) = shows(SceneItem::Robot);
      role(robot::BodyRole::Head) = role(robot::BodyRole::Holder) = shows(SceneItem::Nozzle);
      role(robot::BodyRole::Platform) = shows(SceneItem::Plate);
      v.joints = clock->jointsAt(timeline_->timeS());
      v.printedWaypoints = clock->printedWaypoints(timeline_->timeS());
    } else {
      v.part = shows(SceneItem::Part) && !v.paths;
    }
    break;
  }
  showChosen(v);
  return v;
}

void MainWindow::showView() {
  showGrowth();
  viewport_->setView(viewState());
  showUnrolled();
  showCutHandles();
  legend_->setLegend(page() == Page::Layers || viewport_->view().voxels || viewport_->view().pieces
                         ? viewport_->scene().legend()
                         : scene::Legend{});
}

void MainWindow::showMoves() {
  if (page() == Page::Layers)
    timeline_->setMoveCount(presenter_->movesOf(layers_->last()));
}

void MainWindow::setTime(double timeS) {
  timeline_->setTimeS(timeS);
  plots_->setTimeS(timeS);
  if (page() == Page::Export && presenter_->clock())
    if (const auto line = preview_->lineAt(*presenter_->clock(), timeS))
      export_->showLine(line->file, line->line);
  if (page() == Page::Simulate || page() == Page::Export)
    showView();
}

void MainWindow::goTo(const plan::Finding& finding) {
  marker_ = finding.where;
  const auto& clock = presenter_->clock();
  const bool motion = finding.stage == "motion" || finding.stage == "replay";
  if (finding.whenS && clock) {
    setPage(Page::Simulate);
    setTime(*finding.whenS);
  } else if (motion && clock) {
    setPage(Page::Simulate);
  } else if (finding.stage == "load") {
    setPage(Page::Prepare);
  } else {
    setPage(Page::Layers);
  }
  if (lookAtMissed(finding) || lookAtPieces(finding))
    return;
  if (finding.where && page() == Page::Layers)
    if (const auto plan = document_.result(Stage::Toolpath);
        plan && plan->job.toolPlan && presenter_->hasPaths()) {
      // The layer whose bead passes nearest.
      double best = std::numeric_limits<double>::infinity();
      int layer = 0;
      for (const plan::ToolPath& path : plan->job.toolPlan->paths)
        for (std::size_t i = path.first; i < path.first + path.count; ++i)
          if (const double d = (plan->job.toolPlan->position[i] - *finding.where).squaredNorm();
              d < best) {
            best = d;
            layer = path.layer;
          }
      layers_->setRange(0, layer);
    }
  showView();
  if (finding.where)
    viewport_->lookAt(*finding.where, kFindingRadiusMm);
}

void MainWindow::setTool(viewer::Tool tool) {
  viewport_->setTool(document_.source() ? tool : viewer::Tool::None);
}

void MainWindow::applyGizmo(const viewer::GizmoChange& change, bool finished) {
  const Eigen::Vector3d centre = presenter_->partBox().isEmpty() ? Eigen::Vector3d::Zero().eval()
                                                                 : presenter_->partBox().center();
  Eigen::Affine3d preview = Eigen::Affine3d::Identity();
  preview.translate(centre + change.moveMm).rotate(change.turn).scale(change.scale);
  preview.translate(-centre);
  viewport_->scene().setPartPreview(preview);
  viewport_->requestFrame();
  if (!finished)
    return;
  geometry::Placement placement = placedBeforeGizmo_;
  placement.centreMm += change.moveMm.head<2>();
  placement.liftMm += change.moveMm.z();
  if (!modes::findMode(document_.choices().mode).aroundRod)
    placement.liftMm = std::max(0.0, placement.liftMm);
  placement.rotation = (change.turn * placement.rotation).normalized();
  switch (viewport_->tool()) {
  case viewer::Tool::Move:
    document_.place(placement, tr("move"));
    break;
  case viewer::Tool::Turn:
    document_.place(placement, tr("turn"));
    break;
  case viewer::Tool::Scale:
    if (change.scale != 1.0)
      document_.setScale(QString::number(scaleBeforeGizmo_ * change.scale, 'g', 6));
    break;
  default:
    break;
  }
  // A drag that came to nothing leaves no new drawing that would take the preview's place.
  if (document_.upToDate(Stage::Load))
    viewport_->scene().setPartPreview(Eigen::Affine3d::Identity());
}

geometry::Placement MainWindow::placed() const {
  const geometry::Placement& own = document_.choices().placement;
  return Presenter::isUntouched(own) && document_.upToDate(Stage::Load) &&
                 !presenter_->partBox().isEmpty()
             ? presenter_->placement()
             : own;
}

void MainWindow::placeOnFace(const Eigen::Vector3d& normal) {
  if (normal.norm() < 0.5)
    return;
  geometry::Placement placement = placed();
  placement.rotation = geometry::rotationLayingFlat(normal) * placement.rotation;
  placement.liftMm = 0.0;
  document_.place(placement, tr("lay on face"));
}

} // namespace voluta::window
