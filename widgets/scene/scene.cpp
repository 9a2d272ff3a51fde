#include "scene/scene.h"

#include "base/units.h"
#include "geometry/least_turn.h"
#include "robot/cell.h"
#include "scene/actors.h"
#include "scene/ambient_occlusion.h"
#include "scene/bead_shader.h"
#include "scene/camera.h"
#include "scene/cell_actors.h"
#include "scene/chosen_path.h"
#include "scene/colour_values.h"
#include "scene/drawn.h"
#include "scene/insert_actors.h"
#include "scene/line_groups.h"
#include "scene/mesh_buffers.h"
#include "scene/other_parts.h"
#include "scene/overlay.h"
#include "scene/piece_actors.h"
#include "scene/piece_labels.h"
#include "scene/platform_actors.h"
#include "scene/region_actors.h"
#include "scene/size_marks.h"
#include "scene/visible_beads.h"
#include "scene/voxel_actors.h"
#include "scene/vtk_modules.h"

#include <algorithm>
#include <cmath>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace voluta::scene {

namespace {

constexpr double kLineBeadScale = 0.22; // beads as thin lines
constexpr double kMarkerShare = 0.022;  // relative to the picture's height
constexpr double kFrontOpacity = 0.28;

// The state for which the colours of a range actor were set.
struct ColourState {
  const void* drawing = nullptr;
  ColourBy colourBy = ColourBy::Layer;
  bool operator==(const ColourState&) const = default;
};

std::vector<Stretch> everything(vtkPolyData* data) {
  return {{0, static_cast<std::size_t>(data->GetNumberOfPolys() + data->GetNumberOfLines())}};
}

} // namespace

struct Scene::Impl : Drawn {
  vtkSmartPointer<vtkRenderer> renderer;
  Theme theme;
  std::unique_ptr<Overlay> overlay;
  std::unique_ptr<SizeMarks> sizeMarks;
  std::optional<AmbientOcclusion> occlusion;
  vtkNew<vtkCallbackCommand> beforeFrame;
  vtkNew<vtkPlane> section;

  Eigen::Affine3d moved_T_part = Eigen::Affine3d::Identity();

  vtkSmartPointer<vtkActor> partSurface, partEdges, frontSurface, frontEdges;
  // Each drawing keeps its buffers: switching between them uploads nothing.
  std::unique_ptr<PlatformActors> platformActors;
  std::unique_ptr<OtherParts> otherParts;
  std::unique_ptr<CellActors> cellActors;
  std::unique_ptr<VoxelActors> byLayer, bySteps;
  std::unique_ptr<PieceActors> pieceActors;
  std::unique_ptr<RegionActors> regionActors;
  std::unique_ptr<InsertActors> insertActors;
  std::unique_ptr<ChosenPath> chosenPath;
  std::unique_ptr<PieceLabels> pieceLabels;
  std::unique_ptr<LineGroups> trace;
  RangeActor slabs, beads, travels, markerRim, marker;

  ColourState slabColours, beadColours;
  std::vector<Eigen::AlignedBox2d> covered;

  explicit Impl(const Theme& given) : theme(given) {
    registerVtkModules();
    renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->GradientBackgroundOn();
    renderer->SetClippingRangeExpansion(0.05);
    addLights(renderer);
    platformActors = std::make_unique<PlatformActors>(renderer);
    cellActors = std::make_unique<CellActors>(renderer);
    partSurface = addSolid(renderer);
    partEdges = addLines(renderer);
    otherParts = std::make_unique<OtherParts>(renderer);
    byLayer = std::make_unique<VoxelActors>(renderer);
    bySteps = std::make_unique<VoxelActors>(renderer);
    pieceActors = std::make_unique<PieceActors>(renderer);
    regionActors = std::make_unique<RegionActors>(renderer);
    slabs = RangeActor::make(renderer);
    beads = RangeActor::make(renderer);
    drawAsBeads(beads.actor, beads.mapper);
    addPlainColour(beads.actor);
    travels = RangeActor::make(renderer);
    travels.actor->GetProperty()->LightingOff();
    insertActors = std::make_unique<InsertActors>(renderer);
    chosenPath = std::make_unique<ChosenPath>(renderer);
    trace = std::make_unique<LineGroups>(renderer);
    frontSurface = addSolid(renderer);
    frontSurface->GetProperty()->SetOpacity(kFrontOpacity);
    frontEdges = addLines(renderer);
    frontEdges->GetProperty()->SetOpacity(2.0 * kFrontOpacity);
    // The rim contrasts the marker with a background of the same brightness.
    markerRim = RangeActor::halo(renderer);
    markerRim.setData(ring(0.72, 1.08));
    marker = RangeActor::halo(renderer);
    marker.setData(ring(0.80, 1.0));
    for (const RangeActor* shown : {&markerRim, &marker}) {
      shown->mapper->setStretches(everything(shown->mapper->GetInput()));
      shown->actor->GetProperty()->SetOpacity(1.0);
      shown->actor->GetProperty()->LightingOff();
    }
    pieceLabels = std::make_unique<PieceLabels>(renderer);
    sizeMarks = std::make_unique<SizeMarks>(renderer);
    overlay = std::make_unique<Overlay>(renderer);
    occlusion.emplace(renderer);
    applyTheme();
    beforeFrame->SetClientData(this);
    beforeFrame->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
      static_cast<Impl*>(self)->prepareFrame();
    });
    renderer->AddObserver(vtkCommand::StartEvent, beforeFrame);
  }
  ~Impl() { renderer->RemoveObserver(beforeFrame); }

  void applyTheme() {
    renderer->SetBackground(theme.backgroundBottom.data());
    renderer->SetBackground2(theme.backgroundTop.data());
    setColour(partSurface, theme.part);
    vtkNew<vtkProperty> inside;
    inside->SetColor(theme.partInside.data());
    inside->SetAmbient(0.75);
    inside->SetDiffuse(0.25);
    partSurface->SetBackfaceProperty(inside);
    setColour(partEdges, theme.partEdges);
    otherParts->setTheme(theme);
    platformActors->setTheme(theme);
    cellActors->setTheme(theme);
    byLayer->setTheme(theme);
    bySteps->setTheme(theme);
    pieceActors->setTheme(theme);
    pieceLabels->setTheme(theme);
    regionActors->setTheme(theme);
    showPieces();
    showRegions();
    setColour(frontSurface, theme.front);
    setColour(frontEdges, theme.front);
    setColour(travels.actor, theme.travel);
    setColour(marker.actor, theme.marker);
    insertActors->setTheme(theme);
    chosenPath->setColour(theme.marker);
    setColour(markerRim.actor, theme.backgroundTop);
    beads.mapper->setPlainColour(theme.material);
    overlay->setTheme(theme);
    sizeMarks->setTheme(theme);
  }

  void poseAll() {
    world_T_work.setIdentity();
    if (cell) {
      const robot::Cell& c = cell->cell;
      c.framePoses(view.joints.size() == c.dof() ? view.joints : c.home(), world_T_frame);
      const auto poseOf = [&](int frame) { return world_T_frame[static_cast<std::size_t>(frame)]; };
      // An external axis under the robot moves the base.
      const Eigen::Isometry3d base =
          view.world == World::Base ? (c.axesUnderRobot() > 0 ? poseOf(c.worldFrame()).inverse()
                                                              : Eigen::Isometry3d::Identity())
                                    : poseOf(c.workFrame()).inverse();
      for (Eigen::Isometry3d& pose : world_T_frame)
        pose = base * pose;
      if (view.world == World::Base)
        world_T_work = poseOf(c.workFrame());
      cellActors->pose(world_T_frame);
    }
    platformActors->pose(world_T_work);
    otherParts->pose(world_T_work);
    trace->pose(world_T_work);
    for (vtkActor* actor : cutActors())
      setPose(actor, world_T_work);
    for (vtkActor* actor : {partSurface.Get(), partEdges.Get()})
      setPose(actor, world_T_work * moved_T_part);
  }

  // Returns the actors that a section plane cuts, except the part.
  std::vector<vtkActor*> cutActors() const {
    std::vector<vtkActor*> actors{frontSurface, frontEdges,    slabs.actor,
                                  beads.actor,  travels.actor, chosenPath->actor()};
    for (vtkActor* actor : insertActors->actors())
      actors.push_back(actor);
    for (const auto* held : {&byLayer, &bySteps})
      for (vtkActor* actor : (*held)->actors())
        actors.push_back(actor);
    return actors;
  }

  void showPart() {
    const bool on = shows(view.part, part.get()) && view.partOpacity > 0.0;
    partSurface->SetVisibility(on);
    partEdges->SetVisibility(on && !isSeeThrough());
    setColour(partSurface, view.partBeyond ? theme.partBeyond : theme.part);
    partSurface->GetProperty()->SetOpacity(view.partOpacity);
    // Instead of depth-sorting translucent walls, only those that face the eye are drawn.
    partSurface->GetProperty()->SetBackfaceCulling(view.partOpacity < 1.0);
    otherParts->show(view.otherParts, view.otherPartsOpacity);
  }

  void showVoxels() {
    const bool growing = replaysGrowth();
    const bool frontOn = growing && shows(view.front, front.get());
    frontSurface->SetVisibility(frontOn);
    frontEdges->SetVisibility(frontOn);
    if (shownVoxels() && !growing)
      byLayer->show(view, false);
    else
      byLayer->hide();
    if (growing)
      bySteps->show(view, true);
    else if (view.voxels)
      bySteps->prepare();
    else
      bySteps->hide();
  }

  bool seenFromAbove() const {
    return (world_T_work.linear().transpose() * scene::towardsEye(renderer)).z() > 0.0;
  }

  void showLayers() {
    const bool on = shows(view.layers, layers.get());
    slabs.actor->SetVisibility(on);
    if (!on)
      return;
    const ColourState wanted{layers.get(), shownColouring(layers->values, view.colourBy)};
    if (!(wanted == slabColours))
      setColours(slabs, coloursOf(layers->values, wanted.colourBy, 1));
    slabColours = wanted;
    // Fast frames from above omit the undersides of ledges.
    slabs.mapper->setStretches(layerStretches(!view.dragging || !seenFromAbove()));
    // Slabs are closed; only a section shows their insides.
    slabs.actor->GetProperty()->SetBackfaceCulling(!view.sectionOn);
  }

  void showPaths() {
    const bool on = shows(view.paths, paths.get());
    beads.actor->SetVisibility(on);
    travels.actor->SetVisibility(on && view.travels);
    chosenPath->show(view, on ? paths.get() : nullptr);
    insertActors->show(view, on);
    if (!on)
      return;
    const ColourState wanted{paths.get(), shownColouring(paths->values, view.colourBy)};
    if (!(wanted == beadColours))
      setColours(beads, coloursOf(paths->values, wanted.colourBy, 2));
    beadColours = wanted;
    const VisibleBeads visible = visibleBeads(*paths, view);
    beads.mapper->setStretches(visible.stretches);
    const double scale = view.beads ? 1.0 : kLineBeadScale;
    setBeadScale(beads.actor, scale, scale * visible.everyLayer);
    setBackBeadsHidden(beads.actor,
                       view.dragging && view.beads && view.firstLayer <= 0 && !view.sectionOn);
    if (view.travels)
      travels.mapper->setStretches(visibleTravels(*paths, view));
  }

  void showMarker() {
    marker.actor->SetVisibility(view.marker.has_value());
    markerRim.actor->SetVisibility(view.marker.has_value());
  }

  // A box that is being turned would be that of another orientation.
  void showSizes() {
    Eigen::AlignedBox3d box;
    const Eigen::Matrix3d moved = moved_T_part.linear();
    const bool turned = !moved.isDiagonal(1e-9);
    if (view.partSize && part && !part->box.isEmpty() && !turned) {
      box.extend(moved_T_part * part->box.min());
      box.extend(moved_T_part * part->box.max());
    }
    // A plate that is made for the part has no size of its own to show.
    constexpr double kSameMm = 2.0;
    const bool plate =
        view.plateRuled && shows(view.platform, platform.get()) && !platform->rod &&
        (!part || ((platform->box.sizes() - part->box.sizes()).head<2>().array() > kSameMm).any());
    sizeMarks->show(box, plate ? platform->polygon : std::vector<Eigen::Vector2d>{}, world_T_work);
  }

  void showPieces() {
    if (shows(view.pieces, pieces.get()))
      pieceActors->show(view, world_T_work);
    else
      pieceActors->hide();
  }

  void showRegions() {
    if (shows(view.regions, regions.get()))
      regionActors->show(view, world_T_work);
    else
      regionActors->hide();
  }

  void cut() {
    if (view.sectionOn) {
      const Eigen::Vector3d origin = world_T_work * view.sectionOrigin;
      const Eigen::Vector3d normal = world_T_work.linear() * view.sectionNormal;
      section->SetOrigin(origin.x(), origin.y(), origin.z());
      section->SetNormal(-normal.x(), -normal.y(), -normal.z());
    }
    std::vector<vtkActor*> actors = cutActors();
    actors.insert(actors.end(), {partSurface.Get(), partEdges.Get()});
    for (const auto& more : {pieceActors->actors(), otherParts->actors(), regionActors->actors()})
      actors.insert(actors.end(), more.begin(), more.end());
    cutBy(view.sectionOn ? section.Get() : nullptr, actors);
  }

  void applyView() {
    poseAll();
    showPart();
    platformActors->show(view, shows(view.cell, cell.get()));
    showVoxels();
    showPieces();
    showRegions();
    showLayers();
    showPaths();
    // The drawing of a rod shows its profile and its rotation; the cell's body is a plain cylinder.
    cellActors->show(view, platformActors->showsRod());
    showMarker();
    cut();
    showSizes();
    overlay->showTriad(view.axes);
    overlay->setLegend(view.legend ? legend(theme) : Legend{});
    renderer->SetUseFXAA(!view.dragging);
    occlusion->show(view.ambientOcclusion);
  }

  void prepareFrame() {
    if (view.marker) {
      const Eigen::Vector3d place = world_T_work * *view.marker;
      const Eigen::Affine3d facing =
          Eigen::Translation3d(place) *
          geometry::shortestRotation(Eigen::Vector3d::UnitZ(), scene::towardsEye(renderer)) *
          Eigen::Scaling(kMarkerShare * pictureHeightMm(renderer, place));
      for (vtkActor* actor : {marker.actor.Get(), markerRim.actor.Get()})
        setPose(actor, facing);
    }
    const Eigen::Vector3d eye =
        world_T_work.inverse() * Eigen::Vector3d(renderer->GetActiveCamera()->GetPosition());
    platformActors->lookFrom(eye);
    cellActors->setSeenThrough(view.world == World::Work && eye.z() < 0.0);
    renderer->ResetCameraClippingRange();
    pieceLabels->update(view, world_T_work);
    sizeMarks->update();
    overlay->update();
    occlusion->update(pictureHeightMm(renderer, world_T_work.translation()));
  }

  // Box of everything visible except the cell, in the world frame.
  Eigen::AlignedBox3d printedBox(bool withPlatform = true) const {
    Eigen::AlignedBox3d box;
    const auto extend = [&](const Eigen::AlignedBox3d& inWork) {
      for (int corner = 0; corner < 8 && !inWork.isEmpty(); ++corner)
        box.extend(world_T_work *
                   inWork.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    };
    if (shows(view.part, part.get()))
      extend(part->box);
    for (const auto& other : others)
      if (withPlatform && shows(view.otherParts, other.get()))
        extend(other->box);
    if (const VoxelDrawing* drawing = shownVoxels())
      extend(drawing->box);
    if (shows(view.pieces, pieces.get())) {
      const std::vector<Eigen::Vector3d> offsets = pieceOffsets(*pieces, view.explodeMm);
      for (std::size_t i = 0; i < offsets.size(); ++i)
        extend(pieces->pieces[i].solid->box.translated(offsets[i]));
    }
    if (shows(view.layers, layers.get()))
      extend(layers->box);
    if (shows(view.paths, paths.get()))
      extend(paths->box);
    if (withPlatform && shows(view.platform, platform.get()))
      extend(platform->box);
    if (withPlatform && platformActors->showsRod() &&
        (!view.cell || view.cellDimmed || cellActors->box().isEmpty()))
      extend(platformActors->rodBeside(box));
    return box;
  }

  void frameAll() const {
    const Eigen::AlignedBox3d printed = printedBox();
    if (!shows(view.cell, cell.get()) || view.cellDimmed)
      frameBox(renderer, printed, covered);
    else if (view.cellFramed)
      frameBox(renderer, printed.merged(cellActors->box()), covered);
    else
      frameBox(renderer, printInMachine(printed, cellActors->box()), covered, printed);
  }
};

Scene::Scene(const Theme& theme) : impl_(std::make_unique<Impl>(theme)) {
  impl_->applyView();
  standardView(StandardView::Isometric);
}
Scene::~Scene() = default;

vtkRenderer* Scene::renderer() {
  return impl_->renderer;
}

void Scene::setTheme(const Theme& theme) {
  impl_->theme = theme;
  impl_->applyTheme();
}

void Scene::setPart(std::shared_ptr<const PartDrawing> part) {
  setData(impl_->partSurface, part ? part->surface.Get() : nullptr);
  setData(impl_->partEdges, part ? part->edges.Get() : nullptr);
  impl_->part = std::move(part);
  impl_->applyView();
}

void Scene::setOtherParts(std::vector<std::shared_ptr<const PartDrawing>> parts) {
  impl_->otherParts->setDrawings(parts);
  impl_->others = std::move(parts);
  impl_->applyView();
}

void Scene::setPartPreview(const Eigen::Affine3d& moved_T_part) {
  impl_->moved_T_part = moved_T_part;
  impl_->applyView();
}

void Scene::setPlatform(std::shared_ptr<const PlatformDrawing> platform) {
  impl_->platformActors->setDrawing(platform.get());
  impl_->platform = std::move(platform);
  impl_->applyView();
}

void Scene::setVoxels(std::shared_ptr<const VoxelDrawing> voxels) {
  impl_->byLayer->setDrawing(voxels.get());
  impl_->voxels = std::move(voxels);
  impl_->applyView();
}

void Scene::setGrowth(std::shared_ptr<const VoxelDrawing> growth) {
  impl_->bySteps->setDrawing(growth.get());
  impl_->growth = std::move(growth);
  impl_->applyView();
}

void Scene::setFront(std::shared_ptr<const FrontDrawing> front) {
  setData(impl_->frontSurface, front ? front->surface.Get() : nullptr);
  setData(impl_->frontEdges, front ? front->edges.Get() : nullptr);
  impl_->front = std::move(front);
  impl_->applyView();
}

void Scene::setLayers(std::shared_ptr<const LayersDrawing> layers) {
  impl_->slabs.setData(layers ? layers->surface.Get() : nullptr);
  impl_->slabColours = {};
  impl_->layers = std::move(layers);
  impl_->applyView();
}

void Scene::setPieces(std::shared_ptr<const PiecesDrawing> pieces) {
  impl_->pieceActors->setDrawing(pieces.get());
  impl_->pieceLabels->setDrawing(pieces.get());
  impl_->pieces = std::move(pieces);
  impl_->applyView();
}

void Scene::setRegions(std::shared_ptr<const RegionsDrawing> regions) {
  impl_->regionActors->setDrawing(regions.get());
  impl_->regions = std::move(regions);
  impl_->applyView();
}

void Scene::setPaths(std::shared_ptr<const PathsDrawing> paths) {
  impl_->beads.setData(paths ? paths->beads.Get() : nullptr);
  impl_->travels.setData(paths ? paths->travels.Get() : nullptr);
  impl_->insertActors->setDrawing(paths.get());
  impl_->beadColours = {};
  impl_->paths = std::move(paths);
  impl_->applyView();
}

void Scene::setReach(std::shared_ptr<const ReachDrawing> reach) {
  impl_->platformActors->setReach(reach.get());
  impl_->reach = std::move(reach);
  impl_->applyView();
}

void Scene::setCell(std::shared_ptr<const CellDrawing> cell) {
  impl_->cellActors->setDrawing(cell.get());
  impl_->cell = std::move(cell);
  impl_->applyView();
}

void Scene::setTrace(const std::vector<LineGroup>& lines) {
  std::vector<const LineGroup*> groups;
  for (const LineGroup& group : lines)
    groups.push_back(&group);
  impl_->trace->show(groups);
}

void Scene::setView(const ViewState& view) {
  impl_->view = view;
  impl_->applyView();
}

const ViewState& Scene::view() const {
  return impl_->view;
}

void Scene::setPixelRatio(double ratio) {
  impl_->overlay->setPixelRatio(ratio);
  impl_->sizeMarks->setPixelRatio(ratio);
  impl_->pieceLabels->setPixelRatio(ratio);
}

Legend Scene::legend() const {
  return impl_->legend(impl_->theme);
}

void Scene::setCovered(std::vector<Eigen::AlignedBox2d> covered) {
  impl_->covered = std::move(covered);
}

void Scene::frameAll() {
  impl_->frameAll();
}

void Scene::framePart() {
  frameBox(impl_->renderer, impl_->printedBox(false), impl_->covered);
}

std::vector<std::string> Scene::sizeLabels() const {
  return impl_->sizeMarks->shown();
}

void Scene::standardView(StandardView view) {
  lookFrom(impl_->renderer, view);
  frameAll();
}

void Scene::lookAt(const Eigen::Vector3d& pointInWork, double radiusMm) {
  scene::lookAt(impl_->renderer, impl_->world_T_work * pointInWork, radiusMm);
}

Eigen::Vector3d Scene::towardsEye() const {
  return scene::towardsEye(impl_->renderer).normalized();
}

Eigen::Vector3d Scene::directionInWork(const Eigen::Vector3d& inWorld) const {
  return impl_->world_T_work.linear().transpose() * inWorld;
}

Between Scene::between(const Eigen::Vector3d& placeInWork, const Eigen::Vector3d& towardsEye,
                       double radiusMm, bool printed) const {
  constexpr double kTouchingMm = 2.0; // near a bead printed at the place
  constexpr double kAroundEye = 1.15; // also excludes objects directly behind the eye
  const Eigen::Vector3d direction = directionInWork(towardsEye).normalized();
  const double distance = lookingDistance(impl_->renderer, radiusMm);
  return impl_->between({placeInWork + kTouchingMm * direction, direction},
                        kAroundEye * distance - kTouchingMm, printed);
}

void Scene::cameraMoved() {
  impl_->renderer->ResetCameraClippingRange();
}

std::optional<Hit> Scene::pick(int x, int y) const {
  const Impl& s = *impl_;
  const Eigen::Isometry3d work_T_world = s.world_T_work.inverse();
  const Eigen::Vector3d from = work_T_world * pointAt(s.renderer, x, y, 0.0);
  const Eigen::Vector3d to = work_T_world * pointAt(s.renderer, x, y, 1.0);
  if (!from.allFinite() || !to.allFinite() || (to - from).norm() == 0.0)
    return std::nullopt;
  const auto best = s.nearest({from, (to - from).normalized()});
  return best ? std::optional(best->hit) : std::nullopt;
}

} // namespace voluta::scene
