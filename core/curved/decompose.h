// Curved mode's decomposition: from solid voxels to a growth order and a growing field.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "curved/decomposition.h"
#include "curved/forward_growth.h"
#include "curved/growth_row.h"
#include "curved/growth_scheme.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::curved {

struct CurvedOptions {
  GrowthScheme growth;
  ForwardOptions forward; // Options of the published schemes
  double layerHeightMm = 0.8, heightMinMm = 0.4, heightMaxMm = 1.0; // Limits of the layer height
  process::HeadShape head; // Shape of the front where the flat front fails; empty: always flat
  // Use `head` where the flat front loses voxels; false: only under roofs
  bool headForLosses = true;
  int rounds = 8; // Maximum rounds of growth and fitting; 0: ranks only, no field
};

// Returns the head that grow() may use where a flat front would lose voxels; nullptr: none.
const process::HeadShape* headForLosses(const CurvedOptions& options);

// Returns the parameters voxelMm (width of the voxels [mm], 0.8), frontShape (auto:
// CurvedOptions::head under roofs only; flat; nozzle: also where voxels would be lost) and
// fieldRounds (CurvedOptions::rounds).
base::ParameterTable curvedParameters();

// Receives intermediate results: the ranks, then the field as rounds improve it. Called from the
// thread that runs the stage; must copy the data it keeps.
using DecompositionWatch = std::function<void(const Decomposition&)>;
// Called once the ranks are known, with the findings about them. If it returns true, no field is
// fitted.
using DecompositionFilter = std::function<bool(const plan::Findings&)>;

// Orders the voxels and fits the field.
//
// Ranks: both constraints of dissertation 3.3.1 hold between voxel centres: a voxel is on the
// platform or has an AM-stable neighbour of lower rank, and it is not strictly inside the convex
// hull of the platform and all lower ranks. Only where nothing else can continue (stuck loops), it
// may be up to half a voxel inside (the sources' epsilon). grow() computes the ranks; with a field
// they are computed once more guided by it, so that ranks and layers agree (not above kFieldVoxels,
// where the field comes from a coarser grid). Field: see Decomposition::field. The thickness h /
// |grad field| is within the height limits except for a small share, and levels follow each other
// without islands. As few voxels as possible are given up; findings report them by group.
//
// `platform`: convex polygon on z = 0 [mm], counter-clockwise, at least 3 corners. `known`: the
// result of grow() for these voxels and this platform with headForLosses(options); nullptr: grow()
// runs here. Throws Error{UnusableInput} if no voxel is on the platform, and Cancelled.
// Example:
//   const std::vector<Eigen::Vector2d> plate = curved::platformFit(voxels, 0.0);
//   const curved::Decomposition order = curved::decompose(voxels, plate, {}, ctx);
Decomposition decompose(const voxel::SolidVoxels& voxels,
                        const std::vector<Eigen::Vector2d>& platform, const CurvedOptions& options,
                        const base::RunContext& ctx, const DecompositionWatch& watch = {},
                        const DecompositionFilter& isRejected = {},
                        std::shared_ptr<const Growth> known = nullptr);

} // namespace voluta::curved
