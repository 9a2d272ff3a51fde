// From pieces to the layers that are laid.
#pragma once

#include "base/run_context.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "layers/level_surface.h"
#include "plan/finding.h"
#include "planar/pieces.h"
#include "planar/slicing/layer_heights.h"
#include "planar/slicing/section.h"

#include <cstddef>
#include <vector>

namespace voluta::planar {

struct SliceOptions {
  HeightOptions heights;
  double beadWidthMm = 1.2;
  double edgeMm = 1.0; // of the triangles of a layer
  // Columns carry what reaches out too far (support_columns.h): where it leans by more than the
  // angle, down to the plate (convex, on z = 0), the piece or pieces before it.
  bool supports = false;
  double overhangRad = 0.7853981633974483;
  std::vector<Eigen::Vector2d> plate;
};

struct SliceResult {
  layers::LayerStack stack; // in print order; group: index of the piece, or kSupportGroup
  layers::LayerStatistics statistics;
  std::vector<int> layersOfPiece;
  std::vector<double> volumeOfPiece; // sum of patch area x thickness, mm3
  double supportVolumeMm3 = 0.0;
  std::size_t slivers = 0; // pieces of layers that are not laid: see finishStack
  double sliverVolumeMm3 = 0.0;
  std::size_t unsupportedPatches = 0; // that begin in the air
  plan::Findings findings;            // stage "layers"
  struct {
    double extract = 0.0;
  } seconds;
};

// The section as the mid-surface of a layer, ready to become patches: boundary on the section's
// edges (points closer together than 0.15 mm are thinned out by at most 2e-3 mm), thickness 1,
// directions along the plane's normal. Nothing for an empty section. One whose edges cross each
// other is filled by its winding. Throws Error{UnusableInput} where that gives no region;
// Cancelled.
layers::LevelSurface sectionSurface(const Section& section, double edgeMm,
                                    const base::RunContext& ctx);

// Slices each piece along its base's normal (layerBounds): a layer's mid-surface is the section at
// half its height, its direction the normal. Layers run over all pieces in their order. Sections
// that cross or touch themselves are taken up to 1e-4 mm higher or lower, else filled by their
// winding, as slicers do with a mesh that cuts itself there. What is too small for a
// bead is left out and told, and so is what begins in the air. Throws Cancelled. Same result for
// any number of threads.
// Example:
//   const planar::PlanarDecomposition pieces = planar::beamDecompose(part, {}, ctx);
//   const planar::SliceResult sliced = planar::slicePieces(pieces.pieces, {}, ctx);
SliceResult slicePieces(const std::vector<Piece>& pieces, const SliceOptions& options,
                        const base::RunContext& ctx);

// What is known of a stack once all its patches are there. Neighbours take what they can of
// `slivers` and of small patches that begin in the air (layers/absorb.h, layers/islands.h); what is
// left of those is told as not laid, larger ones as beginning in the air.
void finishStack(SliceResult& result, const std::vector<layers::Patch>& slivers,
                 const SliceOptions& options, const base::RunContext& ctx);

} // namespace voluta::planar
