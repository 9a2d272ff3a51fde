// A solid that crosses itself. mm.
#pragma once

#include "helpers/shapes.h"

namespace voluta::test {

// Two wedges edge to edge, together `length` long, of ends `first` and `second` wide: the sides
// cross, and the second wedge faces inside out. Its share of the enclosed volume is second^2 /
// (first^2 + second^2).
inline geometry::TriangleMesh bowTie(const Eigen::Vector3d& low, double length, double first,
                                     double second, double height) {
  geometry::TriangleMesh m = box({0, -0.5 * first, 0}, {length, 0.5 * first, height});
  for (Eigen::Vector3d& v : m.vertices) {
    if (v.x() > 0.0)
      v.y() *= -second / first;
    v += low;
  }
  return m;
}

} // namespace voluta::test
