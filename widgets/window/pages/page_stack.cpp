#include "window/pages/page_stack.h"

#include "document/document.h"
#include "layers/layer_stack.h"
#include "panels/object_tree.h"
#include "panels/region_names.h"
#include "pipeline/plan_result.h"
#include "plan/waypoints.h"
#include "timeline/layer_range_slider.h"
#include "window/flow_bar.h"
#include "window/legend_view.h"
#include "window/pages/page_table.h"
#include "window/picture.h"
#include "window/picture_badge.h"
#include "window/presenters/presenter.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr double kFindingRadiusMm = 15.0;
constexpr int kFirstKey = 5; // F5

bool showsResultsOf(const Page& page, Stage stage) {
  const std::vector<Stage> stages = page.stages();
  return std::find(stages.begin(), stages.end(), stage) != stages.end();
}

// Returns the stage that the view shows; none: the part alone.
std::optional<Stage> stageOf(const scene::ViewState& view) {
  if (view.voxels || view.pieces)
    return Stage::Decompose;
  if (view.joints.size() > 0) // otherwise the cell is at home, whatever is planned
    return Stage::Motion;
  return view.layers  ? std::optional(Stage::Layers)
         : view.paths ? std::optional(Stage::Toolpath)
                      : std::nullopt;
}

bool isColoured(const scene::ViewState& view) {
  return !view.materialColour &&
         (view.voxels || view.pieces || view.layers || view.paths || view.reach);
}
} // namespace

PageStack::PageStack(const WorkspaceParts& workspace, QWidget* picture, LegendView& legend,
                     PictureBadge& badge, UnrolledDock& unrolled, QWidget* parent)
    : QObject(parent), workspace_(workspace), legend_(legend), badge_(badge), unrolled_(unrolled),
      flow_(new FlowBar(parent)), sides_(new QStackedWidget(parent)),
      centres_(new QStackedWidget(parent)), pages_(makePages(Workspace{workspace, *this})) {
  centres_->addWidget(picture);
  for (const auto& page : pages_) {
    sides_->addWidget(page->side());
    if (QWidget* centre = page->centre())
      centres_->addWidget(centre);
  }
  page_ = pages_.front().get();
  connect(flow_, &FlowBar::pageChosen, this, [this](const QString& id) { show(*find(id)); });
  listenToViewport();
  listenToPresenter();
  listenToBars();
}

PageStack::~PageStack() = default;

void PageStack::forInputs(const std::function<void(ViewportInput&)>& does) {
  for (ViewportInput* input : page_->inputs())
    does(*input);
}

void PageStack::listenToViewport() {
  using viewer::Viewport;
  Viewport* viewport = &workspace_.viewport;
  connect(viewport, &Viewport::clicked, this, [this](const std::optional<scene::Hit>& hit) {
    workspace_.picture.setMarker(std::nullopt);
    forInputs([&](ViewportInput& input) { input.clicked(hit); });
    showView();
  });
  connect(viewport, &Viewport::painted, this,
          [this](const std::optional<scene::Hit>& hit, bool erases, bool finished) {
            forInputs([&](ViewportInput& input) { input.painted(hit, erases, finished); });
          });
  connect(viewport, &Viewport::hovered, this, [this](const std::optional<scene::Hit>& hit) {
    forInputs([&](ViewportInput& input) { input.hovered(hit); });
  });
  connect(viewport, &Viewport::gizmoStarted, this,
          [this] { forInputs([](ViewportInput& input) { input.gizmoStarted(); }); });
  connect(viewport, &Viewport::gizmoDragged, this,
          [this](const viewer::GizmoChange& change, bool finished) {
            forInputs([&](ViewportInput& input) { input.gizmoDragged(change, finished); });
          });
  connect(viewport, &Viewport::toolChanged, this, [this] {
    showView();
    showStates();
  });
}

void PageStack::listenToPresenter() {
  Presenter* presenter = &workspace_.presenter;
  connect(presenter, &Presenter::partDrawn, this, [this](bool another) {
    workspace_.viewport.scene().setPartPreview(Eigen::Affine3d::Identity());
    if (!workspace_.presenter.partBox().isEmpty())
      workspace_.viewport.setGizmoCentre(workspace_.presenter.partBox().center());
    showView();
    if (another)
      workspace_.viewport.frameAll();
  });
  connect(presenter, &Presenter::platformDrawn, this, &PageStack::keepPlatformInView);
  connect(presenter, &Presenter::cellDrawn, this, [this] {
    showView();
    const std::string& cell = workspace_.document.choices().cell;
    if (std::exchange(cell_, cell) != cell && page_->layout().aboutPart &&
        !workspace_.viewport.isCameraTheUsers())
      workspace_.viewport.frameAll();
  });
  connect(presenter, &Presenter::statisticsReady, this, &PageStack::showLegend);
  connect(&legend_, &LegendView::entryClicked, this, [this](int kind) {
    Look look = workspace_.picture.look();
    look.hiddenKinds ^= 1U << kind;
    workspace_.picture.setLook(look);
  });
  connect(presenter, &Presenter::motionReady, this, [this] {
    workspace_.timeline.setClock(workspace_.presenter.clock());
    showView();
  });
}

// A platform made for the part moves with it and is still the same one.
void PageStack::keepPlatformInView(const Eigen::Vector3d& sizeMm) {
  constexpr double kSameMm = 2.0;
  const bool another = (sizeMm - platformSizeMm_).cwiseAbs().maxCoeff() > kSameMm;
  platformSizeMm_ = sizeMm;
  if (another && !workspace_.viewport.isCameraTheUsers())
    workspace_.viewport.frameAll();
}

void PageStack::listenToBars() {
  connect(&workspace_.document, &document::Document::edited, this, [this] {
    workspace_.picture.setMarker(std::nullopt);
    showView();
  });
  connect(&workspace_.document, &document::Document::stateChanged, this, &PageStack::showBadge);
  connect(&workspace_.timeline, &timeline::TimelineBar::timeChanged, this, [this] {
    workspace_.picture.setMarker(std::nullopt);
    if (page_->layout().timeline == timeline::BarMode::Time)
      showView();
  });
  connect(&workspace_.picture, &Picture::lookChanged, this, &PageStack::showView);
  connect(&workspace_.tree, &panels::ObjectTree::visibilityChanged, this, &PageStack::showView);
  connect(&unrolled_, &UnrolledDock::chosen, this, &PageStack::chooseWaypoint);
  connect(&unrolled_, &UnrolledDock::wantedChanged, this, [this] {
    showView();
    showStates();
  });
  connect(&workspace_.document, &document::Document::resultChanged, this, [this](Stage stage) {
    if (stage == Stage::Layers || stage == Stage::Toolpath)
      unrolled_.showProgress(page_->printProgress());
  });
}

std::vector<Command> PageStack::commands() {
  std::vector<Command> all;
  int key = kFirstKey;
  for (const auto& page : pages_) {
    for (Command& command : page->commands())
      all.push_back(std::move(command));
    all.push_back({"page_" + page->id(),
                   "windowMenu",
                   0,
                   page->info().name,
                   QT_TRANSLATE_NOOP("Commands", "Go to this page"),
                   {QKeySequence(QString("F%1").arg(key++))},
                   [this, page = page.get()] { show(*page); }});
  }
  return all;
}

std::vector<Page*> PageStack::all() const {
  std::vector<Page*> all;
  for (const auto& page : pages_)
    all.push_back(page.get());
  return all;
}

Page* PageStack::find(const QString& id) const {
  const auto at = std::find_if(pages_.begin(), pages_.end(),
                               [&](const auto& page) { return page->id() == id; });
  return at == pages_.end() ? nullptr : at->get();
}

void PageStack::show(Page& page) {
  workspace_.picture.setMarker(std::nullopt);
  page_->leave();
  page_ = &page;
  flow_->setPage(page.id());
  sides_->setCurrentWidget(page.side());
  centres_->setCurrentWidget(page.centre() ? page.centre() : centres_->widget(0));
  const PageLayout layout = page.layout();
  workspace_.layers.setVisible(layout.layerSlider);
  workspace_.timeline.setVisible(layout.timeline.has_value());
  if (!layout.timeline)
    workspace_.timeline.pause(); // a bar that is not visible cannot be paused with a key
  workspace_.timeline.setMode(layout.timeline.value_or(timeline::BarMode::Time));
  page.enter();
  showView();
  const bool other = std::exchange(inCell_, layout.inCell) != layout.inCell;
  const bool wider = std::exchange(aboutPart_, layout.aboutPart) != layout.aboutPart;
  if (other || (wider && !workspace_.viewport.isCameraTheUsers()))
    workspace_.viewport.frameAll();
  showStates();
}

void PageStack::showPageOf(Stage stage) {
  for (const auto& page : pages_)
    if (showsResultsOf(*page, stage)) {
      show(*page);
      return;
    }
}

void PageStack::showResults() {
  const std::vector<Stage> stages = page_->stages();
  if (std::none_of(stages.begin(), stages.end(), [](Stage one) { return one > Stage::Load; }))
    showPageOf(Stage::Layers);
}

void PageStack::goTo(const plan::Finding& finding) {
  const auto best =
      std::max_element(pages_.begin(), pages_.end(), [&](const auto& a, const auto& b) {
        return a->interest(finding) < b->interest(finding);
      });
  show(**best);
  const bool there = (*best)->goTo(finding);
  // Set last, because the page's other changes on the way remove a marker.
  workspace_.picture.setMarker(finding.where);
  showView();
  if (finding.where && !there)
    lookAtMarker(*finding.where);
}

void PageStack::lookAtMarker(const Eigen::Vector3d& place) {
  const scene::Sight sight = workspace_.viewport.lookAtClearly(place, kFindingRadiusMm);
  workspace_.picture.setHidden(sight.hides, sight.towardsEyeInWork);
  showView();
}

void PageStack::chooseWaypoint(std::optional<std::size_t> waypoint) {
  if (!unrolled_.isVisible())
    return;
  const auto plan = planOfLayers(workspace_.document);
  const plan::ToolPath* path = plan && waypoint ? plan::pathOf(*plan, *waypoint) : nullptr;
  unrolled_.choose(path ? waypoint : std::nullopt);
  if (path)
    page_->goToWaypoint(*path, *waypoint);
  showView();
}

void PageStack::showView() {
  scene::ViewState view = workspace_.picture.base(workspace_.presenter.partBox());
  view.platform = workspace_.tree.isShown(panels::SceneItem::Platform);
  page_->draw(view);
  workspace_.picture.reveal(view);
  unrolled_.mark(view);
  workspace_.viewport.setView(view);
  if (std::exchange(world_, view.world) != view.world)
    // A cell appeared or disappeared, so that everything is in another place
    workspace_.viewport.frameAll();
  unrolled_.showProgress(page_->printProgress());
  page_->drawn();
  showLegend();
  showBadge();
}

// Returns whether a tool of the page draws what is shown, so that it is no result.
bool PageStack::isToolsPicture() const {
  return page_->layout().aboutPart && workspace_.viewport.tool() != viewer::Tool::None;
}

namespace {
// With several parts a number stands for a region of each.
void nameRegions(scene::Legend& legend, scene::ColourBy colourBy,
                 const std::shared_ptr<const pipeline::PlanResult>& result) {
  if (!legend.categorical || !result || result->job.choices.items.size() != 1)
    return;
  const int first = colourBy == scene::ColourBy::Region  ? 1
                    : colourBy == scene::ColourBy::Group ? layers::kRegionGroups
                                                         : std::numeric_limits<int>::max();
  const std::vector<project::Region>& regions = result->job.choices.item().regions;
  for (scene::LegendEntry& entry : legend.entries)
    if (const double at = entry.value - first;
        at >= 0.0 && at < static_cast<double>(regions.size()))
      entry.label = panels::nameOfRegion(regions, static_cast<std::size_t>(at)).toStdString();
}
} // namespace

// Beads by kind have their statistics beside them: those of a layer that is shown alone, else of
// the whole print.
void PageStack::showLegend() {
  const scene::ViewState& view = workspace_.viewport.view();
  if (!isColoured(view) || isToolsPicture()) {
    legend_.setLegend({});
    return;
  }
  LegendFigures figures;
  const auto& statistics = workspace_.presenter.statistics();
  if (view.paths && view.colourBy == scene::ColourBy::Kind && statistics) {
    const auto layer = static_cast<std::size_t>(std::max(0, view.firstLayer));
    const PrintStatistics& of = statistics->figures;
    const bool single =
        view.firstLayer == view.lastLayer && layer < of.layers.size() && of.layers.size() > 1;
    figures = single ? legendFigures(of.layers[layer], tr("Layer %1").arg(layer + 1),
                                     workspace_.picture.look().hiddenKinds)
                     : legendFigures(of.whole, tr("Total"), workspace_.picture.look().hiddenKinds);
  }
  scene::Legend legend = workspace_.viewport.scene().legend();
  nameRegions(legend, view.colourBy, workspace_.document.lastResult());
  legend_.setLegend(legend, figures);
}

// Shows a badge if the view is for other settings than the present ones.
void PageStack::showBadge() {
  const document::Document& document = workspace_.document;
  const std::optional<Stage> stage = stageOf(workspace_.viewport.view());
  const bool preview = stage == Stage::Decompose && document.voxelsAhead();
  if (!stage || page_->centre() || isToolsPicture())
    badge_.setText({}, {});
  else if (preview && document.voxelsInPlace())
    badge_.setText(tr("Preview"),
                   tr("Layers, paths and programs are not up to date yet: press Plan."));
  else if (!document.upToDate(*stage))
    badge_.setText(tr("Out of date"), tr("The settings have changed since: press Plan."));
  else
    badge_.setText({}, {});
}

void PageStack::showStates() {
  for (const auto& page : pages_)
    flow_->setState(page->id(), page->state());
  emit statesShown();
}

void PageStack::retranslate() {
  std::vector<FlowStep> steps;
  for (const auto& page : pages_)
    steps.push_back({page->id(), page->title(), page->info().separate});
  flow_->setSteps(steps);
  for (const auto& page : pages_)
    page->retranslate();
  showView();
}

} // namespace voluta::window
