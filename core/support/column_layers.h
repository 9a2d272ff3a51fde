// The printed layers of supports: horizontal slices of their columns.
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

// Returns the cells of decomposition.support cut into horizontal slices, in each column from the
// bottom up. A column is as wide as a voxel or a bead, whichever is wider, and extends from the
// plate, or from the surface of `part` (mm, closed) below its lowest cell, to the surface above its
// highest. Within each stretch without a branch the slices have equal thickness: as near to the
// layer height as their number allows, within the limits unless the stretch is shorter than the
// minimum height. Empty if there is no support. Throws Cancelled.
std::vector<curved::SupportPatch> columnLayers(const curved::Decomposition& decomposition,
                                               const geometry::TriangleMesh& part,
                                               const ColumnLayerOptions& options,
                                               const base::RunContext& ctx);

} // namespace voluta::support
