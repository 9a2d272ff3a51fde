// A level surface before it becomes patches: the modes' input to trimming.
#pragma once

#include "geometry/triangle_mesh.h"
#include "layers/chart.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace voluta::layers {

struct Patch;

// The mid-surface of one level with its attributes per vertex (as in Patch). It may have several
// components and, before trimming, extends beyond the part.
struct LevelSurface {
  geometry::TriangleMesh surface;              // counter-clockwise seen against `direction`
  std::vector<double> thicknessMm;             // > 0, as given by the field: not yet clamped
  std::vector<Eigen::Vector3d> direction;      // unit
  std::vector<Eigen::Vector3d> clearDirection; // unit
  // 1: on a rim where the level ends inside the part because another level continues. Empty: none.
  std::vector<std::uint8_t> innerRim;
  Chart chart;
  int level = 0;
};

// Appends the vertex (1 - t) a + t b on the segment between vertices a and b with interpolated
// attributes; returns its index. Directions remain unit vectors; the vertex is on the inner rim
// only if both ends are.
int appendBlend(LevelSurface& surface, int a, int b, double t);

// Appends a vertex at `position` with attributes interpolated by `weights` over the corners of a
// triangle (weights sum to 1); returns its index.
int appendBlend(LevelSurface& surface, const std::array<int, 3>& corners,
                const Eigen::Vector3d& weights, const Eigen::Vector3d& position);

// Keeps the part of the surface with values >= 0 (one value per vertex, linear in between):
// triangles are cut, and the new boundary is an inner rim.
void keepPositive(LevelSurface& surface, const std::vector<double>& values);

// Returns the surface of a patch.
LevelSurface surfaceOf(const Patch& patch);
// Gives a patch the layer, group, item, region and tool of another one.
void takePlace(Patch& patch, const Patch& of);
// Gives a patch the surface with its attributes per vertex; its other members stay.
void setSurface(Patch& patch, LevelSurface surface);

// Drops vertices that no triangle uses; the order of the others is kept.
void dropUnusedVertices(LevelSurface& surface);

} // namespace voluta::layers
