// One picture: drawings, a view on them and a camera, as a VTK renderer. Belongs to one thread;
// needs a rendering context only when its renderer is drawn.
#pragma once

#include "scene/camera.h"
#include "scene/colouring.h"
#include "scene/drawings.h"
#include "scene/hit.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace voluta::scene {

class Scene {
public:
  explicit Scene(const Theme& theme);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // To be added to one render window. Owned by the scene.
  vtkRenderer* renderer();

  void setTheme(const Theme& theme);

  // Null: not there. What a view asks for and is not there is not drawn.
  void setPart(std::shared_ptr<const PartDrawing> part);
  // Draws the part moved, until it is set again: while handles are dragged. Picks, sections and
  // frames are of the part where it was.
  void setPartPreview(const Eigen::Affine3d& moved_T_part);
  void setPlatform(std::shared_ptr<const PlatformDrawing> platform);
  void setVoxels(std::shared_ptr<const VoxelDrawing> voxels);
  // Voxels by growth step (VoxelLook::bySteps), and the convex front of the step on show.
  void setGrowth(std::shared_ptr<const VoxelDrawing> growth);
  void setFront(std::shared_ptr<const FrontDrawing> front);
  void setLayers(std::shared_ptr<const LayersDrawing> layers);
  void setPieces(std::shared_ptr<const PiecesDrawing> pieces);
  void setPaths(std::shared_ptr<const PathsDrawing> paths);
  void setReach(std::shared_ptr<const ReachDrawing> reach);
  void setCell(std::shared_ptr<const CellDrawing> cell);

  // Cheap; draws nothing by itself.
  void setView(const ViewState& view);
  const ViewState& view() const;
  // Pixels a point of text and an overlay's line take: the screen's device pixel ratio.
  void setPixelRatio(double ratio);

  // Parts of the picture that something lies over, in pixels from the lower left corner: frameAll()
  // keeps clear of them as far as it can.
  void setCovered(std::vector<Eigen::AlignedBox2d> covered);

  // Of what is shown under the view: voxels before pieces before layers before paths, whichever is
  // visible.
  Legend legend() const;

  // Camera. All keep the projection; frameAll and standardView see everything that is visible.
  void frameAll();
  void standardView(StandardView view);
  void lookAt(const Eigen::Vector3d& pointInWork, double radiusMm);
  // From what is looked at to the eye: world, unit.
  Eigen::Vector3d towardsEye() const;
  Eigen::Vector3d directionInWork(const Eigen::Vector3d& inWorld) const;
  // What is drawn between a place and an eye in that direction of the world, as far away as
  // lookAt(placeInWork, radiusMm) puts it; what touches the place is not between. `printed`: is
  // material looked at too, which takes longer?
  Between between(const Eigen::Vector3d& placeInWork, const Eigen::Vector3d& towardsEye,
                  double radiusMm, bool printed) const;
  // Call after the camera was moved from outside (an interactor).
  void cameraMoved();

  // What is drawn at a pixel (x to the right, y upwards from the lower left corner of the
  // renderer's window), nearest first; nothing when it is background. Needs no rendering context.
  std::optional<Hit> pick(int x, int y) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace voluta::scene
