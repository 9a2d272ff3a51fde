// Layers wound around a rod.
#pragma once

#include "base/run_context.h"
#include "geometry/rod_shape.h"
#include "geometry/triangle_mesh.h"
#include "layers/ground.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"

#include <cstddef>
#include <vector>

namespace voluta::substrate {

// What is to be laid around the rod: the part less the rod, both in the work frame, the rod's axis
// on x. Throws Error{UnusableInput} where the part is not closed, reaches beyond an end of the rod,
// or no further out than the rod; and as checkRod.
geometry::TriangleMesh partAroundRod(const geometry::TriangleMesh& part,
                                     const geometry::RodShape& rod);

struct LatheOptions {
  double layerHeightMm = 0.25, heightMinMm = 0.1, heightMaxMm = 0.35;
  double firstLayerMm = 0.0; // 0: as thick as the others
  double beadWidthMm = 0.7;
  // False: levels at constant radius; true: at constant distance from the rod, whatever its
  // profile.
  bool followsRod = false;
  double overhangRad = 0.7853981633974483; // to which the part may lean out over lower layers
};

struct LatheLayers {
  layers::LayerStack stack; // in print order
  layers::LayerStatistics statistics;
  std::vector<double> outerMm; // of each level: its outer radius, or distance from the rod
  std::size_t mergedPieces = 0;
  std::size_t slivers = 0; // pieces of layers that are not laid
  double sliverVolumeMm3 = 0.0;
  std::size_t unsupportedPatches = 0; // that begin in the air
  double riskyAreaMm2 = 0.0;          // of the part's surface, facing the axis: see LatheOptions
  plan::Findings findings;            // stage "layers"
};

// Levels of equal height from the rod (where it is thinnest within the part's length) to the part's
// farthest point, the height being the nearest to layerHeightMm for which they are a whole number;
// each trimmed by the part, what is too small for a bead taken by its neighbours, last layers under
// tapers and shoulders ending on the surface (layers::followTop). `part`: see partAroundRod.
// Throws Error{UnusableInput} where the part leaves no room for a layer over the rod, or nothing of
// it lies on the rod; Cancelled. Same result for any number of threads. (Castelli 2020, 5.3.1.)
LatheLayers latheLayers(const geometry::TriangleMesh& part, const geometry::RodShape& rod,
                        const LatheOptions& options, const base::RunContext& ctx);

// How far points are over a rod, along its radius. Precondition: checkRod.
layers::Ground rodGround(const geometry::RodShape& rod);

} // namespace voluta::substrate
