#include "window/pages/layers_page.h"

#include "base/error.h"
#include "document/document.h"
#include "panels/layer_info.h"
#include "panels/object_tree.h"
#include "panels/pieces_panel.h"
#include "plan/finding_kinds.h"
#include "timeline/layer_range_slider.h"
#include "window/pages/layer_event_edits.h"
#include "window/picture.h"
#include "window/presenters/presenter.h"
#include "window/spacing_view.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kMinRadiusMm = 30.0; // shows enough of the surroundings to recognise the place
// View radius around a group of n voxels, in widths of a cube of n voxels.
constexpr double kAroundGroup = 3.0;
constexpr double kPartOpacity = 0.25; // over the planned results

// Returns the layer of the nearest bead.
int nearestLayer(const plan::ToolPlan& plan, const Eigen::Vector3d& place) {
  double best = std::numeric_limits<double>::infinity();
  int layer = 0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      if (const double d = (plan.position[i] - place).squaredNorm(); d < best) {
        best = d;
        layer = path.layer;
      }
  return layer;
}
} // namespace

LayersPage::LayersPage(const Workspace& workspace)
    : Page({"layers", QT_TRANSLATE_NOOP("Commands", "&Layers")}, workspace),
      pieces_(workspace, [this] { return isShown() && subject() == LayerSubject::Pieces; }),
      options_(new ViewOptions), info_(new panels::LayerInfo), addEvent_(new QPushButton),
      spacing_(new SpacingView) {
  build();
  listenToBars();
  listenToDrawings();
}

void LayersPage::build() {
  options_->setObjectName("viewOptions");
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(0, 0, 0, 0);
  for (QWidget* panel : {static_cast<QWidget*>(options_), static_cast<QWidget*>(pieces_.panel()),
                         static_cast<QWidget*>(info_)})
    column->addWidget(panel);
  addEvent_->setObjectName("layersAddEvent");
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 8, 0);
  row->addWidget(addEvent_);
  column->addLayout(row);
  column->addWidget(spacing_);
  column->addStretch(1);
  side_ = scrolled(content);
}

void LayersPage::listenToBars() {
  connect(options_, &ViewOptions::changed, this, [this] {
    lookElsewhere();
    work().picture.setLook(options_->look());
    showCount();
  });
  connect(options_, &ViewOptions::dragging, &work().viewport, &viewer::Viewport::setDragging);
  connect(&work().picture, &Picture::lookChanged, this,
          [this] { options_->setLook(work().picture.look()); });
  timeline::LayerRangeSlider& layers = work().layers;
  connect(&layers, &timeline::LayerRangeSlider::rangeChanged, this, [this] {
    lookElsewhere();
    showMoves();
    work().shell.showView();
    showMeasures(work().layers.last());
  });
  connect(&layers, &timeline::LayerRangeSlider::pauseWished, this,
          [this](int layer, bool pause) { setPause(work(), layer, pause); });
  connect(addEvent_, &QPushButton::clicked, this,
          [this] { askForEvent(work(), work().layers.last(), side_->window()); });
  connect(&work().document, &document::Document::choicesChanged, this, &LayersPage::showPauses);
  using timeline::TimelineBar;
  connect(&work().timeline, &TimelineBar::moveChanged, this, [this] { work().shell.showView(); });
  connect(&work().timeline, &TimelineBar::stepChanged, this, [this] {
    lookElsewhere();
    work().shell.showView();
  });
  connect(&work().timeline, &TimelineBar::layerStepRequested, this, [this](int step) {
    timeline::LayerRangeSlider& slider = work().layers;
    const int last = std::clamp(slider.last() + step, 0, std::max(0, slider.layerCount() - 1));
    slider.setRange(slider.single() ? last : std::min(slider.first(), last), last);
  });
}

void LayersPage::listenToDrawings() {
  Presenter& presenter = work().presenter;
  for (const auto drawn : {&Presenter::voxelsDrawn, &Presenter::layersDrawn, &Presenter::pathsDrawn,
                           &Presenter::factsReady})
    connect(&presenter, drawn, this, &LayersPage::showCount);
  connect(&presenter.pieces(), &PiecesPresenter::drawn, this, &LayersPage::showCount);
  connect(&presenter.voxels(), &VoxelPresenter::replayReady, this, [this] {
    work().timeline.setStepCount(work().presenter.voxels().steps());
    work().shell.showView();
  });
  connect(&work().document, &document::Document::stateChanged, this, [this] {
    const document::Document& document = work().document;
    const std::array<bool, 3> now{document.voxelsAhead(), document.voxelsInPlace(),
                                  document.ahead(Stage::Layers)};
    if (std::exchange(newest_, now) != now)
      showCount();
  });
}

std::vector<Stage> LayersPage::stages() const {
  return {Stage::Decompose, Stage::Layers, Stage::Toolpath};
}

void LayersPage::entered() {
  lookingAtMissed_ = false;
  showCount();
}

void LayersPage::left() {
  work().viewport.setTool(viewer::Tool::None);
  pieces_.showHandles();
  VoxelPresenter& voxels = work().presenter.voxels();
  voxels.setReplayWanted(false);
  voxels.setFrontStep(std::nullopt);
}

LayerSubject LayersPage::subject() const {
  const LayerSubject chosen = options_->choices().subject;
  const Presenter& presenter = work().presenter;
  const bool pieces = presenter.hasPieces();
  // A mode has either voxels or pieces, so a choice made for another mode may not apply.
  const bool missing =
      chosen == LayerSubject::Pieces ? !pieces : chosen == LayerSubject::Voxels && pieces;
  if (chosen != LayerSubject::Furthest && !missing)
    return chosen;
  const LayerSubject decomposed = pieces ? LayerSubject::Pieces : LayerSubject::Voxels;
  // Modes without voxels and pieces keep showing the previous layers until there are new ones.
  const bool ahead = work().document.voxelsAhead() && (pieces || presenter.hasVoxels());
  return ahead                                  ? decomposed
         : work().document.ahead(Stage::Layers) ? LayerSubject::Layers
         : presenter.hasPaths()                 ? LayerSubject::Paths
         : presenter.hasLayers()                ? LayerSubject::Layers
                                                : decomposed;
}

void LayersPage::choose(LayerSubject subject) {
  ViewChoices choices = options_->choices();
  choices.subject = subject;
  options_->setChoices(choices);
  showCount();
}

// Ends looking at a finding's place.
void LayersPage::lookElsewhere() {
  lookingAtMissed_ = false;
  work().picture.setMarker(std::nullopt);
}

int LayersPage::layerCount() const {
  const Presenter& presenter = work().presenter;
  switch (subject()) {
  case LayerSubject::Paths:
    return presenter.pathLayers();
  case LayerSubject::Layers:
    return presenter.patchLayers();
  default:
    return presenter.voxelLayers();
  }
}

std::shared_ptr<const LayerFacts> LayersPage::facts() const {
  const auto known = work().presenter.facts();
  if (!known)
    return nullptr;
  const document::Document& document = work().document;
  const auto layers = document.result(Stage::Layers), paths = document.result(Stage::Toolpath);
  const auto made = document.result(Stage::Decompose);
  const bool ofThese = layers && layersOf(layers->job) == known->of;
  switch (subject()) {
  case LayerSubject::Paths:
    return paths && layersOf(paths->job) == known->of ? known : nullptr;
  case LayerSubject::Layers:
    return ofThese ? known : nullptr;
  default:
    // Only the voxels of the active part are shown.
    return ofThese && made && known->of.stacks.size() == 1 && !document.voxelsAhead() &&
                   made->job.item().decomposition() == layers->job.item().decomposition()
               ? known
               : nullptr;
  }
}

bool LayersPage::replaysGrowth() const {
  return subject() == LayerSubject::Voxels && work().presenter.voxels().steps() > 0 &&
         work().timeline.step() < work().timeline.stepCount();
}

// The bar below the viewport and the layer slider control the shown subject.
void LayersPage::showGrowth(LayerSubject subject) {
  const bool voxels = subject == LayerSubject::Voxels, pieces = subject == LayerSubject::Pieces;
  options_->setShown(subject);
  pieces_.panel()->setVisible(pieces);
  info_->setVisible(!pieces);
  work().timeline.setMode(voxels ? timeline::BarMode::Steps : timeline::BarMode::Moves);
  VoxelPresenter& presented = work().presenter.voxels();
  presented.setColouring(work().picture.look().colourBy);
  presented.setReplayWanted(voxels);
  const bool replayed = replaysGrowth();
  presented.setFrontStep(
      replayed && options_->choices().front ? std::optional(work().timeline.step()) : std::nullopt);
  work().layers.setEnabled(!replayed && !pieces);
  work().layers.setToolTip(replayed ? tr("Replaying growth: all layers shown")
                           : pieces ? tr("Pieces are always shown whole")
                                    : QString());
}

void LayersPage::draw(scene::ViewState& view) {
  const LayerSubject shown = subject();
  showGrowth(shown);
  const Presenter& presenter = work().presenter;
  const ViewChoices& chosen = options_->choices();
  const timeline::LayerRangeSlider& layers = work().layers;
  view.voxels = shown == LayerSubject::Voxels && presenter.hasVoxels();
  view.layers = shown == LayerSubject::Layers && presenter.hasLayers();
  view.paths = shown == LayerSubject::Paths && presenter.hasPaths();
  view.pieces = shown == LayerSubject::Pieces && presenter.hasPieces();
  if (view.pieces)
    pieces_.draw(view);
  const bool planned = view.voxels || view.pieces || view.layers || view.paths;
  view.part = (chosen.part && work().tree.isShown(panels::SceneItem::Part)) || !planned;
  view.partOpacity = planned ? kPartOpacity : 1.0;
  // Only the active part has its voxels or pieces drawn.
  const bool ofOnePart = view.voxels || view.pieces;
  view.otherParts = ofOnePart ? work().tree.isShown(panels::SceneItem::Part) : view.part;
  view.otherPartsOpacity = ofOnePart ? 1.0 : view.partOpacity;
  view.travels = chosen.travels;
  view.firstLayer = layers.first();
  view.lastLayer = layers.layerCount() > 0 ? layers.last() : scene::kAllLayers;
  view.seeThrough = lookingAtMissed_;
  if (replaysGrowth()) {
    view.growthStep = work().timeline.step();
    view.front = chosen.front;
    view.ghosts = chosen.ghosts;
  }
  if (view.paths && work().timeline.move() < presenter.movesOf(layers.last()))
    view.moves = static_cast<std::size_t>(work().timeline.move());
}

std::optional<PrintProgress> LayersPage::printProgress() const {
  const int layer = work().layers.last();
  const auto& moves = work().presenter.waypointsOf(layer);
  const int move = work().timeline.move();
  const bool partly = planOfLayers(work().document) &&
                      work().timeline.mode() == timeline::BarMode::Moves &&
                      move < static_cast<int>(moves.size());
  return PrintProgress{layer, partly ? moves[static_cast<std::size_t>(move)] : kAllPrinted};
}

void LayersPage::goToWaypoint(const plan::ToolPath& path, std::size_t waypoint) {
  timeline::LayerRangeSlider& layers = work().layers;
  layers.setRange(layers.single() ? path.layer : std::min(layers.first(), path.layer), path.layer);
  const auto& moves = work().presenter.waypointsOf(path.layer);
  const auto at = std::find(moves.begin(), moves.end(), waypoint);
  work().timeline.setMove(static_cast<int>(at - moves.begin()) + 1);
}

bool LayersPage::goTo(const plan::Finding& finding) {
  lookingAtMissed_ = false;
  if (lookAtMissed(finding))
    return true;
  if (pieces_.concerns(finding)) {
    choose(LayerSubject::Pieces);
    pieces_.lookAt(finding);
    return true;
  }
  const auto result = work().document.result(Stage::Toolpath);
  if (finding.where && result && result->job.toolPlan && work().presenter.hasPaths())
    work().layers.setRange(0, nearestLayer(*result->job.toolPlan, *finding.where));
  return false;
}

// Flies to a group of missed voxels and makes the others transparent. Returns false if the finding
// is not about one.
bool LayersPage::lookAtMissed(const plan::Finding& finding) {
  const VoxelPresenter& presented = work().presenter.voxels();
  if (plan::stageOf(finding) != Stage::Decompose || !finding.where || presented.missed() == 0)
    return false;
  choose(LayerSubject::Voxels);
  work().timeline.setStep(work().timeline.stepCount());
  work().layers.setRange(0, std::max(0, work().layers.layerCount() - 1));
  lookingAtMissed_ = true;
  work().shell.showView();
  const double group =
      std::cbrt(static_cast<double>(finding.count)) * presented.pitchMm() * kAroundGroup;
  work().viewport.lookAt(*finding.where, std::max(kMinRadiusMm, group));
  return true;
}

void LayersPage::clicked(const std::optional<scene::Hit>& hit) {
  if (hit && hit->what == scene::Hit::What::OtherPart && hit->item < work().document.partCount()) {
    work().document.setActive(hit->item);
    return;
  }
  if (work().viewport.tool() == viewer::Tool::PickPoint || subject() == LayerSubject::Pieces)
    return; // pieces_ handles the click
  work().shell.chooseWaypoint(
      hit && hit->what == scene::Hit::What::Path ? std::optional(hit->waypoint) : std::nullopt);
}

void LayersPage::hovered(const std::optional<scene::Hit>& hit) {
  showMeasures(hit && hit->layer >= 0 ? hit->layer : work().layers.last());
}

void LayersPage::showCount() {
  const Presenter& presenter = work().presenter;
  const auto facts = this->facts();
  const int count = layerCount();
  spacing_->setSpacing(facts ? facts->spacing : LayerSpacing{});
  const document::Document& document = work().document;
  const bool regions = std::ranges::any_of(document.jobChoices().items,
                                           [](const auto& item) { return !item.regions.empty(); });
  options_->setSeveral(document.partCount() > 1, document.choices().tools.size() > 1, regions);
  options_->setAvailable(presenter.hasVoxels(), presenter.hasPieces(), presenter.hasLayers(),
                         presenter.hasPaths());
  const bool known = facts && static_cast<int>(facts->topsMm.size()) == count;
  work().layers.setLayers(count, known ? facts->topsMm : std::vector<double>{},
                          facts && facts->radii);
  showPauses();
  showMoves();
  work().shell.showView();
  showMeasures(work().layers.last());
}

// Layers of voxels are not those of the paths.
void LayersPage::showPauses() {
  const bool ofPaths = subject() == LayerSubject::Paths || subject() == LayerSubject::Layers;
  addEvent_->setVisible(ofPaths && work().layers.layerCount() > 0);
  work().layers.setPauses(ofPaths ? pausedLayers(work()) : std::vector<int>{}, ofPaths);
  work().layers.setEvents(ofPaths ? eventLayers(work()) : std::vector<int>{});
}

void LayersPage::retranslate() {
  addEvent_->setText(tr("Event before this layer…"));
  addEvent_->setToolTip(tr("A pause, a wait, an output, another tool or a line of your own"));
}

void LayersPage::showMoves() {
  if (!isShown())
    return;
  const bool theirs = subject() == LayerSubject::Paths || planOfLayers(work().document);
  work().timeline.setMoveCount(theirs ? work().presenter.movesOf(work().layers.last()) : 0);
}

void LayersPage::showMeasures(int layer) {
  const auto facts = this->facts();
  if (facts && layer >= 0 && layer < static_cast<int>(facts->measures.size()))
    info_->setMeasures(facts->measures[static_cast<std::size_t>(layer)]);
  else
    info_->setMeasures(std::nullopt);
}

} // namespace voluta::window
