// The surface around which layers are wound.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"
#include "platform/rod_shape.h"
#include "substrate/ground_distance.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::substrate {

// The outer surface of a rod on the x axis, and of an optional body on it. Copies are cheap; safe
// to use from many threads at once.
class RodSurface {
public:
  // Throws as checkRod. Implicit: a rod is a RodSurface.
  RodSurface(const platform::RodShape& rod);
  // Precondition: the body is closed and faces outward, and its components are disjoint.
  RodSurface(const platform::RodShape& rod, std::shared_ptr<const geometry::TriangleMesh> body);

  const platform::RodShape& rod() const { return rod_; }
  const GroundDistance& distance() const { return distance_; }

  // Returns how far a point is above the surface along its radius [mm]; negative inside.
  double over(const Eigen::Vector3d& p) const;
  // Returns the range of radii over [x0, x1] and all around; with a body, over samples one degree
  // and kSampleMm apart. Precondition: the range intersects the rod.
  platform::RadiusRange radiiBetween(double x0, double x1) const;
  // Returns closed solids whose union is the rod with its body, to be subtracted from a part.
  std::vector<geometry::TriangleMesh> solids() const;

  static constexpr double kSampleMm = 0.5;

private:
  double radiusAt(double x, double angle) const;

  platform::RodShape rod_;
  std::shared_ptr<const geometry::TriangleMesh> body_;
  std::shared_ptr<const geometry::MeshQuery> query_; // Of the body
  double beyondMm_ = 0.0;                            // Larger than any radius of the body
  GroundDistance distance_;
};

} // namespace voluta::substrate
