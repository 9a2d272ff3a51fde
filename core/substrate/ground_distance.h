// How far points are from what layers grow on.
#pragma once

#include "geometry/triangle_mesh.h"
#include "platform/rod_shape.h"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace voluta::substrate {

// Both called from many threads at once.
struct GroundDistance {
  // The point of the surface nearest to a point outside; of one inside a point of the surface.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> nearest;
  std::function<bool(const Eigen::Vector3d&)> isInside;

  double unsignedMm(const Eigen::Vector3d& p) const { return (p - nearest(p)).norm(); }
  // Negative inside, where it is only a bound.
  double signedMm(const Eigen::Vector3d& p) const {
    return isInside(p) ? -unsignedMm(p) : unsignedMm(p);
  }
  // The way from the nearest point; zero on the surface.
  Eigen::Vector3d outward(const Eigen::Vector3d& p) const { return (p - nearest(p)).normalized(); }
};

// Copies what it needs. Precondition: closed, outward, its components apart.
GroundDistance distanceFrom(const geometry::TriangleMesh& body);
// In closed form for round rods of any profile and for prisms, stepped ones too; the mesh of others
// (prisms that taper) is asked. Precondition: checkRod.
GroundDistance distanceFrom(const platform::RodShape& rod);
// From all of several. Precondition: at least one.
GroundDistance nearestOf(std::vector<GroundDistance> grounds);

} // namespace voluta::substrate
