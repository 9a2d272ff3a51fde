// Mid-surfaces of layers that follow a given surface, to be trimmed by the part.
#pragma once

#include "base/run_context.h"
#include "layers/level_surface.h"
#include "substrate/flatten.h"
#include "substrate/ground_distance.h"

#include <Eigen/Geometry>
#include <memory>

namespace voluta::substrate {

// All of them: vertices on the level to rounding, directions along the level's normal and away from
// what lies under it, edges about edgeMm and short enough for chords to stay within 0.002 mm.
// Level::level is left 0. Precondition of all: positive lengths.

// About the x axis, closed around without a seam, over [x0, x1]; its chart is the cylinder unrolled
// (u = radius * angle from y to z, v = x).
layers::LevelSurface cylinderLevel(double radiusMm, double thicknessMm, double x0, double x1,
                                   double edgeMm);

// The part of a sphere that the box meets, and a little around it: material grows outwards (SCL,
// Castelli 1.3.3).
layers::LevelSurface sphereLevel(const Eigen::Vector3d& centre, double radiusMm, double thicknessMm,
                                 const Eigen::AlignedBox3d& box, double edgeMm);

// Points at `distanceMm` from a ground, outside it, in the box: fronts do not fold in valleys and
// are rounded over crests. Directions lead away from the nearest point, in a crease between its two
// sides. Marching tetrahedra on a grid of edgeMm, vertices on the level; chords over crests are
// those of the grid. Throws Cancelled.
layers::LevelSurface offsetLevel(const GroundDistance& ground, double distanceMm,
                                 double thicknessMm, const Eigen::AlignedBox3d& box, double edgeMm,
                                 const base::RunContext& ctx);

// The same at several distances: those of the grid's points are found once for all of them. Safe
// from many threads at once; copies share what was found.
class OffsetLevels {
public:
  OffsetLevels(GroundDistance ground, const Eigen::AlignedBox3d& box, double edgeMm);
  layers::LevelSurface at(double distanceMm, double thicknessMm, const base::RunContext& ctx) const;

private:
  class Grid;
  std::shared_ptr<Grid> grid_;
};

// Half-way between two circles of flatteningCircles or flatteningToPlane along the radii of the
// first, which are the directions; drawn out along x over [x0, x1], over what of the first circle's
// upper half lies within halfWidthMm of y = 0. Thickness is thicknessAt, so that feet lie on the
// first circle and tops on the second. Preconditions: the first is no plane, halfWidthMm less than
// its radius; the second is beyond it all over.
layers::LevelSurface circleLevel(const FlatteningCircle& lower, const FlatteningCircle& upper,
                                 double halfWidthMm, double x0, double x1, double edgeMm);

} // namespace voluta::substrate
