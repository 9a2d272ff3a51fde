#include "window/presenters/print_presenter.h"

#include "motion/waits.h"
#include "planar/planar_decomposition.h"
#include "window/background.h"
#include "window/layer_measures.h"

#include <algorithm>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
scene::HeightLimits heightLimits(const process::Process& process) {
  return {process.layerHeightMm, process.layerHeightMinMm, process.layerHeightMaxMm};
}
} // namespace

PrintPresenter::PrintPresenter(document::Document& document, viewer::Viewport& viewport)
    : document_(document), viewport_(viewport), drawingLayers_(std::make_unique<jobs::JobRunner>()),
      drawingPaths_(std::make_unique<jobs::JobRunner>()),
      gathering_(std::make_unique<jobs::JobRunner>()),
      measuring_(std::make_unique<jobs::JobRunner>()) {
  connect(&document, &document::Document::resultChanged, this, &PrintPresenter::show);
  connect(&document, &document::Document::choicesChanged, this, &PrintPresenter::followCell);
}

PrintPresenter::~PrintPresenter() = default;

const std::vector<std::uint32_t>& PrintPresenter::waypointsOf(int layer) const {
  static const std::vector<std::uint32_t> none;
  return paths_ ? scene::waypointsOfLayer(*paths_, layer) : none;
}

bool PrintPresenter::busy() const {
  return drawingLayers_->running() || drawingPaths_->running() || gathering_->running() ||
         measuring_->running();
}

void PrintPresenter::show(Stage stage) {
  const auto result = document_.result(stage);
  if (!result)
    drop(stage);
  else if (stage == Stage::Layers)
    drawLayers(layersOf(result->job), result->tooling().first().process);
  else if (stage == Stage::Toolpath)
    drawPaths(result->job.toolPlan);
  else if (stage == Stage::Motion)
    drawMotion();
}

// The part or project was removed: cancel drawings in progress, so that they do not appear later.
void PrintPresenter::drop(Stage stage) {
  if (stage == Stage::Layers) {
    drawingLayers_->cancel();
    gathering_->cancel();
    viewport_.scene().setLayers(nullptr);
    patchLayers_ = 0;
    facts_.reset();
    drawnLayers_ = {};
    emit layersDrawn();
  } else if (stage == Stage::Toolpath) {
    drawingPaths_->cancel();
    measuring_->cancel();
    statistics_.reset();
    viewport_.scene().setPaths(nullptr);
    paths_.reset();
    pathLayers_ = 0;
    drawnPaths_.reset();
    emit pathsDrawn();
  } else if (stage == Stage::Motion) {
    clock_.reset();
    emit motionReady();
  }
  viewport_.requestFrame();
}

void PrintPresenter::drawLayers(const JobLayers& layers, const process::Process& process) {
  if (!layers.complete() || drawnLayers_ == layers)
    return;
  drawnLayers_ = layers;
  inBackground(
      *drawingLayers_,
      [layers, heights = heightLimits(process)] {
        return scene::drawLayers(*layers.joined(), heights);
      },
      [this](auto&& made) {
        viewport_.scene().setLayers(made);
        patchLayers_ = scene::layerCount(*made);
        viewport_.requestFrame();
        emit layersDrawn();
        gatherFacts();
      });
}

void PrintPresenter::drawPaths(const std::shared_ptr<const plan::ToolPlan>& plan) {
  if (!plan || drawnPaths_ == plan)
    return;
  drawnPaths_ = plan;
  if (const auto motion = shownMotion(); motion && motion->job.toolPlan == plan) {
    drawMotion();
    return;
  }
  inBackground(
      *drawingPaths_, [plan] { return scene::drawPaths(*plan); },
      [this](auto&& made) {
        swapPaths(made);
        if (std::exchange(clock_, nullptr)) // of the previous paths
          emit motionReady();
        gatherFacts();
        measureKinds();
      });
}

void PrintPresenter::swapPaths(const std::shared_ptr<const scene::PathsDrawing>& drawing) {
  paths_ = drawing;
  pathLayers_ = scene::layerCount(*paths_);
  viewport_.scene().setPaths(paths_);
  viewport_.requestFrame();
  emit pathsDrawn();
}

std::shared_ptr<const pipeline::PlanResult> PrintPresenter::shownMotion() const {
  const auto motion = document_.result(Stage::Motion), paths = document_.result(Stage::Toolpath);
  const bool there = motion && motion->job.trajectory && motion->job.toolPlan && paths &&
                     motion->job.toolPlan == paths->job.toolPlan &&
                     motion->job.choices.cell == document_.choices().cell;
  return there ? motion : nullptr;
}

void PrintPresenter::followCell() {
  if (!shownMotion()) {
    if (std::exchange(clock_, nullptr))
      emit motionReady();
  } else if (!clock_ && !drawingPaths_->running()) {
    drawMotion();
  }
}

void PrintPresenter::drawMotion() {
  const auto result = shownMotion();
  if (!result)
    return;
  const auto plan = result->job.toolPlan;
  const auto trajectory = result->job.trajectory;
  inBackground(
      *drawingPaths_,
      [plan, trajectory] {
        return std::pair(
            scene::drawPaths(*plan, trajectory.get(), motion::layerTimesOf(*plan, *trajectory)),
            std::make_shared<const timeline::Clock>(trajectory, plan));
      },
      [this, trajectory](auto&& made) {
        const auto motion = shownMotion(); // the choices may have changed in the meantime
        clock_ = motion && motion->job.trajectory == trajectory ? made.second : nullptr;
        swapPaths(made.first);
        emit motionReady();
        gatherFacts();
        measureKinds();
      });
}

void PrintPresenter::measureKinds() {
  const auto paths = document_.result(Stage::Toolpath);
  if (!paths || !paths->job.toolPlan)
    return;
  const auto plan = paths->job.toolPlan;
  const auto clock = clock_ && clock_->toolPlan() == plan ? clock_ : nullptr;
  inBackground(
      *measuring_,
      [plan, clock, tooling = paths->tooling()] {
        auto made = std::make_shared<ShownStatistics>();
        made->of = plan;
        made->figures = printStatistics(*plan, tooling, clock.get());
        return std::shared_ptr<const ShownStatistics>(made);
      },
      [this](auto&& made) {
        statistics_ = made;
        emit statisticsReady();
      });
}

void PrintPresenter::gatherFacts() {
  const auto result = document_.result(Stage::Layers);
  const JobLayers layers = result ? layersOf(result->job) : JobLayers{};
  if (!layers.complete())
    return;
  const auto paths = document_.result(Stage::Toolpath);
  const auto plan = paths ? paths->job.toolPlan : nullptr;
  const auto clock = clock_ && clock_->toolPlan() == plan ? clock_ : nullptr;
  // The layers of pieces with different directions, or of one part after another, do not add up to
  // a height.
  const bool rising = layers.stacks.size() < 2 || layers.order == layers::PrintOrder::ByLayer;
  const bool stacked =
      rising && std::ranges::all_of(result->job.items, [](const project::JobItem& item) {
        return !item.pieces() || item.pieces()->pieces.size() < 2;
      });
  inBackground(
      *gathering_,
      [layers, plan, clock, rising, stacked,
       heights = heightLimits(result->tooling().first().process)] {
        auto facts = std::make_shared<LayerFacts>();
        const auto stack = layers.joined();
        facts->of = layers;
        facts->measures = layerMeasures(*stack, plan.get(), clock.get());
        if (rising)
          facts->topsMm = layerRadiiMm(*stack);
        facts->radii = !facts->topsMm.empty();
        if (stacked && !facts->radii)
          facts->topsMm = layerTopsMm(facts->measures);
        facts->spacing = layerSpacing(*stack, heights);
        return std::shared_ptr<const LayerFacts>(facts);
      },
      [this](auto&& made) {
        facts_ = made;
        emit factsReady();
      });
}

} // namespace voluta::window
