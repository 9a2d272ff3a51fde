// One picture: drawings, a view of them and a camera, as a VTK renderer. Not thread-safe; needs a
// rendering context only while its renderer draws.
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
#include <string>
#include <vector>

class vtkRenderer;

namespace voluta::scene {

struct LineGroup;

class Scene {
public:
  explicit Scene(const Theme& theme);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  // For one render window. Owned by the scene.
  vtkRenderer* renderer();

  void setTheme(const Theme& theme);

  // Null: not present. Whatever a view selects but is not present is not drawn.
  void setPart(std::shared_ptr<const PartDrawing> part);
  // Draws the other parts of a job, one entry per item; null for the active one.
  void setOtherParts(std::vector<std::shared_ptr<const PartDrawing>> parts);
  // Draws the part moved, until it is set again: for dragging handles. Picks, sections and framing
  // use the part's original position.
  void setPartPreview(const Eigen::Affine3d& moved_T_part);
  void setPlatform(std::shared_ptr<const PlatformDrawing> platform);
  void setVoxels(std::shared_ptr<const VoxelDrawing> voxels);
  // Voxels by growth step (VoxelLook::bySteps), and the convex front of the current step.
  void setGrowth(std::shared_ptr<const VoxelDrawing> growth);
  void setFront(std::shared_ptr<const FrontDrawing> front);
  void setLayers(std::shared_ptr<const LayersDrawing> layers);
  void setPieces(std::shared_ptr<const PiecesDrawing> pieces);
  // Of the active part.
  void setRegions(std::shared_ptr<const RegionsDrawing> regions);
  void setPaths(std::shared_ptr<const PathsDrawing> paths);
  void setReach(std::shared_ptr<const ReachDrawing> reach);
  void setCell(std::shared_ptr<const CellDrawing> cell);
  // Lines of the work frame, over the other drawings; empty: none.
  void setTrace(const std::vector<LineGroup>& lines);

  // Fast; does not draw by itself.
  void setView(const ViewState& view);
  const ViewState& view() const;
  // Sets the number of pixels per point of text and of overlay lines: the screen's device pixel
  // ratio.
  void setPixelRatio(double ratio);

  // Sets the regions of the picture that widgets cover, in pixels from the lower left corner;
  // frameAll() avoids them as far as possible.
  void setCovered(std::vector<Eigen::AlignedBox2d> covered);

  // Returns the labels on display: edges of the part's box, size of the plate, its origin.
  std::vector<std::string> sizeLabels() const;

  // Returns the legend for the current view: voxels before pieces before layers before paths,
  // whichever is visible.
  Legend legend() const;

  // Camera functions. All keep the projection; frameAll and standardView show everything that is
  // visible.
  void frameAll();
  // Frames the active part, or the print if that is shown.
  void framePart();
  void standardView(StandardView view);
  void lookAt(const Eigen::Vector3d& pointInWork, double radiusMm);
  // Returns the unit vector from the focal point to the eye, in the world frame.
  Eigen::Vector3d towardsEye() const;
  Eigen::Vector3d directionInWork(const Eigen::Vector3d& inWorld) const;
  // Returns the objects between a place and an eye in that direction of the world, at the distance
  // of lookAt(placeInWork, radiusMm); objects that touch the place do not count. `printed`: also
  // checks printed material, which takes longer.
  Between between(const Eigen::Vector3d& placeInWork, const Eigen::Vector3d& towardsEye,
                  double radiusMm, bool printed) const;
  // Call after moving the camera from outside (an interactor).
  void cameraMoved();

  // Returns the nearest object drawn at a pixel (x to the right, y upwards from the lower left
  // corner of the renderer's window); nullopt for background. Needs no rendering context.
  std::optional<Hit> pick(int x, int y) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace voluta::scene
