// Finds places where a part is thinner than a given width.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::voxel {

// A place where walls are thin.
struct ThinPlace {
  // The thinnest point of the place on the surface [mm]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double minMm = 0.0;   // Thickness there
  double usualMm = 0.0; // Median over the place's area
  double areaMm2 = 0.0; // Surface area over thin walls
  std::size_t facets = 0;
};

// Returns places thinner than `width`, largest area first. Thickness is measured from points of
// each facet straight inwards to a facet that faces the opposite way within 25 degrees, so that
// sharp edges do not count; places smaller than one square of `width` are dropped. Points are at
// most about `width` apart, until there are 60,000. An open sheet has no thickness. Preconditions
// (Error{Internal}): width > 0; coordinates finite. Throws Cancelled.
//
// `layerMm`: the part is made of horizontal layers at least that high. Then only those places are
// thin whose horizontal section is narrower than `width`, or that are lower than a layer: a plate
// of one layer is not.
std::vector<ThinPlace> thinPlaces(const geometry::TriangleMesh& mesh, double width,
                                  const base::RunContext& ctx,
                                  std::optional<double> layerMm = std::nullopt);

} // namespace voluta::voxel
