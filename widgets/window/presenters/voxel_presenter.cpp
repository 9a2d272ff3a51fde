#include "window/presenters/voxel_presenter.h"

#include "curved/front_surface.h"
#include "curved/peeling_field.h"
#include "window/background.h"

namespace voluta::window {

VoxelPresenter::VoxelPresenter(viewer::Viewport& viewport, QObject* parent)
    : QObject(parent), viewport_(viewport) {
  for (auto* runner : {&voxels_, &replay_, &peeling_, &front_})
    *runner = std::make_unique<jobs::JobRunner>();
}

VoxelPresenter::~VoxelPresenter() = default;

bool VoxelPresenter::busy() const {
  return voxels_->running() || replay_->running() || peeling_->running() || front_->running();
}

void VoxelPresenter::setDecomposition(std::shared_ptr<const curved::Decomposition> decomposition,
                                      double layerHeightMm) {
  if (decomposition == decomposition_ && layerHeightMm == layerHeightMm_)
    return;
  if (decomposition != decomposition_)
    peeled_.reset();
  decomposition_ = std::move(decomposition);
  layerHeightMm_ = layerHeightMm;
  peeling_->cancel();
  front_->cancel();
  frontDrawn_.reset();
  if (decomposition_) {
    draw();
    drawFront();
    return;
  }
  voxels_->cancel();
  replay_->cancel();
  replayStale_ = true;
  drawAgain_ = replayAgain_ = false;
  layers_ = steps_ = 0;
  missed_ = 0;
  viewport_.scene().setVoxels(nullptr);
  viewport_.scene().setGrowth(nullptr);
  viewport_.scene().setFront(nullptr);
  viewport_.requestFrame();
  emit drawn();
  emit replayReady();
}

void VoxelPresenter::setColouring(scene::ColourBy colourBy) {
  if (colourBy != scene::ColourBy::GrowthStep && colourBy != scene::ColourBy::Peeling)
    colourBy = scene::ColourBy::Layer;
  if (colourBy == colourBy_)
    return;
  colourBy_ = colourBy;
  draw();
}

void VoxelPresenter::setReplayWanted(bool wanted) {
  replayWanted_ = wanted;
  if (wanted && replayStale_)
    drawReplay();
}

scene::VoxelLook VoxelPresenter::look() const {
  scene::VoxelLook look;
  look.layerHeightMm = layerHeightMm_;
  look.colourBy = colourBy_;
  look.peeling = peeled_;
  return look;
}

void VoxelPresenter::draw() {
  if (!decomposition_)
    return;
  if (colourBy_ == scene::ColourBy::Peeling && !peeled_) {
    if (!peeling_->running())
      inBackground(
          *peeling_,
          [d = decomposition_](const base::RunContext& ctx) {
            return curved::peelingField(*d, ctx);
          },
          [this](std::vector<std::int32_t>&& field) {
            peeled_ = std::make_shared<const std::vector<std::int32_t>>(std::move(field));
            draw();
          });
    return;
  }
  replayStale_ = true;
  if (replayWanted_)
    drawReplay();
  if (voxels_->running()) {
    drawAgain_ = true;
    return;
  }
  inBackground(
      *voxels_, [d = decomposition_, look = look()] { return scene::drawVoxels(*d, look); },
      [this](auto&& made) {
        viewport_.scene().setVoxels(made);
        layers_ = scene::layerCount(*made);
        missed_ = scene::missedCount(*made);
        viewport_.requestFrame();
        emit drawn();
        if (std::exchange(drawAgain_, false))
          draw();
      });
}

void VoxelPresenter::drawReplay() {
  if (!decomposition_)
    return;
  if (replay_->running()) {
    replayAgain_ = true;
    return;
  }
  replayStale_ = false;
  scene::VoxelLook bySteps = look();
  bySteps.bySteps = true;
  inBackground(
      *replay_, [d = decomposition_, bySteps] { return scene::drawVoxels(*d, bySteps); },
      [this](auto&& made) {
        viewport_.scene().setGrowth(made);
        steps_ = scene::layerCount(*made);
        viewport_.requestFrame();
        emit replayReady();
        if (std::exchange(replayAgain_, false))
          drawReplay();
      });
}

void VoxelPresenter::setFrontStep(std::optional<int> step) {
  frontWanted_ = step;
  drawFront();
}

// Draws one front at a time: restarting while a slider is dragged would never show any.
void VoxelPresenter::drawFront() {
  if (!frontWanted_ || !decomposition_ || frontWanted_ == frontDrawn_ || front_->running())
    return;
  inBackground(
      *front_,
      [d = decomposition_, step = *frontWanted_] {
        return std::pair(scene::drawFront(curved::frontSurface(*d, step)), step);
      },
      [this](auto&& made) {
        viewport_.scene().setFront(made.first);
        frontDrawn_ = made.second;
        viewport_.requestFrame();
        drawFront();
      });
}

} // namespace voluta::window
