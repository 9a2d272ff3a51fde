// Layers wound around a rod.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "layers/ground.h"
#include "substrate/level_stack.h"
#include "substrate/overhang.h"
#include "substrate/rod_surface.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::substrate {

// Returns the part without the rod, both in the work frame with the rod's axis on x. Throws
// Error{UnusableInput} if the part is not closed, extends beyond an end of the rod, or does not
// extend beyond the rod's radius.
geometry::TriangleMesh partAroundRod(const geometry::TriangleMesh& part, const RodSurface& rod);

struct LatheOptions : LevelOptions {
  // False: levels at constant radius; true: at constant distance from the rod, for any profile.
  bool followsRod = false;
};

struct LatheLayers : StackedLevels {
  std::vector<double> outerMm; // Per level: its outer radius, or distance from the rod
};

// Returns the outer bounds of the levels of latheLayers, starting with the rod's own: from the rod
// (at its thinnest within the part's length) to the part's farthest point. Throws
// Error{UnusableInput} if the part has no room for a layer over the rod. (Castelli 2020, 5.3.1.)
std::vector<double> latheBounds(const geometry::TriangleMesh& part, const RodSurface& rod,
                                const LatheOptions& options);

// Returns the stacked levels (stackLevels) between latheBounds. `part`: see partAroundRod. Throws
// Error{UnusableInput} as latheBounds, and if no layer of the part rests on the rod; throws
// Cancelled. The result is independent of the number of threads.
// Example:
//   const substrate::RodSurface rod(platform::straightRod(5.0, 200.0));
//   const geometry::TriangleMesh around = substrate::partAroundRod(tube, rod);
//   const substrate::LatheLayers wound = substrate::latheLayers(around, rod, {}, ctx);
LatheLayers latheLayers(const geometry::TriangleMesh& part, const RodSurface& rod,
                        const LatheOptions& options, const base::RunContext& ctx);

// Returns the part's overhangs along the rod over lower layers.
Overhang latheOverhang(const geometry::TriangleMesh& part, const RodSurface& rod,
                       const LatheOptions& options, const OverhangRule& rule);

// Returns the height of points over a rod along its radius.
layers::Ground rodGround(const RodSurface& rod);

} // namespace voluta::substrate
