// Whether the head as it is reaches a piece past what is printed before it.
#pragma once

#include "planar/pieces.h"
#include "process/process.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

// Points on a surface, about one a spacing squared and one a triangle at least.
std::vector<Eigen::Vector3d> surfaceSamples(const geometry::TriangleMesh& mesh, double spacingMm);

// Points all over a convex polygon on z = 0, its rim included.
std::vector<Eigen::Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon,
                                          double spacingMm);

// The share of the tips at which the head, coming along unit `direction`, has an obstacle strictly
// inside it. A piece is laid from its base upwards in layers across its direction, so the tips are
// points all over it and over its base: tips higher up are reached past the same obstacles.
double blockedShare(const std::vector<Eigen::Vector3d>& tips,
                    const std::vector<Eigen::Vector3d>& obstacles, const Eigen::Vector3d& direction,
                    const process::HeadShape& head);

} // namespace voluta::planar
