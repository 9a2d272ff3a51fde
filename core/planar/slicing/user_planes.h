// Layers on planes or quadrilaterals that the user specifies; the part is not decomposed.
#pragma once

#include "planar/slicing/slicing.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voluta::planar {

// The mid-surface of a layer. A quadrilateral cuts only within its corners, so that several layers
// may be side by side (Castelli 4.3).
struct UserPlane {
  Plane plane; // its normal is the layer's print direction
  // Four, convex, counter-clockwise seen against the normal; none: the whole plane
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d point = Eigen::Vector3d::Zero(); // as given; of a quadrilateral its centre
};

// Parses a JSON list in print order, mm in the work frame, of
//   {"point": [x, y, z], "normal": [x, y, z]}   a plane
//   {"corners": [[x, y, z], ... four of them]}  a quadrilateral, convex, flat within 0.01 mm
//   `where`: source of the text for error messages. Throws Error{UnusableInput} that names the
//   entry.
std::vector<UserPlane> readUserPlanes(const std::string& json, const std::string& where);

// Makes one layer per plane, in the order given: the section of the part. The thickness at a vertex
// is its distance along the layer's normal to the nearest earlier layer below, or twice its height
// above the plate. Findings report planes that miss the part, thickness outside the limits and
// unsupported layers. All patches are in group 0. Precondition: `part` is closed and faces outward.
// Throws as slicePieces().
SliceResult sliceByPlanes(const geometry::TriangleMesh& part, const std::vector<UserPlane>& planes,
                          const SliceOptions& options, const base::RunContext& ctx);

} // namespace voluta::planar
