// Mid-surfaces of layers that follow a given surface, to be trimmed by the part.
#pragma once

#include "base/run_context.h"
#include "layers/level_surface.h"
#include "substrate/flatten.h"
#include "substrate/ground_distance.h"

#include <Eigen/Geometry>
#include <memory>

namespace voluta::substrate {

// All functions: vertices are on the level up to rounding, directions are along the level's normal
// and away from the ground, edges are about edgeMm and short enough to keep chords within 0.002 mm.
// Level::level stays 0. Precondition: positive lengths.

// Around the x axis, closed without a seam, over [x0, x1]. Its chart is the unrolled cylinder (u =
// radius * angle from y to z, v = x).
layers::LevelSurface cylinderLevel(double radiusMm, double thicknessMm, double x0, double x1,
                                   double edgeMm);

// The part of a sphere that intersects the box, slightly extended: material grows outwards (SCL,
// Castelli 1.3.3).
layers::LevelSurface sphereLevel(const Eigen::Vector3d& centre, double radiusMm, double thicknessMm,
                                 const Eigen::AlignedBox3d& box, double edgeMm);

// The points at `distanceMm` from a ground, outside it and in the box: fronts do not fold in
// valleys and are rounded over crests. Directions point away from the nearest point; in a crease
// they are between its two sides. Marching tetrahedra on a grid of edgeMm, with vertices on the
// level; chord errors over crests are those of the grid. Throws Cancelled.
layers::LevelSurface offsetLevel(const GroundDistance& ground, double distanceMm,
                                 double thicknessMm, const Eigen::AlignedBox3d& box, double edgeMm,
                                 const base::RunContext& ctx);

// The same at several distances, sharing the distances at the grid's points. Safe to use from many
// threads at once; copies share the computed distances.
class OffsetLevels {
public:
  OffsetLevels(GroundDistance ground, const Eigen::AlignedBox3d& box, double edgeMm);
  layers::LevelSurface at(double distanceMm, double thicknessMm, const base::RunContext& ctx) const;

private:
  class Grid;
  std::shared_ptr<Grid> grid_;
};

// The surface halfway between two circles of flatteningToPlane, along the
// radii of the first, which are also the directions; extruded along x over [x0, x1] and restricted
// to the area within halfWidthMm of y = 0 on the first circle's upper half. The thickness is
// thicknessAt, so that the bottoms are on the first circle and the tops on the second.
// Preconditions: the first is not a plane, halfWidthMm is less than its radius; the second is
// everywhere outside the first.
layers::LevelSurface circleLevel(const FlatteningCircle& lower, const FlatteningCircle& upper,
                                 double halfWidthMm, double x0, double x1, double edgeMm);

} // namespace voluta::substrate
