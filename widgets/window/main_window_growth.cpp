// Voxels on the Layers page: growth replayed step by step, and what growth missed.
#include "window/main_window.h"

#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"

#include <algorithm>
#include <cmath>

namespace voluta::window {

using pipeline::Stage;

namespace {
constexpr double kLeastRadiusMm = 30.0; // enough of the part around to know the place
// A group of n voxels is seen with as much around it: radius in widths of a cube of n voxels.
constexpr double kAroundGroup = 3.0;
} // namespace

LayerSubject MainWindow::shownSubject() const {
  const LayerSubject chosen = options_->choices().subject;
  if (chosen != LayerSubject::Furthest)
    return chosen;
  return document_.voxelsAhead()          ? LayerSubject::Voxels
         : document_.ahead(Stage::Layers) ? LayerSubject::Layers
         : presenter_->hasPaths()         ? LayerSubject::Paths
         : presenter_->hasLayers()        ? LayerSubject::Layers
                                          : LayerSubject::Voxels;
}

bool MainWindow::replaysGrowth() const {
  return page() == Page::Layers && shownSubject() == LayerSubject::Voxels &&
         presenter_->voxels().steps() > 0 && timeline_->step() < timeline_->stepCount();
}

// The bar under the viewport and the layer slider serve what is on show.
void MainWindow::showGrowth() {
  const LayerSubject subject = shownSubject();
  const bool onPage = page() == Page::Layers, voxels = onPage && subject == LayerSubject::Voxels;
  options_->setShown(subject);
  if (onPage)
    timeline_->setMode(voxels ? timeline::BarMode::Steps : timeline::BarMode::Moves);
  VoxelPresenter& presented = presenter_->voxels();
  presented.setColouring(options_->choices().colourBy);
  presented.setReplayWanted(voxels);
  const bool replayed = replaysGrowth();
  presented.setFrontStep(replayed && options_->choices().front ? std::optional(timeline_->step())
                                                               : std::nullopt);
  layers_->setEnabled(!replayed);
  layers_->setToolTip(replayed ? tr("Growth is replayed: all layers") : QString());
}

void MainWindow::connectGrowth() {
  connect(&presenter_->voxels(), &VoxelPresenter::replayReady, this, [this] {
    timeline_->setStepCount(presenter_->voxels().steps());
    showView();
  });
  connect(timeline_, &timeline::TimelineBar::stepChanged, this, [this] {
    lookingAtMissed_ = false;
    showView();
  });
}

bool MainWindow::lookAtMissed(const plan::Finding& finding) {
  const VoxelPresenter& presented = presenter_->voxels();
  if (finding.stage != "decompose" || !finding.where || presented.missed() == 0)
    return false;
  ViewChoices choices = options_->choices();
  choices.subject = LayerSubject::Voxels;
  options_->setChoices(choices);
  timeline_->setStep(timeline_->stepCount());
  layers_->setRange(0, std::max(0, layers_->layerCount() - 1));
  lookingAtMissed_ = true;
  showView();
  const double group =
      std::cbrt(static_cast<double>(finding.count)) * presented.pitchMm() * kAroundGroup;
  viewport_->lookAt(*finding.where, std::max(kLeastRadiusMm, group));
  return true;
}

} // namespace voluta::window
