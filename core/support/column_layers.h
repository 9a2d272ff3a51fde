// What is laid of supports: level slices of their columns.
#pragma once

#include "base/run_context.h"
#include "curved/curved_layers.h"
#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace voluta::support {

struct ColumnLayerOptions {
  double layerHeightMm = 0.8, heightMinMm = 0.4, heightMaxMm = 1.0;
  double beadWidthMm = 1.2;
};

// The cells of decomposition.support, cut into horizontal slices, from below in each column. A
// column is as wide as a voxel or a bead, whichever is wider, and reaches from the plate, or from
// the surface of `part` (mm, closed) under its lowest cell, to the surface over its highest. Its
// slices are of equal thickness within each straight or bent stretch: as near to the layer height
// as their number allows, within the limits where the stretch is no shorter than the least height.
// Empty where there is no support. Throws Cancelled.
std::vector<curved::SupportPatch> columnLayers(const curved::Decomposition& decomposition,
                                               const geometry::TriangleMesh& part,
                                               const ColumnLayerOptions& options,
                                               const base::RunContext& ctx);

} // namespace voluta::support
