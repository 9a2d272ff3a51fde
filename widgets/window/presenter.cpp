#include "window/presenter.h"

#include "geometry/measures.h"
#include "pipeline/choices.h"
#include "voxel/solid_voxels.h"
#include "window/layer_measures.h"

#include <algorithm>

namespace voluta::window {

namespace {
using pipeline::Stage;

constexpr double kGroundRadiusMm = 150.0;
constexpr int kThreads = 1; // planning has the others
} // namespace

template <typename Work, typename Done> void Presenter::prepare(Slot slot, Work work, Done done) {
  using Made = std::shared_ptr<std::invoke_result_t<Work&>>;
  runners_[slot]->run(
      [work = std::move(work)](const base::RunContext&) mutable {
        return std::make_shared<std::invoke_result_t<Work&>>(work());
      },
      [done = std::move(done)](base::Outcome<Made> outcome) mutable {
        if (const Made* made = std::get_if<Made>(&outcome))
          done(std::move(**made));
      },
      kThreads);
}

Presenter::Presenter(document::Document& document, viewer::Viewport& viewport, QObject* parent)
    : QObject(parent), document_(document), viewport_(viewport) {
  for (auto& runner : runners_)
    runner = std::make_unique<jobs::JobRunner>();
  connect(&document, &document::Document::sourceChanged, this, &Presenter::drawSource);
  connect(&document, &document::Document::resultChanged, this, &Presenter::show);
  connect(&document, &document::Document::previewChanged, this, &Presenter::drawVoxels);
  connect(&document, &document::Document::choicesChanged, this, &Presenter::drawPlannedPlate);
}

Presenter::~Presenter() = default;

int Presenter::layerCount() const {
  if (document_.voxelsAhead() && voxelLayers_ > 0)
    return voxelLayers_;
  if (pathLayers_ > 0)
    return std::max(pathLayers_, patchLayers_);
  return patchLayers_ > 0 ? patchLayers_ : voxelLayers_;
}

int Presenter::movesOf(int layer) const {
  return paths_ ? static_cast<int>(scene::waypointsOfLayer(*paths_, layer).size()) : 0;
}

bool Presenter::busy() const {
  return std::any_of(runners_.begin(), runners_.end(),
                     [](const auto& runner) { return runner->running(); });
}

// The part as it was read is on show before the first stage has placed it.
void Presenter::drawSource() {
  const std::shared_ptr<const pipeline::LoadedPart> source = document_.source();
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
  const double wanted = pipeline::parsedScale(document_.choices().scale);
  const double unit = pipeline::unitMm(*source, document_.choices());
  const geometry::Placement placement = document_.choices().placement;
  prepare(
      Part,
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
  prepare(
      Part, [mesh] { return std::pair(scene::drawPart(*mesh), geometry::bounds(*mesh)); },
      [this](auto&& made) { swapPart(made.first, made.second); });
}

void Presenter::drawPlate(const std::vector<Eigen::Vector2d>& polygon) {
  prepare(
      Plate, [polygon] { return scene::drawPlatform(polygon, kGroundRadiusMm); },
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
  const pipeline::Choices& choices = document_.choices();
  const double voxelMm = pipeline::parameterValues(choices).number("voxelMm");
  const auto wanted = std::tuple(choices.platform, voxelMm, placed->job.part);
  if (wanted == plateDrawn_)
    return;
  plateDrawn_ = wanted;
  prepare(
      Plate,
      [wanted] {
        const auto& [platform, pitch, part] = wanted;
        voxel::SolidVoxels solid;
        if (platform.starts_with("fit"))
          solid = voxel::solidVoxels(*part, pitch, {});
        return scene::drawPlatform(pipeline::platformPolygon(platform, solid), kGroundRadiusMm);
      },
      [this](auto&& made) {
        viewport_.scene().setPlatform(made);
        viewport_.requestFrame();
      });
}

// Of the preview where there is one. The next preview waits until one is drawn, or none would be
// where they follow each other fast.
void Presenter::drawVoxels() {
  const auto result = document_.result(Stage::Decompose);
  const auto& preview = document_.preview();
  const auto voxels = preview  ? preview->decomposition
                      : result ? result->job.decomposition
                               : nullptr;
  if (!voxels) {
    viewport_.scene().setVoxels(nullptr);
    voxelLayers_ = 0;
    drawn_[Voxels].reset();
    viewport_.requestFrame();
    return;
  }
  if (drawn_[Voxels] == voxels)
    return;
  if (preview && runners_[Voxels]->running()) {
    voxelsAgain_ = true;
    return;
  }
  voxelsAgain_ = false;
  drawn_[Voxels] = voxels;
  if (preview)
    drawPlate(voxels->platform);
  prepare(
      Voxels,
      [voxels, height = preview ? preview->layerHeightMm : result->process->layerHeightMm] {
        return scene::drawVoxels(*voxels, height);
      },
      [this](auto&& made) {
        viewport_.scene().setVoxels(made);
        voxelLayers_ = scene::layerCount(*made);
        viewport_.requestFrame();
        emit voxelsDrawn();
        if (voxelsAgain_)
          drawVoxels();
      });
}

void Presenter::drawMotion() {
  const auto result = document_.result(Stage::Motion);
  if (!result || !result->job.trajectory || !result->job.toolPlan)
    return;
  const auto plan = result->job.toolPlan;
  const auto trajectory = result->job.trajectory;
  prepare(
      Paths,
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
  prepare(
      Facts,
      [stack, plan, clock] {
        auto facts = std::make_shared<LayerFacts>();
        facts->measures = layerMeasures(*stack, plan.get(), clock.get());
        facts->topsMm = layerTopsMm(facts->measures);
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
      scene.setVoxels(nullptr);
      voxelLayers_ = 0;
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
  const pipeline::Job& job = result->job;
  if (stage == Stage::Load) {
    drawPart(job.part);
    drawPlannedPlate();
  } else if (stage == Stage::Decompose) {
    plateDrawn_ = {};
    drawPlate(job.platform);
    if (result->cell && drawn_[CellBodies] != result->cell) {
      drawn_[CellBodies] = result->cell;
      prepare(
          CellBodies, [cell = result->cell] { return scene::drawCell(*cell); },
          [this](auto&& made) {
            viewport_.scene().setCell(made);
            viewport_.requestFrame();
          });
    }
    drawVoxels();
  } else if (stage == Stage::Layers) {
    if (!job.layers || drawn_[Patches] == job.layers)
      return;
    drawn_[Patches] = job.layers;
    prepare(
        Patches, [stack = job.layers] { return scene::drawLayers(*stack); },
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
    prepare(
        Paths, [plan = job.toolPlan] { return scene::drawPaths(*plan); },
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
