// Distances between convex solids without a closed form here, computed by FCL.
#pragma once

#include "robot/body.h"

#include <Eigen/Geometry>
#include <memory>

namespace voluta::collision {

// A polyhedron around a box, frustum or prism (round sides become 48 planes, at most 0.22 % further
// out). Immutable; queries may run in parallel.
class Polyhedron {
public:
  // Precondition: not a capsule.
  explicit Polyhedron(const robot::Shape& shape);
  ~Polyhedron();
  Polyhedron(Polyhedron&&) noexcept;

  // Returns the distance of two polyhedra in a common frame; <= 0 if they overlap. mm.
  static double distance(const Polyhedron& a, const Eigen::Isometry3d& frame_T_a,
                         const Polyhedron& b, const Eigen::Isometry3d& frame_T_b);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace voluta::collision
