// Patches that lie in a plane, as polygons.
#pragma once

#include "geometry/polygon_paths.h"
#include "layers/layer_stack.h"

#include <Eigen/Core>
#include <optional>

namespace voluta::toolpath {

// A patch in a plane perpendicular to its build direction.
struct PlanePatch {
  // In the plane's frame, whose z is the build direction: outlines counter-clockwise, holes
  // clockwise. Seams are those where another patch continues (layers::Patch::innerRim).
  ClipperLib::Paths outline, seams;
  Eigen::Matrix3d plane_R_work = Eigen::Matrix3d::Identity();
  double heightMm = 0.0; // of the plane along the build direction, from the origin
  double thicknessMm = 0.0;
  // It has one height and one thickness. Otherwise these are those of most of it: places at the
  // bottom of a part may be lower and thicker.
  bool isEven = true;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); // build direction, work frame
  Eigen::Vector3d clearDirection = Eigen::Vector3d::UnitZ();

  // Returns the outline and the seams: together they bound the patch.
  ClipperLib::Paths contours() const;
  // Returns the place in the work frame [mm] of a point of the plane's frame.
  Eigen::Vector3d place(const Eigen::Vector2d& mm) const {
    return plane_R_work.transpose() * Eigen::Vector3d(mm.x(), mm.y(), heightMm);
  }
};

// Returns nullopt if the patch is empty, has a chart or an outline that is a seam in part, if its
// directions vary, or its height by more than its thickness.
std::optional<PlanePatch> planePatch(const layers::Patch& patch);

// Returns a patch over `area`, a part of the plane of `plane`, with the other properties of `like`;
// without a surface if the area is empty. Its rim is an inner rim where it is not on the outline of
// `plane`. Returns nullopt if edges of the area cross.
std::optional<layers::Patch> patchOver(const ClipperLib::Paths& area, const PlanePatch& plane,
                                       const layers::Patch& like);

} // namespace voluta::toolpath
