// The solids into which the regions of a part divide it.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "project/region.h"
#include "substrate/level_stack.h"

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

namespace voluta::regions {

// A part where it is printed.
struct PlacedPart {
  const geometry::TriangleMesh& mesh;                            // closed, work frame
  Eigen::Isometry3d work_T_file = Eigen::Isometry3d::Identity(); // of scaled coordinates
  double scale = 1.0;                                            // from the file's lengths to mm
};

// Returns the closed body of a region in the work frame; it may extend beyond the part, and is
// empty while nothing is painted for a region that is painted. `levels`: layers of the part, whose
// bead sets how finely a body follows a surface. Throws Error{Usage} for an invalid shape,
// Error{UnusableInput} for a skin without a surface; Cancelled.
geometry::TriangleMesh bodyOf(const project::Region& region, const PlacedPart& part,
                              const substrate::LevelOptions& levels, const base::RunContext& ctx);

// Returns the part without its regions that cut. Throws Error{UnusableInput} that names the region,
// if nothing is left, or if the body or the part is not closed; Error{Usage}; Cancelled.
geometry::TriangleMesh withoutCuts(const PlacedPart& part, std::span<const project::Region> all,
                                   const substrate::LevelOptions& levels,
                                   const base::RunContext& ctx);

// A region with layers of its own.
struct LayeredRegion {
  std::size_t index = 0; // among the item's regions
  geometry::TriangleMesh solid;
  std::vector<char> followed = {}; // of a skin: per face of the part, whether it follows it
};

struct PartRegions {
  geometry::TriangleMesh rest; // the part without the regions that have layers of their own
  std::vector<LayeredRegion> layered;
};

// Divides a part between its layers and those of its regions; where regions overlap, the later one
// holds. A region outside the part has no solid. Precondition: `part` is without cuts. Throws as
// withoutCuts().
PartRegions divided(const PlacedPart& part, std::span<const project::Region> all,
                    const substrate::LevelOptions& levels, const base::RunContext& ctx);

// What the layers of a region follow.
struct RegionGround {
  const geometry::TriangleMesh& whole; // the part
  const geometry::TriangleMesh& rest;  // the part without regions that have layers of their own
};

// Returns the layers of a region, numbered from 0. Throws Error{UnusableInput} if it has no room
// for a layer, or for the turn of its layers; Cancelled.
substrate::StackedLevels layersOf(const project::Region& region, const LayeredRegion& layered,
                                  const RegionGround& ground, const substrate::LevelOptions& levels,
                                  const base::RunContext& ctx);

} // namespace voluta::regions
