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

// What is to be laid around the rod: the part less the rod, both in the work frame, the rod's axis
// on x. Throws Error{UnusableInput} where the part is not closed, reaches beyond an end of the rod,
// or no further out than the rod.
geometry::TriangleMesh partAroundRod(const geometry::TriangleMesh& part, const RodSurface& rod);

struct LatheOptions : LevelOptions {
  // False: levels at constant radius; true: at constant distance from the rod, whatever its
  // profile.
  bool followsRod = false;
};

struct LatheLayers : StackedLevels {
  std::vector<double> outerMm; // of each level: its outer radius, or distance from the rod
};

// Outer bounds of the levels of latheLayers, the rod's own first: from the rod (where it is
// thinnest within the part's length) to the part's farthest point. Throws Error{UnusableInput}
// where the part leaves no room for a layer over the rod. (Castelli 2020, 5.3.1.)
std::vector<double> latheBounds(const geometry::TriangleMesh& part, const RodSurface& rod,
                                const LatheOptions& options);

// latheBounds as levels, stacked (stackLevels). `part`: see partAroundRod. Throws
// Error{UnusableInput} as latheBounds, and where nothing of the part lies on the rod; Cancelled.
// Same result for any number of threads.
// Example:
//   const substrate::RodSurface rod(platform::straightRod(5.0, 200.0));
//   const geometry::TriangleMesh around = substrate::partAroundRod(tube, rod);
//   const substrate::LatheLayers wound = substrate::latheLayers(around, rod, {}, ctx);
LatheLayers latheLayers(const geometry::TriangleMesh& part, const RodSurface& rod,
                        const LatheOptions& options, const base::RunContext& ctx);

// Where the part leans out over lower layers along the rod.
Overhang latheOverhang(const geometry::TriangleMesh& part, const RodSurface& rod,
                       const LatheOptions& options, const OverhangRule& rule);

// How far points are over a rod, along its radius.
layers::Ground rodGround(const RodSurface& rod);

} // namespace voluta::substrate
