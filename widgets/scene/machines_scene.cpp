#include "scene/machines_scene.h"

#include "base/error.h"
#include "robot/cell.h"
#include "scene/actors.h"
#include "scene/bead_shader.h"
#include "scene/camera.h"
#include "scene/cell_actors.h"
#include "scene/shape_mesh.h"
#include "scene/visible_beads.h"
#include "scene/vtk_modules.h"

#include <utility>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace voluta::scene {

namespace {
constexpr double kMarkerMm = 12.0;
constexpr double kNumberAboveBaseMm = 60.0;

vtkSmartPointer<vtkPolyData> ball() {
  constexpr double kFlat = 0.01;
  MeshBuffers buffers;
  addShape(buffers, robot::Capsule{{0.0, 0.0, -kFlat}, {0.0, 0.0, kFlat}, kMarkerMm});
  return polyDataOf(buffers);
}

ViewState viewOf(std::size_t printed) {
  ViewState view;
  view.cell = view.paths = view.materialColour = true;
  view.printedWaypoints = printed;
  return view;
}
} // namespace

struct MachinesScene::Impl {
  // A machine with its actors.
  struct Shown {
    MachineDrawing drawing;
    std::unique_ptr<CellActors> cell;
    RangeActor beads;
  };

  explicit Impl(const Theme& given) : theme(given) {
    registerVtkModules();
    renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->GradientBackgroundOn();
    renderer->SetBackground(theme.backgroundBottom.data());
    renderer->SetBackground2(theme.backgroundTop.data());
    renderer->SetClippingRangeExpansion(0.05);
    renderer->SetUseFXAA(true);
    addLights(renderer);
    marker = addSolid(renderer);
    setData(marker, ball());
    setColour(marker, theme.marker);
    marker->SetVisibility(false);
  }

  void show(std::size_t k, const MachineMoment& moment) {
    Shown& shown = machines[k];
    const robot::Cell& cell = shown.drawing.cell->cell;
    const robot::JointVector q = moment.joints.size() == cell.dof() ? moment.joints : cell.home();
    std::vector<Eigen::Isometry3d> frames;
    cell.framePoses(q, frames);
    const Eigen::Isometry3d shared_T_base =
        shown.drawing.shared_T_world * cell.base_T_world(q).inverse(Eigen::Isometry);
    for (Eigen::Isometry3d& frame : frames)
      frame = shared_T_base * frame;
    const ViewState view = viewOf(moment.printedWaypoints);
    shown.cell->pose(frames);
    shown.cell->show(view, false);
    if (!shown.drawing.paths)
      return;
    setPose(shown.beads.actor, frames[static_cast<std::size_t>(cell.workFrame())]);
    shown.beads.mapper->setStretches(plain(visibleBeads(*shown.drawing.paths, view).stretches));
  }

  static std::vector<Stretch> plain(std::vector<Stretch> stretches) {
    for (Stretch& stretch : stretches)
      stretch.plain = true;
    return stretches;
  }

  void clear() {
    for (Shown& shown : machines) {
      shown.cell->setDrawing(nullptr);
      if (shown.beads.actor)
        renderer->RemoveActor(shown.beads.actor);
    }
    machines.clear();
  }

  Theme theme;
  vtkSmartPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkActor> marker;
  std::vector<Shown> machines;
};

MachinesScene::MachinesScene(const Theme& theme) : impl_(std::make_unique<Impl>(theme)) {
  lookFrom(impl_->renderer, StandardView::Isometric);
}
MachinesScene::~MachinesScene() = default;

vtkRenderer* MachinesScene::renderer() {
  return impl_->renderer;
}

void MachinesScene::setMachines(std::vector<MachineDrawing> machines) {
  impl_->clear();
  for (MachineDrawing& drawing : machines) {
    const std::size_t k = impl_->machines.size();
    Impl::Shown& shown = impl_->machines.emplace_back();
    shown.drawing = std::move(drawing);
    shown.cell = std::make_unique<CellActors>(impl_->renderer);
    shown.cell->setDrawing(shown.drawing.cell.get());
    shown.cell->setTheme(impl_->theme);
    if (shown.drawing.paths) {
      shown.beads = RangeActor::make(impl_->renderer);
      drawAsBeads(shown.beads.actor, shown.beads.mapper);
      addPlainColour(shown.beads.actor);
      shown.beads.mapper->setPlainColour(colourOf(k));
      shown.beads.setData(shown.drawing.paths->beads);
    }
    impl_->show(k, {.joints = {}, .printedWaypoints = kAllMoves});
  }
}

std::size_t MachinesScene::machineCount() const {
  return impl_->machines.size();
}

void MachinesScene::setMoments(const std::vector<MachineMoment>& moments) {
  base::require(moments.size() == impl_->machines.size(), "setMoments: one per machine");
  for (std::size_t k = 0; k < moments.size(); ++k)
    impl_->show(k, moments[k]);
}

void MachinesScene::setMarker(const std::optional<Eigen::Vector3d>& place) {
  impl_->marker->SetVisibility(place.has_value());
  if (place)
    impl_->marker->SetPosition(place->x(), place->y(), place->z());
}

void MachinesScene::frameAll() {
  Eigen::AlignedBox3d box;
  for (const auto& shown : impl_->machines)
    box.extend(shown.cell->box());
  frameBox(impl_->renderer, box);
}

Eigen::Vector3d MachinesScene::placeOfNumber(std::size_t machine) const {
  const Eigen::Isometry3d& place = impl_->machines[machine].drawing.shared_T_world;
  return place.translation() + Eigen::Vector3d(0.0, 0.0, kNumberAboveBaseMm);
}

} // namespace voluta::scene
