// The current drawings of a scene under its view, and ray queries.
#pragma once

#include "scene/drawing_data.h"
#include "scene/drawings.h"
#include "scene/hit.h"
#include "scene/pick.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::scene {

// A null drawing is not shown.
struct Drawn {
  ViewState view;
  std::shared_ptr<const PartDrawing> part;
  std::vector<std::shared_ptr<const PartDrawing>> others; // by item of the job; null: none
  std::shared_ptr<const PlatformDrawing> platform;
  std::shared_ptr<const VoxelDrawing> voxels, growth;
  std::shared_ptr<const FrontDrawing> front;
  std::shared_ptr<const LayersDrawing> layers;
  std::shared_ptr<const PathsDrawing> paths;
  std::shared_ptr<const PiecesDrawing> pieces;
  std::shared_ptr<const RegionsDrawing> regions;
  std::shared_ptr<const ReachDrawing> reach;
  std::shared_ptr<const CellDrawing> cell;
  Eigen::Isometry3d world_T_work = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> world_T_frame; // of the cell

  bool shows(bool wanted, const void* drawing) const { return wanted && drawing; }
  bool replaysGrowth() const { return view.growthStep && shows(view.voxels, growth.get()); }
  const VoxelDrawing* shownVoxels() const;
  bool isSeeThrough() const; // of the part
  bool isBodyShown(std::size_t body) const;
  // Precondition: layers are shown. `undersides`: also the faces that face down.
  std::vector<Stretch> layerStretches(bool undersides) const;

  // Returns the legend of the drawing that has one: voxels before pieces, layers and paths.
  Legend legend(const Theme& theme) const;

  // Returns the nearest visible hit. Rays are in the work frame.
  std::optional<RayHit> nearest(const Ray& ray) const;
  // Returns the objects hit within `lengthMm`. `printed`: also tests printed material, which takes
  // longer.
  Between between(const Ray& ray, double lengthMm, bool printed) const;

private:
  // Tests the part, voxels, pieces, layers and paths. `solid`: without transparent ones.
  std::optional<RayHit> nearestPrinted(const Ray& ray, bool solid) const;
  std::vector<Eigen::Isometry3d> framesInWork() const;
};

} // namespace voluta::scene
