// From a field to the mid-surfaces of its levels.
#pragma once

#include "base/run_context.h"
#include "curved/decomposition.h"
#include "curved/level_field.h"
#include "curved/partial_levels.h"
#include "layers/level_surface.h"

#include <vector>

namespace voluta::curved {

// A level surface before it is trimmed on the part; see layers/level_surface.h.
using RawLevel = layers::LevelSurface;

// The mid-surfaces phi = (L + 1/2) * spacingMm for L = 0, 1, ... as far as the field reaches, one
// RawLevel each (some may be empty), element L being level L. Marching cubes on the cells of
// LevelField: each surface is manifold, oriented along +grad phi, and reaches at least half a voxel
// beyond the printed voxels, so that it can be cut on the part's surface; limbs with a gap of a
// voxel between them are not joined. The source contours dually (Dai 2020, 3.4.5), which keeps
// creases; levels of a smooth field have none, and marching cubes need no mending to be manifold.
// Their slivers are taken out afterwards (layers::cleanSurface).
// Per vertex: direction = grad phi / |grad phi|; thickness = the distance along it between
// phi = L spacing and (L + 1) spacing; clearDirection = front normals of the printed voxels around,
// blended (direction where there are none). Level 0 is laid on the plate z = 0: where it lies flat,
// its vertices are put halfway between the plate and the next level.
// Preconditions: spacingMm > 0. Throws Cancelled.
std::vector<RawLevel> extractLevels(const LevelField& field, double spacingMm,
                                    const base::RunContext& ctx);
std::vector<RawLevel> extractLevels(const Decomposition& decomposition, double spacingMm,
                                    const base::RunContext& ctx);

// The same for slabs (see PartialLevels), from below: the middle surface of each, as far as it is
// laid. RawLevel::level is the slab's bottom in units of the finest slab; where one slab ends and
// another takes over inside the part is an inner rim.
struct RawSlab {
  Slab slab;
  RawLevel surface;
};
std::vector<RawSlab> extractSlabs(const LevelField& field, const PartialLevels& partial,
                                  const base::RunContext& ctx);

} // namespace voluta::curved
