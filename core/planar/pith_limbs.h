// The limbs of a curve skeleton: its lines between branchings and ends.
#pragma once

#include "geometry/mesh_query.h"
#include "planar/published/skeleton.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

struct Limb {
  std::vector<Eigen::Vector3d> points;       // evenly spaced [mm]
  std::vector<double> partRadiusMm;          // per point: least distance to the surface across
  bool branchesFirst = false, branchesLast = false; // whether other limbs meet at the end
  double lengthMm() const;
};

// Returns the limbs of a skeleton, smoothed, ends of the skeleton extended to the surface. Ends
// that are shorter than the part's radius where they branch off are left out. `spacingMm`: of the
// points. `part`: a query of the solid that the skeleton is of.
std::vector<Limb> limbsOf(const CurveSkeleton& skeleton, const geometry::MeshQuery& part,
                          double spacingMm);

} // namespace voluta::planar
