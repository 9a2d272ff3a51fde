// Curved mode's decomposition: solid voxels in, an order and a field of growth out.
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
  ForwardOptions forward;                                           // of the sources' schemes
  double layerHeightMm = 0.8, heightMinMm = 0.4, heightMaxMm = 1.0; // heights a layer may have
  process::HeadShape head;   // a front of this shape where the flat one does not do; empty: flat
  bool headForLosses = true; // where the flat one loses voxels; false: only under roofs
  int rounds = 8;            // of growth and refit, at most; 0: ranks only, no field
};

// What grow() may lay by the head, where a flat front would lose it; nullptr: nothing.
const process::HeadShape* headForLosses(const CurvedOptions& options);

// voxelMm (mm, 0.8: width of the voxels), frontShape (auto: CurvedOptions::head under roofs only;
// flat; nozzle: also where voxels would be lost) and
// fieldRounds (CurvedOptions::rounds).
base::ParameterTable curvedParameters();

// Hears of what is known so far: the ranks, then the field as rounds improve it. Called from the
// thread that runs the stage; copies what it wants to keep.
using DecompositionWatch = std::function<void(const Decomposition&)>;
// Asked once the ranks are known, with the findings about them. True: no field is fitted.
using DecompositionFilter = std::function<bool(const plan::Findings&)>;

// Orders the voxels and fits the field.
//
// Ranks: both constraints of dissertation 3.3.1 hold between voxel centres: a voxel stands on the
// platform or has an AM-stable neighbour of lower rank, and it does not lie strictly inside the
// convex hull of the platform and all lower ranks; where nothing else can go on (stuck loops), it
// lies at most half a voxel inside (the sources' epsilon). grow() finds them; with
// a field they are then found once more guided by it, so that ranks and layers follow one another
// (not above kFieldVoxels, where the field comes from a coarser grid).
// Field: see Decomposition::field; thickness h / |grad field| is kept within the height limits
// but for a small share, and levels follow each other without islands.
// What can't be laid is given up, as little as possible, and stands in findings by group.
//
// `platform`: convex polygon on z = 0, mm, counter-clockwise, 3 corners or more. `known`: what
// grow() makes of these voxels on it with headForLosses(options); null: it is grown here.
// Throws Error{UnusableInput} when no voxel stands on the platform; Cancelled.
// Example:
//   const std::vector<Eigen::Vector2d> plate = curved::platformFit(voxels, 0.0);
//   const curved::Decomposition order = curved::decompose(voxels, plate, {}, ctx);
Decomposition decompose(const voxel::SolidVoxels& voxels,
                        const std::vector<Eigen::Vector2d>& platform, const CurvedOptions& options,
                        const base::RunContext& ctx, const DecompositionWatch& watch = {},
                        const DecompositionFilter& isRejected = {},
                        std::shared_ptr<const Growth> known = nullptr);

} // namespace voluta::curved
