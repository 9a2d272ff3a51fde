// Flat coordinates of a layer, in which windings around an axis are straight lines.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

namespace voluta::layers {

// Per vertex (u, v) [mm]: u around the axis, v along it (Castelli, appendix A). u is unique up to
// whole periods; along an edge it changes by less than half a period.
struct Chart {
  std::vector<Eigen::Vector2d> at; // empty: the surface has no chart
  double periodMm = 0.0;           // > 0; 0: u is not periodic

  bool empty() const { return at.empty(); }

  // From vertex a to b, the shorter way around.
  Eigen::Vector2d between(int a, int b) const {
    Eigen::Vector2d d(of(b).x() - of(a).x(), of(b).y() - of(a).y());
    if (periodMm > 0.0)
      d.x() = std::remainder(d.x(), periodMm);
    return d;
  }
  // (1 - t) a + t b.
  Eigen::Vector2d blend(int a, int b, double t) const {
    const Eigen::Vector2d d = between(a, b);
    return {of(a).x() + t * d.x(), of(a).y() + t * d.y()};
  }
  // Weights sum to 1.
  Eigen::Vector2d blend(const std::array<int, 3>& corners, const Eigen::Vector3d& weights) const {
    const Eigen::Vector2d& first = of(corners[0]);
    const Eigen::Vector2d second = between(corners[0], corners[1]),
                          third = between(corners[0], corners[2]);
    return {first.x() + weights.y() * second.x() + weights.z() * third.x(),
            first.y() + weights.y() * second.y() + weights.z() * third.y()};
  }

private:
  const Eigen::Vector2d& of(int vertex) const { return at[static_cast<std::size_t>(vertex)]; }
};

} // namespace voluta::layers
