// Distances of points from the surface on which layers grow.
#pragma once

#include "geometry/triangle_mesh.h"
#include "platform/rod_shape.h"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace voluta::substrate {

// Both functions are called from many threads at once.
struct GroundDistance {
  // Returns the nearest point of the surface for a point outside; some point of the surface for a
  // point inside.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> nearest;
  std::function<bool(const Eigen::Vector3d&)> isInside;

  double unsignedMm(const Eigen::Vector3d& p) const { return (p - nearest(p)).norm(); }
  // Negative inside, where it is only a bound.
  double signedMm(const Eigen::Vector3d& p) const {
    return isInside(p) ? -unsignedMm(p) : unsignedMm(p);
  }
  // Returns the unit direction from the nearest point; zero on the surface.
  Eigen::Vector3d outward(const Eigen::Vector3d& p) const { return (p - nearest(p)).normalized(); }
};

// Copies the data it needs. Precondition: `body` is closed and faces outward, and its components
// are disjoint.
GroundDistance distanceFrom(const geometry::TriangleMesh& body);
// In closed form for round rods of any profile and for prisms, including stepped ones; queries the
// mesh of others (tapered prisms). Precondition: checkRod.
GroundDistance distanceFrom(const platform::RodShape& rod);
// Returns the distance from the union of several grounds. Precondition: at least one.
GroundDistance nearestOf(std::vector<GroundDistance> grounds);

} // namespace voluta::substrate
