// The last step of curved mode: computes the printed layers from a decomposition.
#pragma once

#include "base/run_context.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "plan/finding.h"

namespace voluta::curved {

struct LayerOptions {
  double layerHeightMm = 0.8;                  // A level covers [L h, (L + 1) h) of the field
  double heightMinMm = 0.4, heightMaxMm = 1.0; // Limits of the process
  double beadWidthMm = 1.2;
  // Adjusts the level spacing slightly, so that an integer number of levels fits between the plate
  // and the part's highest level: flat tops get a whole layer.
  bool fitSpacing = true;
};

// A patch of support (group kSupportGroup) to be printed with the part.
struct SupportPatch {
  layers::Patch patch;  // Its layer is computed from levelMm
  double levelMm = 0.0; // Field value at which it begins
};

struct LayersResult {
  layers::LayerStack stack; // In print order
  plan::LayerStatistics statistics;
  double spacingMm = 0.0;         // Spacing of the levels in the field, as used
  std::size_t partialPatches = 0; // Patches of less or more than one level
  double partialAreaMm2 = 0.0;
  // Too small for a bead, or unsupported: absorbed by the surrounding patches
  std::size_t mergedPieces = 0;
  double mergedVolumeMm3 = 0.0;
  // The same, dropped because absorbing them would exceed the height limits
  std::size_t droppedPieces = 0;
  double droppedVolumeMm3 = 0.0;
  double volumeMm3 = 0.0; // Sum of patch area x thickness
  // Share of the area (sampled) with neither the plate nor one of the two layers below within 1.25
  // times the sum of the two half thicknesses
  double unsupportedFraction = 0.0;
  std::size_t unsupportedPatches = 0; // With neither plate nor an earlier layer below
  // Maximum distance of a boundary vertex from the part's surface, except at rims where another
  // level takes over. Where voxels were missed, boundaries end inside the part.
  double boundaryFarthestMm = 0.0;
  plan::Findings findings; // Stage "layers"
  struct {
    double extract = 0, trim = 0;
  } seconds;
};

// Extracts the level surfaces of the field, trims them on the part's surface and makes patches of
// them: PartialLevels, extractLevels, layers::trimToPart, layers::makePatches,
// layers::absorbSlivers, layers::orderForPrinting, layers::absorbIslands, layers::followTop. A
// level thicker than heightMaxMm is divided; where levels would be thinner than heightMinMm, one
// patch replaces several. Layers, including those of `supports`, are numbered by where their
// patches begin in the field. A patch's group is the component of printed voxels that contains it.
// The sum of area x thickness is the part's volume except for the losses in the findings; thickness
// beyond the limits is not changed. `part` faces outward and stands on the plate [mm].
// Preconditions: positive heights, heightMin <= heightMax. Throws Cancelled.
// Example:
//   const curved::LayersResult layers = curved::curvedLayers(order, part, {}, ctx);
LayersResult curvedLayers(const Decomposition& decomposition, const geometry::TriangleMesh& part,
                          const LayerOptions& options, const base::RunContext& ctx,
                          std::vector<SupportPatch> supports = {});

} // namespace voluta::curved
