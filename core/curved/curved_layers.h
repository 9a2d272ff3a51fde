// The last step of curved mode: from a decomposition to the layers that are laid.
#pragma once

#include "base/run_context.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"

namespace voluta::curved {

struct LayerOptions {
  double layerHeightMm = 0.8;                  // a level covers [L h, (L + 1) h) of the field
  double heightMinMm = 0.4, heightMaxMm = 1.0; // what the process can lay
  double beadWidthMm = 1.2;
  // The spacing of levels is changed a little, so that a whole number of them fits between the
  // plate and the part's highest level: flat tops get a whole layer.
  bool fitSpacing = true;
};

// A patch of support (group kSupportGroup) to be laid with the rest.
struct SupportPatch {
  layers::Patch patch;  // its layer is found from levelMm
  double levelMm = 0.0; // of the field where it begins
};

struct LayersResult {
  layers::LayerStack stack; // in print order
  layers::LayerStatistics statistics;
  double spacingMm = 0.0;         // of levels in the field, as used
  std::size_t partialPatches = 0; // of less or more than one level
  double partialAreaMm2 = 0.0;
  std::size_t mergedPieces = 0; // too small for a bead or in the air: taken by the patches around
  double mergedVolumeMm3 = 0.0;
  std::size_t droppedPieces = 0; // the same, where that would have left the height limits
  double droppedVolumeMm3 = 0.0;
  double volumeMm3 = 0.0;             // sum of patch area x thickness
  double unsupportedFraction = 0.0;   // of the area (sampled): nothing within 1.25 of the two half
                                      // thicknesses, neither plate nor one of the two layers below
  std::size_t unsupportedPatches = 0; // with neither plate nor an earlier layer under them
  double boundaryFarthestMm = 0.0;    // of a boundary vertex from the part's surface, but for rims
                                      // where another level takes over; where voxels were missed,
                                      // boundaries end inside the part
  plan::Findings findings;            // stage "layers"
  struct {
    double extract = 0, trim = 0;
  } seconds;
};

// Level surfaces of the field, cut on the part's surface and made into patches: PartialLevels,
// extractLevels, layers::trimToPart, layers::makePatches, layers::absorbSlivers,
// layers::orderForPrinting, layers::absorbIslands, layers::followTop. Where a level would be
// thicker than heightMaxMm, it is laid in parts; where levels would be thinner than heightMinMm,
// they end and one patch takes the place of several: layers are numbered by where their patches
// begin in the field, `supports` among them. A patch's group is the component of the printed voxels
// it lies in. Sum of area x thickness is the part's volume but for what the findings tell;
// thickness beyond the limits is left as it is. `part` faces outward and stands on the plate, mm.
// Preconditions: positive heights, heightMin <= heightMax. Throws Cancelled.
// Example:
//   const curved::LayersResult layers = curved::curvedLayers(order, part, {}, ctx);
LayersResult curvedLayers(const Decomposition& decomposition, const geometry::TriangleMesh& part,
                          const LayerOptions& options, const base::RunContext& ctx,
                          std::vector<SupportPatch> supports = {});

} // namespace voluta::curved
