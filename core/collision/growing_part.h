// The growing part: one grid of "first filled at waypoint i", usable for any time (docs/design.md,
// The road).
#pragma once

#include "robot/body.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace voluta::base {
class RunContext;
}
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::platform {
struct PlatformSolid;
}
namespace voluta::process {
class Tooling;
}
namespace voluta::voxel {
struct VoxelGrid;
}

namespace voluta::collision {

class BeadSections;
class FillTimes;
class Revolved;

// Returns the pitch of a grid for the growing part [mm]: a quarter of a process's bead width or
// half its layer height, the resolution of the replay, whichever is smallest among the tools that
// print the plan's paths (the first tool if it has none); coarser if the plan's box would contain
// more than 2^27 such cells.
double growingPitch(const plan::ToolPlan& plan, const process::Tooling& tooling);

// Returns all solids that are not printed but the plate as cells, pitchMm wide, or wider if there
// would be more than 2^24: bodies and rods of a platform, filled from the start, and what is put
// into the part, filled after the last waypoint before. Null if there are none. Throws Cancelled.
std::shared_ptr<const FillTimes> groundCells(const platform::PlatformSolid& platform,
                                             const plan::ToolPlan& plan, double pitchMm,
                                             const base::RunContext& ctx);

// Part of the margin that is checked at the head's underside by bead sections; the cells cover
// larger margins.
inline constexpr double kUndersideMm = 0.05;

// Cheap to copy: immutable data are shared.
class GrowingPart {
public:
  // Deposits every segment of every path: section of process/bead_model.h below the tip, along the
  // waypoints' directions, except a prime that falls. A cell counts as filled if its centre is
  // inside a bead. `ground`: from groundCells() of the same plan. Work frame. Throws Cancelled.
  GrowingPart(const plan::ToolPlan& plan, double pitchMm, const base::RunContext& ctx,
              std::shared_ptr<const FillTimes> ground = nullptr);

  // As above, starting from the part of another plan with the same pitch and ground: beads that are
  // in both plans, in the same order, are reused with the cells that they fill. Throws Cancelled.
  GrowingPart(const plan::ToolPlan& plan, const GrowingPart& other, const plan::ToolPlan& itsPlan,
              const base::RunContext& ctx);

  // Grid of the beads.
  const voxel::VoxelGrid& grid() const;
  // Index of the waypoint on whose arrival the cell is filled; kNeverFilled otherwise.
  static constexpr std::uint32_t kNeverFilled = 0xffffffffu;
  std::uint32_t filledAt(std::size_t cell) const;

  // Returns whether the shape, placed by work_T_shape and grown by `marginMm` (negative shrinks),
  // contains the centre of a ground cell or of one filled at a waypoint index < `before`.
  bool touches(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double marginMm,
               std::size_t before) const;
  // As touches(), but overlaps of less than half a cell, the grids' resolution, do not count. For
  // the head, which is meant to be close to the part. Its flat underside is also tested against the
  // bead sections, with a margin of at most kUndersideMm. These determine themselves which beads
  // are soft: `printing` is the waypoint that the head is at or moving to, `before` if not given.
  // For the cells the caller excludes soft beads by a smaller `before`.
  bool headTouches(const Revolved& head, const Eigen::Isometry3d& work_T_head, double marginMm,
                   std::size_t before, std::optional<std::size_t> printing = std::nullopt) const;

  // Returns a box that contains the centres of all cells of beads and ground; empty if there are
  // none.
  Eigen::AlignedBox3d bounds() const;

  // Returns whether the point is in a cell, of the ground or of beads, that is filled at a waypoint
  // index < `before`.
  bool holds(const Eigen::Vector3d& point, std::size_t before) const;

  // Returns the distance from the shape to the nearest such centre, capped at `capMm`; 0 inside.
  // mm.
  double distance(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double capMm,
                  std::size_t before) const;

private:
  friend std::shared_ptr<const GrowingPart> regrown(const plan::ToolPlan&, const GrowingPart&,
                                                    const plan::ToolPlan&, const process::Tooling&,
                                                    const base::RunContext&);
  std::shared_ptr<const FillTimes> ground_, beads_; // never null
  std::shared_ptr<const BeadSections> sections_;    // of the beads; never null
};

// Returns the part of a plan at growingPitch() on the ground of another's, reusing that one if it
// has the same pitch. Throws Cancelled.
std::shared_ptr<const GrowingPart> regrown(const plan::ToolPlan& plan, const GrowingPart& other,
                                           const plan::ToolPlan& itsPlan,
                                           const process::Tooling& tooling,
                                           const base::RunContext& ctx);

} // namespace voluta::collision
