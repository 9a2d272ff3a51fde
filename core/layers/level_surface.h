// A level surface on its way to becoming patches: what modes hand to trimming.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/chart.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace voluta::layers {

// The mid-surface of one level with its attributes per vertex (as in Patch). It may have several
// components and, before trimming, reaches beyond the part.
struct LevelSurface {
  geometry::TriangleMesh surface;              // counter-clockwise seen against `direction`
  std::vector<double> thicknessMm;             // > 0, as the field gives it: not yet clamped
  std::vector<Eigen::Vector3d> direction;      // unit
  std::vector<Eigen::Vector3d> clearDirection; // unit
  // 1: on a rim where the level ends inside the part because another takes over. Empty: nowhere.
  std::vector<std::uint8_t> innerRim;
  Chart chart;
  int level = 0;
};

// Appends the vertex (1 - t) a + t b of the segment between vertices a and b, attributes blended;
// returns its index. Directions stay unit; the vertex is on the inner rim only where both ends are.
int appendBlend(LevelSurface& surface, int a, int b, double t);

// Appends a vertex at `position` with attributes blended by `weights` over the corners of a
// triangle (weights sum to 1); returns its index.
int appendBlend(LevelSurface& surface, const std::array<int, 3>& corners,
                const Eigen::Vector3d& weights, const Eigen::Vector3d& position);

// Keeps what of the surface has values >= 0 (one a vertex, linear between): triangles are cut, the
// new boundary is an inner rim.
void keepPositive(LevelSurface& surface, const std::vector<double>& values);

// Drops vertices that no triangle uses; order of the others is kept.
void dropUnusedVertices(LevelSurface& surface);

} // namespace voluta::layers
