// Nearest intersections of a ray with drawings. All in the work frame and computed from the
// drawings' data, without a rendering context.
#pragma once

#include "scene/drawing_data.h"
#include "scene/hit.h"

#include <Eigen/Geometry>
#include <functional>
#include <optional>

namespace voluta::scene {

struct Ray {
  Eigen::Vector3d origin, direction; // direction: unit
  Eigen::Vector3d at(double t) const { return origin + t * direction; }
};

struct RayHit {
  double t = 0.0;
  Hit hit;
};

// Returns whether a point is visible, i.e. not on the side that the section cuts away.
using IsShown = std::function<bool(const Eigen::Vector3d&)>;

std::optional<RayHit> pickPart(const PartDrawing& part, const Ray& ray, const IsShown& shown);
// `parts`: by item of the job; null: none.
std::optional<RayHit> pickOther(const std::vector<std::shared_ptr<const PartDrawing>>& parts,
                                const Ray& ray, const IsShown& shown);
std::optional<RayHit> pickPlatform(const PlatformDrawing& platform, const Ray& ray);
// Layers first <= layer <= last.
std::optional<RayHit> pickVoxel(const VoxelDrawing& voxels, const Ray& ray, int first, int last,
                                const IsShown& shown);
// `offsets`: displacement of each drawn piece from its position on the part.
std::optional<RayHit> pickPiece(const PiecesDrawing& pieces, const Ray& ray,
                                const std::vector<Eigen::Vector3d>& offsets, const IsShown& shown);
// Tests the triangles of the stretches.
std::optional<RayHit> pickLayer(const LayersDrawing& layers, const Ray& ray,
                                const std::vector<Stretch>& stretches, const IsShown& shown);
// Tests the segments of the stretches (two triangles each).
std::optional<RayHit> pickPath(const PathsDrawing& paths, const Ray& ray,
                               const std::vector<Stretch>& stretches, const IsShown& shown);
// Poses of all frames of the cell in the work frame. `body`: index in Cell::bodies().
std::optional<RayHit> pickBody(const CellDrawing& cell, std::size_t body,
                               const std::vector<Eigen::Isometry3d>& work_T_frame, const Ray& ray);

} // namespace voluta::scene
