// Layers where the user says: planes, or quadrilaterals, that cut the part unsplit.
#pragma once

#include "planar/slicing/slicing.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::planar {

// The mid-surface of a layer. A quadrilateral cuts only within its corners, so that several layers
// may lie side by side (Castelli 4.3).
struct UserPlane {
  Plane plane;                          // normal: the direction the layer is laid along
  std::vector<Eigen::Vector3d> corners; // four, convex, counter-clockwise seen against the normal;
                                        // none: the whole plane
  Eigen::Vector3d point = Eigen::Vector3d::Zero(); // as given; of a quadrilateral its middle
};

// A JSON list in print order, mm in the work frame, of
//   {"point": [x, y, z], "normal": [x, y, z]}   a plane
//   {"corners": [[x, y, z], ... four of them]}  a quadrilateral, convex, flat within 0.01 mm
// `where` names the text in errors. Throws Error{UnusableInput} that names the entry.
std::vector<UserPlane> readUserPlanes(const std::string& json, const std::string& where);

// One layer a plane, in the order given: the section of the part, thickness at a vertex its
// distance along the layer's normal to the layer before (the nearest earlier one below it) or twice
// its height over the plate. Planes that miss the part, thickness beyond the limits and layers that
// begin in the air are findings. All of group 0. `part` is closed and faces outward. Throws as
// slicePieces().
SliceResult sliceByPlanes(const geometry::TriangleMesh& part, const std::vector<UserPlane>& planes,
                          const SliceOptions& options, const base::RunContext& ctx);

} // namespace voluta::planar
