#include "window/presenters/part_presenter.h"

#include "curved/decomposition.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "modes/mode_stages.h"
#include "pipeline/cell_reach.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "robot/shape/arm_look.h"
#include "window/background.h"

#include <algorithm>

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kGroundRadiusMm = 150.0;

Eigen::Vector3d sizeOf(const platform::PlatformSolid& platform) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector2d& corner : platform.polygon)
    box.extend(Eigen::Vector3d(corner.x(), corner.y(), 0.0));
  if (platform.mesh)
    box.extend(geometry::bounds(*platform.mesh));
  return box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.sizes().eval();
}

std::pair<std::shared_ptr<const scene::PlatformDrawing>, Eigen::Vector3d>
drawingOf(const platform::PlatformSolid& platform) {
  return {scene::drawPlatform(platform, kGroundRadiusMm), sizeOf(platform)};
}
} // namespace

PartPresenter::PartPresenter(document::Document& document, viewer::Viewport& viewport)
    : document_(document), viewport_(viewport), drawingPart_(std::make_unique<jobs::JobRunner>()),
      drawingPlatform_(std::make_unique<jobs::JobRunner>()),
      drawingCell_(std::make_unique<jobs::JobRunner>()),
      drawingChosenCell_(std::make_unique<jobs::JobRunner>()), plate_(document, viewport) {
  using document::Document;
  connect(&document, &Document::sourceChanged, this, &PartPresenter::drawSource);
  connect(&document, &Document::resultChanged, this, &PartPresenter::show);
  connect(&document, &Document::partsChanged, this, &PartPresenter::showActive);
  connect(&plate_, &PlateParts::drawn, this, [this] {
    const bool another = framesAnew(std::exchange(drawnSources_, document_.sources()));
    emit drawn(another && !box_.isEmpty());
  });
  connect(&document, &Document::choicesChanged, this, &PartPresenter::drawPlannedPlatform);
  connect(&document, &Document::choicesChanged, this, &PartPresenter::drawChosenCell);
  connect(&document, &Document::sourceChanged, this, &PartPresenter::drawChosenCell);
  connect(&document, &Document::previewChanged, this, [this] {
    if (const auto& preview = document_.preview())
      drawPlatform(preview->decomposition->platform);
  });
  drawChosenCell();
}

PartPresenter::~PartPresenter() = default;

bool PartPresenter::busy() const {
  return drawingPart_->running() || drawingPlatform_->running() || drawingCell_->running() ||
         drawingChosenCell_->running() || plate_.busy();
}

void PartPresenter::showActive() {
  plate_.update();
  if (document_.partCount() < 2)
    return;
  const auto placed = document_.itemResult(Stage::Load);
  if (!placed)
    drawSource();
  else
    drawPart(placed->job.item().part);
}

PartPresenter::PlatformKey PartPresenter::platformKeyOf(const project::Choices& choices,
                                                        const project::Job& job) {
  PlatformKey key;
  for (std::size_t i = 0; i < job.items.size(); ++i)
    key.emplace_back(pipeline::plannedPlatformKey(pipeline::resolve(project::onlyItem(choices, i))),
                     job.item(i).part);
  return key;
}

void PartPresenter::show(Stage stage) {
  const auto result = document_.result(stage);
  if (!result) {
    drawnPart_.reset();
    drawnCell_.reset();
    swapCell(CellOf::Plan, nullptr);
  } else if (stage == Stage::Load) {
    plate_.update();
    drawPart(document_.itemResult(stage)->job.item().part);
    drawPlannedPlatform();
    drawChosenCell();
  } else if (stage == Stage::Decompose) {
    drawnPlatform_ = platformKeyOf(result->job.choices, result->job);
    drawPlatform(project::platformOf(result->job));
    drawCell(result->cell);
  }
}

// Shows the active part as read until the first stage has placed it.
void PartPresenter::drawSource() {
  const std::shared_ptr<const project::LoadedPart> source = document_.source();
  if (!source) {
    clear();
    return;
  }
  if (document_.result(Stage::Load) && document_.upToDate(Stage::Load))
    return;
  const double wanted = project::parsedScale(document_.choices().item().scale);
  const double unit = pipeline::unitMm(*source, document_.choices());
  const geometry::Placement placement = document_.choices().item().placement;
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

// Cancel drawings in progress, so that they do not appear in an empty project.
void PartPresenter::clear() {
  for (const auto* runner : {&drawingPart_, &drawingPlatform_, &drawingCell_})
    (*runner)->cancel();
  viewport_.scene().setPart(nullptr);
  viewport_.scene().setPlatform(nullptr);
  box_.setEmpty();
  shownSources_.clear();
  drawnPart_.reset();
  drawnPlatform_ = {};
  drawnCell_.reset();
  swapCell(CellOf::Plan, nullptr);
  viewport_.requestFrame();
  emit drawn(true);
}

void PartPresenter::drawPart(const std::shared_ptr<const geometry::TriangleMesh>& mesh) {
  if (!mesh || drawnPart_ == mesh)
    return;
  drawnPart_ = mesh;
  if (const auto drawing = plate_.drawingOf(mesh.get())) {
    drawingPart_->cancel();
    swapPart(drawing, geometry::bounds(*mesh));
    return;
  }
  inBackground(
      *drawingPart_, [mesh] { return std::pair(scene::drawPart(*mesh), geometry::bounds(*mesh)); },
      [this](auto&& made) { swapPart(made.first, made.second); });
}

bool PartPresenter::framesAnew(const Sources& before) const {
  const Sources now = document_.sources();
  const bool anyLeft = std::ranges::any_of(
      before, [&](const auto& part) { return std::ranges::find(now, part) != now.end(); });
  return now != before && (!anyLeft || !viewport_.isCameraTheUsers());
}

void PartPresenter::swapPart(const std::shared_ptr<const scene::PartDrawing>& drawing,
                             const Eigen::AlignedBox3d& box) {
  viewport_.scene().setPart(drawing);
  const bool another =
      framesAnew(std::exchange(shownSources_, document_.sources())) || box_.isEmpty();
  box_ = box;
  viewport_.requestFrame();
  emit drawn(another);
}

void PartPresenter::drawPlatform(const platform::PlatformSolid& platform) {
  inBackground(
      *drawingPlatform_, [platform] { return drawingOf(platform); },
      [this](auto&& made) { swapPlatform(made.first, made.second); });
}

// Shows the platform before anything is planned, since its size determines what can grow.
void PartPresenter::drawPlannedPlatform() {
  const auto placed = document_.result(Stage::Load);
  if (!placed || !document_.upToDate(Stage::Load) || document_.upToDate(Stage::Decompose))
    return;
  const project::Choices& choices = document_.jobChoices();
  PlatformKey wanted;
  try {
    wanted = platformKeyOf(choices, placed->job);
  } catch (const base::Error&) {
    return; // Planning reports it
  }
  if (wanted == drawnPlatform_)
    return;
  drawnPlatform_ = wanted;
  inBackground(
      *drawingPlatform_,
      [choices, placed] {
        project::Job job = placed->job;
        for (std::size_t i = 0; i < job.items.size(); ++i)
          job.item(i).platform = pipeline::plannedPlatform(
              *placed->item(i).placed, pipeline::resolve(project::onlyItem(choices, i)));
        return drawingOf(project::platformOf(job));
      },
      [this](auto&& made) { swapPlatform(made.first, made.second); });
}

void PartPresenter::swapPlatform(const std::shared_ptr<const scene::PlatformDrawing>& drawing,
                                 const Eigen::Vector3d& sizeMm) {
  viewport_.scene().setPlatform(drawing);
  viewport_.requestFrame();
  emit platformDrawn(sizeMm);
}

void PartPresenter::drawCell(const std::shared_ptr<const robot::Cell>& cell) {
  if (!cell || drawnCell_ == cell)
    return;
  drawnCell_ = cell;
  inBackground(
      *drawingCell_, [cell] { return scene::drawCell(*cell, robot::lookOf(cell->robot())); },
      [this](auto&& made) { swapCell(CellOf::Plan, made); });
}

// Returns the last placed part, for which a plate of the chosen cell is selected. The plate stays
// while an edit places the part again. Null: nothing was placed in that cell.
std::shared_ptr<const pipeline::PlanResult> PartPresenter::placedForCell() const {
  const auto placed = document_.result(Stage::Load);
  const project::Choices& now = document_.jobChoices();
  const bool sameCell = placed && placed->job.choices.cell == now.cell &&
                        placed->job.choices.item().mode == now.item().mode;
  return sameCell || document_.upToDate(Stage::Load) ? placed : nullptr;
}

// Shows the machine before anything is planned. A cell that cannot be read is not drawn; planning
// reports its error.
void PartPresenter::drawChosenCell() {
  const project::Choices& choices = document_.jobChoices();
  const auto placed = placedForCell();
  std::pair<std::string, std::shared_ptr<const geometry::TriangleMesh>> wanted;
  try {
    const pipeline::Resolved now = pipeline::resolve(choices);
    wanted = {pipeline::cellReachKey(now, 0.0) + pipeline::plannedPlatformKey(now),
              placed ? placed->job.item().part : nullptr};
  } catch (const base::Error&) {
    chosenCell_ = {};
    drawingChosenCell_->cancel();
    swapCell(CellOf::Choices, nullptr);
    return;
  }
  if (wanted == chosenCell_)
    return;
  chosenCell_ = wanted;
  inBackground(
      *drawingChosenCell_,
      [choices, stage = placed ? placed->item().placed : nullptr]() {
        std::shared_ptr<const scene::CellDrawing> drawing;
        try {
          const pipeline::Resolved now = pipeline::resolve(choices);
          const robot::Cell cell = stage ? robot::loadCell(choices.cell, now.process(),
                                                           pipeline::plannedPlatform(*stage, now))
                                         : pipeline::cellToMap(choices, now.process());
          drawing = scene::drawCell(cell, robot::lookOf(cell.robot()));
        } catch (const base::Error&) {
        }
        return drawing;
      },
      [this](auto&& made) { swapCell(CellOf::Choices, made); });
}

void PartPresenter::swapCell(CellOf which, std::shared_ptr<const scene::CellDrawing> drawing) {
  cells_[static_cast<std::size_t>(which)] = std::move(drawing);
  if (which != shownCell_)
    return;
  viewport_.scene().setCell(cells_[static_cast<std::size_t>(which)]);
  viewport_.requestFrame();
  emit cellDrawn();
  if (which == CellOf::Choices && box_.isEmpty())
    emit drawn(true);
}

void PartPresenter::showCell(CellOf which) {
  if (std::exchange(shownCell_, which) != which)
    viewport_.scene().setCell(cells_[static_cast<std::size_t>(which)]);
}

} // namespace voluta::window
