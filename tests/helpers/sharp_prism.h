// A part that is safe to print but not as asked: its back edge is sharper than a bead.
#pragma once

#include "helpers/shapes.h"

namespace voluta::test {

inline geometry::TriangleMesh sharpPrism() {
  geometry::TriangleMesh prism = box({-5, -3, 0}, {5, 3, 6});
  for (Eigen::Vector3d& v : prism.vertices)
    if (v.y() > 0.0)
      v.x() *= 1e-3;
  return prism;
}

} // namespace voluta::test
