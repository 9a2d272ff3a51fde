#include "window/presenter.h"

#include "geometry/measures.h"
#include "modes/mode_table.h"
#include "modes/plate.h"
#include "pipeline/choices.h"
#include "pipeline/stages.h"
#include "voxel/solid_voxels.h"
#include "window/background.h"
#include "window/layer_measures.h"

#include <algorithm>

namespace voluta::window {

namespace {
using project::Stage;

constexpr double kGroundRadiusMm = 150.0;

scene::HeightLimits heightLimits(const process::Process& process) {
  return {process.layerHeightMm, process.layerHeightMinMm, process.layerHeightMaxMm};
}

platform::PlatformSolid plannedPlatform(const modes::LoadStage& placed,
                                        const project::Choices& choices) {
  const base::ParameterValues values = pipeline::parameterValues(choices);
  if (const auto platform = modes::findMode(choices.mode).platform)
    return platform(placed, {choices, values, pipeline::chosenProcess(choices, values)});
  return modes::plateOf(choices.platform,
                        choices.platform.marginMm()
                            ? voxel::solidVoxels(*placed.part, values.number("voxelMm"), {})
                            : voxel::SolidVoxels{});
}

// Where the part lies: as the user has placed it, or as the mode lays it where nobody has.
geometry::Placement placementOf(const project::LoadedPart& source, const project::Choices& choices,
                                double scale) {
  const geometry::Placement& own = choices.placement;
  const auto place = modes::findMode(choices.mode).place;
  if (!place || !Presenter::isUntouched(own))
    return own;
  const base::ParameterValues values = pipeline::parameterValues(choices);
  return place(*source.mesh, scale, {choices, values, pipeline::chosenProcess(choices, values)});
}

// What of the choices the platform is made from.
std::string platformKey(const project::Choices& choices) {
  std::string key = choices.mode + '|' + choices.platform.text() + '|' + choices.cell;
  for (const char* parameter : {"voxelMm", "rodSides", "rodProfile", "rodAxis"})
    if (const auto at = choices.parameters.find(parameter); at != choices.parameters.end())
      key += '|' + at->first + '=' + at->second;
  return key;
}
} // namespace

Presenter::Presenter(document::Document& document, viewer::Viewport& viewport, QObject* parent)
    : QObject(parent), document_(document), viewport_(viewport), voxels_(viewport),
      pieces_(viewport) {
  for (auto& runner : runners_)
    runner = std::make_unique<jobs::JobRunner>();
  connect(&document, &document::Document::sourceChanged, this, &Presenter::drawSource);
  connect(&document, &document::Document::resultChanged, this, &Presenter::show);
  connect(&document, &document::Document::previewChanged, this, &Presenter::drawVoxels);
  connect(&voxels_, &VoxelPresenter::drawn, this, &Presenter::voxelsDrawn);
  connect(&document, &document::Document::choicesChanged, this, &Presenter::drawPlannedPlate);
}

Presenter::~Presenter() = default;

bool Presenter::isUntouched(const geometry::Placement& p) {
  return p.rotation.coeffs() == Eigen::Quaterniond::Identity().coeffs() &&
         p.centreMm == Eigen::Vector2d::Zero() && p.liftMm == 0.0;
}

int Presenter::layerCount() const {
  if (document_.voxelsAhead() && hasVoxels())
    return voxels_.layers();
  if (pathLayers_ > 0)
    return std::max(pathLayers_, patchLayers_);
  return patchLayers_ > 0 ? patchLayers_ : voxels_.layers();
}

int Presenter::movesOf(int layer) const {
  return static_cast<int>(waypointsOf(layer).size());
}

const std::vector<std::uint32_t>& Presenter::waypointsOf(int layer) const {
  static const std::vector<std::uint32_t> none;
  return paths_ ? scene::waypointsOfLayer(*paths_, layer) : none;
}

bool Presenter::busy() const {
  return voxels_.busy() || pieces_.busy() ||
         std::any_of(runners_.begin(), runners_.end(),
                     [](const auto& runner) { return runner->running(); });
}

// The part as it was read is on show before the first stage has placed it.
void Presenter::drawSource() {
  const std::shared_ptr<const project::LoadedPart> source = document_.source();
  if (!source) {
    viewport_.scene().setPart(nullptr);
    partBox_.setEmpty();
    drawn_[Part].reset();
    viewport_.requestFrame();
    emit partDrawn(true);
    return;
  }
  if (document_.result(Stage::Load) && document_.upToDate(Stage::Load))
    return;
  const double wanted = project::parsedScale(document_.choices().scale);
  const double unit = pipeline::unitMm(*source, document_.choices());
  const geometry::Placement placement = document_.choices().placement;
  inBackground(
      *runners_[Part],
      [source, placement, scale = unit * (wanted > 0.0 ? wanted : 1.0)] {
        geometry::TriangleMesh placed = geometry::place(*source->mesh, scale, placement);
        return std::pair(scene::drawPart(placed), geometry::bounds(placed));
      },
      [this](auto&& made) {
        drawn_[Part].reset();
        swapPart(made.first, made.second);
      });
}

void Presenter::swapPart(const std::shared_ptr<const scene::PartDrawing>& drawing,
                         const Eigen::AlignedBox3d& box) {
  viewport_.scene().setPart(drawing);
  const bool another = partBox_.isEmpty() || shownSource_ != document_.source();
  shownSource_ = document_.source();
  partBox_ = box;
  viewport_.requestFrame();
  emit partDrawn(another);
}

void Presenter::drawPart(std::shared_ptr<const geometry::TriangleMesh> mesh) {
  if (!mesh || drawn_[Part] == mesh)
    return;
  drawn_[Part] = mesh;
  const auto placed = document_.result(Stage::Load);
  const double unit = pipeline::unitMm(*placed->job.loaded, placed->job.choices);
  inBackground(
      *runners_[Part],
      [mesh, source = placed->job.loaded, choices = placed->job.choices,
       scale = placed->job.scale * unit] {
        return std::tuple(scene::drawPart(*mesh), geometry::bounds(*mesh),
                          placementOf(*source, choices, scale));
      },
      [this](auto&& made) {
        placement_ = std::get<2>(made);
        swapPart(std::get<0>(made), std::get<1>(made));
      });
}

void Presenter::drawPlatform(const platform::PlatformSolid& platform) {
  inBackground(
      *runners_[Plate], [platform] { return scene::drawPlatform(platform, kGroundRadiusMm); },
      [this](auto&& made) {
        viewport_.scene().setPlatform(made);
        viewport_.requestFrame();
      });
}

// The platform's outline is on show before anything is planned: its size decides what can grow.
void Presenter::drawPlannedPlate() {
  const auto placed = document_.result(Stage::Load);
  if (!placed || !document_.upToDate(Stage::Load) || document_.upToDate(Stage::Decompose))
    return;
  const project::Choices& choices = document_.choices();
  const auto wanted = std::tuple(platformKey(choices), placed->job.part);
  if (wanted == plateDrawn_)
    return;
  plateDrawn_ = wanted;
  inBackground(
      *runners_[Plate],
      [choices, part = placed->job.part, scale = placed->job.scale] {
        modes::LoadStage stage;
        stage.part = part;
        stage.scale = scale;
        return scene::drawPlatform(plannedPlatform(stage, choices), kGroundRadiusMm);
      },
      [this](auto&& made) {
        viewport_.scene().setPlatform(made);
        viewport_.requestFrame();
      });
}

void Presenter::drawVoxels() {
  if (const auto& preview = document_.preview()) {
    drawPlatform(preview->decomposition->platform);
    voxels_.setDecomposition(preview->decomposition, preview->layerHeightMm);
    return;
  }
  const auto result = document_.result(Stage::Decompose);
  voxels_.setDecomposition(result ? result->job.decomposition : nullptr,
                           result && result->process ? result->process->layerHeightMm : 0.0);
}

// Flat slicing has one piece, the part: nothing to show.
void Presenter::drawPieces() {
  const auto result = document_.result(Stage::Decompose);
  const bool planar = result && result->job.choices.mode == "planar";
  pieces_.setPieces(planar ? result->job.pieces : nullptr,
                    result ? result->job.choices : project::Choices{});
}

void Presenter::drawMotion() {
  const auto result = document_.result(Stage::Motion);
  if (!result || !result->job.trajectory || !result->job.toolPlan)
    return;
  const auto plan = result->job.toolPlan;
  const auto trajectory = result->job.trajectory;
  inBackground(
      *runners_[Paths],
      [plan, trajectory] {
        return std::pair(scene::drawPaths(*plan, trajectory.get()),
                         std::make_shared<const timeline::Clock>(trajectory, plan));
      },
      [this](auto&& made) {
        paths_ = made.first;
        pathLayers_ = scene::layerCount(*paths_);
        clock_ = made.second;
        viewport_.scene().setPaths(paths_);
        viewport_.requestFrame();
        emit pathsDrawn();
        emit motionReady();
        gatherFacts();
      });
}

void Presenter::gatherFacts() {
  const auto result = document_.result(Stage::Layers);
  if (!result || !result->job.layers)
    return;
  const auto stack = result->job.layers;
  const auto paths = document_.result(Stage::Toolpath);
  const auto plan = paths ? paths->job.toolPlan : nullptr;
  const auto clock = clock_ && clock_->toolPlan() == plan ? clock_ : nullptr;
  // Layers of pieces that lean in all directions do not add up to a height.
  const bool stacked = !result->job.pieces || result->job.pieces->pieces.size() < 2;
  inBackground(
      *runners_[Facts],
      [stack, plan, clock, stacked, heights = heightLimits(*result->process)] {
        auto facts = std::make_shared<LayerFacts>();
        facts->measures = layerMeasures(*stack, plan.get(), clock.get());
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

void Presenter::show(Stage stage) {
  const auto result = document_.result(stage);
  scene::Scene& scene = viewport_.scene();
  if (!result) {
    // Dropped with its part or project.
    if (stage == Stage::Decompose) {
      drawVoxels();
      drawPieces();
    } else if (stage == Stage::Layers) {
      scene.setLayers(nullptr);
      patchLayers_ = 0;
      facts_.reset();
    } else if (stage == Stage::Toolpath) {
      scene.setPaths(nullptr);
      paths_.reset();
      pathLayers_ = 0;
    } else if (stage == Stage::Motion) {
      clock_.reset();
    }
    drawn_.fill(nullptr);
    viewport_.requestFrame();
    return;
  }
  const project::Job& job = result->job;
  if (stage == Stage::Load) {
    drawPart(job.part);
    drawPlannedPlate();
  } else if (stage == Stage::Decompose) {
    plateDrawn_ = {platformKey(job.choices), job.part};
    drawPlatform(job.platform);
    if (result->cell && drawn_[CellBodies] != result->cell) {
      drawn_[CellBodies] = result->cell;
      inBackground(
          *runners_[CellBodies], [cell = result->cell] { return scene::drawCell(*cell); },
          [this](auto&& made) {
            viewport_.scene().setCell(made);
            viewport_.requestFrame();
          });
    }
    drawVoxels();
    drawPieces();
  } else if (stage == Stage::Layers) {
    if (!job.layers || drawn_[Patches] == job.layers)
      return;
    drawn_[Patches] = job.layers;
    inBackground(
        *runners_[Patches],
        [stack = job.layers, heights = heightLimits(*result->process)] {
          return scene::drawLayers(*stack, heights);
        },
        [this](auto&& made) {
          viewport_.scene().setLayers(made);
          patchLayers_ = scene::layerCount(*made);
          viewport_.requestFrame();
          emit layersDrawn();
          gatherFacts();
        });
  } else if (stage == Stage::Toolpath) {
    if (!job.toolPlan || drawn_[Paths] == job.toolPlan)
      return;
    drawn_[Paths] = job.toolPlan;
    inBackground(
        *runners_[Paths], [plan = job.toolPlan] { return scene::drawPaths(*plan); },
        [this](auto&& made) {
          paths_ = made;
          pathLayers_ = scene::layerCount(*paths_);
          viewport_.scene().setPaths(paths_);
          viewport_.requestFrame();
          emit pathsDrawn();
          gatherFacts();
        });
  } else if (stage == Stage::Motion) {
    drawMotion();
  }
}

} // namespace voluta::window
