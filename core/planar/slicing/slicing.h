// Slicing of pieces into layers.
#pragma once

#include "base/run_context.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "layers/level_surface.h"
#include "layers/support_places.h"
#include "plan/finding.h"
#include "planar/pieces.h"
#include "planar/slicing/layer_heights.h"
#include "planar/slicing/section.h"
#include "planar/slicing/size_correction.h"
#include "planar/slicing/stitches.h"

#include <cstddef>
#include <vector>

namespace voluta::planar {

struct SliceOptions {
  HeightOptions heights;
  double beadWidthMm = 1.2;
  double edgeMm = 1.0; // of the triangles of a layer
  // Adds columns below overhangs beyond the angle, or all (support_columns.h), based on the plate
  // (convex, on z = 0), the piece itself or pieces before it.
  layers::SupportRule supports = layers::SupportRule::None;
  double overhangRad = 0.7853981633974483;
  std::vector<Eigen::Vector2d> plate;
  // Pockets of a single piece on the plate: its layers keep out of them.
  StitchRule stitches = {};
  SizeCorrection sizes; // of horizontal layers
};

struct SliceResult {
  layers::LayerStack stack; // in print order; group: index of the piece, or kSupportGroup
  plan::LayerStatistics statistics;
  std::vector<int> layersOfPiece;
  std::vector<double> volumeOfPiece; // sum of patch area x thickness, mm³
  double supportVolumeMm3 = 0.0;
  std::size_t slivers = 0; // parts of layers that are not printed: see finishStack
  double sliverVolumeMm3 = 0.0;
  std::size_t unsupportedPatches = 0; // patches without support below
  plan::Findings findings;            // stage "layers"
  struct {
    double extract = 0.0;
  } seconds;
};

// Returns the section as the mid-surface of a layer, ready to become patches: its boundary is on
// the section's edges (points closer together than 0.15 mm are thinned out by at most 2e-3 mm),
// thickness 1, directions along the plane's normal. Empty for an empty section. A section whose
// edges cross is filled by its winding. Throws Error{UnusableInput} if that gives no region;
// Cancelled.
layers::LevelSurface sectionSurface(const Section& section, double edgeMm,
                                    const base::RunContext& ctx);

// Slices each piece along its base's normal (layerBounds); only pieces on the plate have a first
// layer of its own height. A layer's mid-surface is the section at
// half its height, its direction the normal. Layers are numbered over all pieces in their order.
// Sections that cross or touch themselves are taken up to 1e-4 mm higher or lower, else filled by
// their winding, as slicers do with self-intersecting meshes. `places`: of regions, where columns
// follow another rule. Findings report areas too small for a bead, which are omitted, and
// unsupported patches. Throws Cancelled. Same result for any number of threads.
// Example:
//   const planar::PlanarDecomposition pieces = planar::beamDecompose(part, {}, ctx);
//   const planar::SliceResult sliced = planar::slicePieces(pieces.pieces, {}, ctx);
SliceResult slicePieces(const std::vector<Piece>& pieces, const SliceOptions& options,
                        const base::RunContext& ctx, const layers::SupportPlaces& places = {});

// Completes the result once all patches exist. Neighbours absorb `slivers` and small unsupported
// patches where possible (layers/absorb.h, layers/islands.h). Findings report the remaining ones as
// not printed and larger patches as unsupported.
void finishStack(SliceResult& result, const std::vector<layers::Patch>& slivers,
                 const SliceOptions& options, const base::RunContext& ctx);

} // namespace voluta::planar
