#include "window/part_presenter.h"

#include "geometry/measures.h"
#include "geometry/placement.h"
#include "pipeline/choices.h"
#include "pipeline/stages.h"
#include "robot/link_meshes.h"
#include "window/background.h"

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kGroundRadiusMm = 150.0;
}

PartPresenter::PartPresenter(document::Document& document, viewer::Viewport& viewport)
    : document_(document), viewport_(viewport), drawingPart_(std::make_unique<jobs::JobRunner>()),
      drawingPlatform_(std::make_unique<jobs::JobRunner>()),
      drawingCell_(std::make_unique<jobs::JobRunner>()) {
  using document::Document;
  connect(&document, &Document::sourceChanged, this, &PartPresenter::drawSource);
  connect(&document, &Document::resultChanged, this, &PartPresenter::show);
  connect(&document, &Document::choicesChanged, this, &PartPresenter::drawPlannedPlatform);
  connect(&document, &Document::previewChanged, this, [this] {
    if (const auto& preview = document_.preview())
      drawPlatform(preview->decomposition->platform);
  });
}

PartPresenter::~PartPresenter() = default;

bool PartPresenter::busy() const {
  return drawingPart_->running() || drawingPlatform_->running() || drawingCell_->running();
}

void PartPresenter::show(Stage stage) {
  const auto result = document_.result(stage);
  if (!result) {
    drawnPart_.reset();
    drawnCell_.reset();
  } else if (stage == Stage::Load) {
    drawPart(result->job.part);
    drawPlannedPlatform();
  } else if (stage == Stage::Decompose) {
    drawnPlatform_ = {pipeline::plannedPlatformKey(result->job.choices), result->job.part};
    drawPlatform(result->job.platform);
    drawCell(result->cell);
  }
}

// The part as it was read is on show before the first stage has placed it.
void PartPresenter::drawSource() {
  const std::shared_ptr<const project::LoadedPart> source = document_.source();
  if (!source) {
    viewport_.scene().setPart(nullptr);
    box_.setEmpty();
    drawnPart_.reset();
    viewport_.requestFrame();
    emit drawn(true);
    return;
  }
  if (document_.result(Stage::Load) && document_.upToDate(Stage::Load))
    return;
  const double wanted = project::parsedScale(document_.choices().scale);
  const double unit = pipeline::unitMm(*source, document_.choices());
  const geometry::Placement placement = document_.choices().placement;
  inBackground(
      *drawingPart_,
      [source, placement, scale = unit * (wanted > 0.0 ? wanted : 1.0)] {
        geometry::TriangleMesh placed = geometry::place(*source->mesh, scale, placement);
        return std::pair(scene::drawPart(placed), geometry::bounds(placed));
      },
      [this](auto&& made) {
        drawnPart_.reset();
        swapPart(made.first, made.second);
      });
}

void PartPresenter::drawPart(const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
  if (!mesh || drawnPart_ == mesh)
    return;
  drawnPart_ = mesh;
  inBackground(
      *drawingPart_, [mesh] { return std::pair(scene::drawPart(*mesh), geometry::bounds(*mesh)); },
      [this](auto&& made) { swapPart(made.first, made.second); });
}

void PartPresenter::swapPart(const std::shared_ptr<const scene::PartDrawing>& drawing,
                             const Eigen::AlignedBox3d& box) {
  viewport_.scene().setPart(drawing);
  const bool another = box_.isEmpty() || shownSource_ != document_.source();
  shownSource_ = document_.source();
  box_ = box;
  viewport_.requestFrame();
  emit drawn(another);
}

void PartPresenter::drawPlatform(const platform::PlatformSolid& platform) {
  inBackground(
      *drawingPlatform_, [platform] { return scene::drawPlatform(platform, kGroundRadiusMm); },
      [this](auto&& made) { swapPlatform(made); });
}

// The platform's outline is on show before anything is planned: its size decides what can grow.
void PartPresenter::drawPlannedPlatform() {
  const auto placed = document_.result(Stage::Load);
  if (!placed || !document_.upToDate(Stage::Load) || document_.upToDate(Stage::Decompose))
    return;
  const project::Choices& choices = document_.choices();
  const auto wanted = std::pair(pipeline::plannedPlatformKey(choices), placed->job.part);
  if (wanted == drawnPlatform_)
    return;
  drawnPlatform_ = wanted;
  inBackground(
      *drawingPlatform_,
      [choices, stage = placed->placed] {
        return scene::drawPlatform(pipeline::plannedPlatform(*stage, choices), kGroundRadiusMm);
      },
      [this](auto&& made) { swapPlatform(made); });
}

void PartPresenter::swapPlatform(const std::shared_ptr<const scene::PlatformDrawing>& drawing) {
  viewport_.scene().setPlatform(drawing);
  viewport_.requestFrame();
}

void PartPresenter::setCollisionSolids(bool on) {
  if (std::exchange(collisionSolids_, on) != on)
    drawCell(std::exchange(drawnCell_, nullptr));
}

void PartPresenter::drawCell(const std::shared_ptr<const robot::Cell>& cell) {
  if (!cell || drawnCell_ == cell)
    return;
  drawnCell_ = cell;
  inBackground(
      *drawingCell_,
      [cell, solids = collisionSolids_] {
        return scene::drawCell(*cell, solids ? std::vector<robot::LinkMesh>()
                                             : robot::linkMeshesOf(cell->robot().id));
      },
      [this](auto&& made) {
        viewport_.scene().setCell(made);
        viewport_.requestFrame();
      });
}

} // namespace voluta::window
