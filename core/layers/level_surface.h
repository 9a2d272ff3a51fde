// A level surface on its way to becoming patches: what modes hand to trimming.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::layers {

// The mid-surface of one level with its attributes per vertex (as in Patch). It may have several
// components and, before trimming, reaches beyond the part.
struct LevelSurface {
  geometry::TriangleMesh surface;              // counter-clockwise seen against `direction`
  std::vector<double> thicknessMm;             // > 0, as the field gives it: not yet clamped
  std::vector<Eigen::Vector3d> direction;      // unit
  std::vector<Eigen::Vector3d> clearDirection; // unit
  int level = 0;
};

// Appends the vertex (1 - t) a + t b of the segment between vertices a and b, attributes blended;
// returns its index. Directions stay unit.
int appendBlend(LevelSurface& surface, int a, int b, double t);

// Appends a vertex at `position` with attributes blended by `weights` over the corners of a
// triangle (weights sum to 1); returns its index.
int appendBlend(LevelSurface& surface, const std::array<int, 3>& corners,
                const Eigen::Vector3d& weights, const Eigen::Vector3d& position);

// Drops vertices that no triangle uses; order of the others is kept.
void dropUnusedVertices(LevelSurface& surface);

} // namespace voluta::layers
