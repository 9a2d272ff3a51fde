// Voxels on the Layers page: growth replayed step by step, and what growth missed.
#include "window/main_window.h"

#include "panels/layer_info.h"
#include "panels/pieces_panel.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"

#include <algorithm>
#include <cmath>

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kLeastRadiusMm = 30.0; // enough of the part around to know the place
// A group of n voxels is seen with as much around it: radius in widths of a cube of n voxels.
constexpr double kAroundGroup = 3.0;
} // namespace

LayerSubject MainWindow::shownSubject() const {
  const LayerSubject chosen = options_->choices().subject;
  const bool pieces = presenter_->hasPieces();
  // A mode has either voxels or pieces: what was chosen for another one says nothing.
  const bool missing =
      chosen == LayerSubject::Pieces ? !pieces : chosen == LayerSubject::Voxels && pieces;
  if (chosen != LayerSubject::Furthest && !missing)
    return chosen;
  const LayerSubject decomposed = pieces ? LayerSubject::Pieces : LayerSubject::Voxels;
  // Modes without voxels and pieces show their last layers until there are new ones.
  const bool ahead = document_.voxelsAhead() && (pieces || presenter_->hasVoxels());
  return ahead                            ? decomposed
         : document_.ahead(Stage::Layers) ? LayerSubject::Layers
         : presenter_->hasPaths()         ? LayerSubject::Paths
         : presenter_->hasLayers()        ? LayerSubject::Layers
                                          : decomposed;
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
  const bool pieces = subject == LayerSubject::Pieces;
  piecesPanel_->setVisible(pieces);
  layerInfo_->setVisible(!pieces);
  if (onPage)
    timeline_->setMode(voxels ? timeline::BarMode::Steps : timeline::BarMode::Moves);
  VoxelPresenter& presented = presenter_->voxels();
  presented.setColouring(options_->choices().colourBy);
  presented.setReplayWanted(voxels);
  const bool replayed = replaysGrowth();
  presented.setFrontStep(replayed && options_->choices().front ? std::optional(timeline_->step())
                                                               : std::nullopt);
  layers_->setEnabled(!replayed && !pieces);
  layers_->setToolTip(replayed ? tr("Growth is replayed: all layers")
                      : pieces ? tr("Pieces are shown whole")
                               : QString());
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
