// What layers wind around.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"
#include "platform/rod_shape.h"
#include "substrate/ground_distance.h"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace voluta::substrate {

// The outer surface of a rod on the x axis, and of a body on it where there is one. Copies are
// cheap; safe from many threads at once.
class RodSurface {
public:
  // Throws as checkRod. Implicit: a rod is one.
  RodSurface(const platform::RodShape& rod);
  // Precondition: the body is closed, outward, its components apart.
  RodSurface(const platform::RodShape& rod, std::shared_ptr<const geometry::TriangleMesh> body);

  const platform::RodShape& rod() const { return rod_; }
  const GroundDistance& distance() const { return distance_; }

  // How far a point is over it along its radius, mm; negative inside.
  double over(const Eigen::Vector3d& p) const;
  // Over [x0, x1] and all around; where there is a body, of samples a degree and kSampleMm apart.
  // Precondition: the range meets the rod.
  platform::RadiusRange radiiBetween(double x0, double x1) const;
  // Closed solids that are it together, to be taken out of a part.
  std::vector<geometry::TriangleMesh> solids() const;

  static constexpr double kSampleMm = 0.5;

private:
  double radiusAt(double x, double angle) const;

  platform::RodShape rod_;
  std::shared_ptr<const geometry::TriangleMesh> body_;
  std::shared_ptr<const geometry::MeshQuery> query_; // of the body
  double beyondMm_ = 0.0;                            // farther out than the body
  GroundDistance distance_;
};

} // namespace voluta::substrate
