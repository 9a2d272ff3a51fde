// The part as it grows: one grid of "first filled at waypoint i", good for any moment
// (docs/design.md, The road).
#pragma once

#include "collision/bead_sections.h"
#include "collision/fill_times.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "robot/body.h"
#include "voxel/voxel_grid.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace voluta::base {
class RunContext;
}

namespace voluta::process {
struct Process;
}

namespace voluta::collision {

// Pitch of a grid for the growing part, mm: a quarter of the process's bead width or half its layer
// height, whichever is less, as fine as programs are judged on, but coarser where the plan's box
// would hold more than 2^27 such cells.
double growingPitch(const plan::ToolPlan& plan, const process::Process& process);

// What of a platform is no plate, in cells that are filled from the start: pitchMm wide, wider
// where there would be more than 2^24 of them. Null: nothing. Throws Cancelled.
std::shared_ptr<const FillTimes> groundCells(const platform::PlatformSolid& platform,
                                             double pitchMm, const base::RunContext& ctx);

// Of the margin to be kept by the head's underside; cells look after more.
inline constexpr double kUndersideMm = 0.05;

// Copies are cheap: they share what never changes.
class GrowingPart {
public:
  // Deposits every segment of every path: section of process/bead_model.h below the tip, along the
  // waypoints' directions, but for a prime that falls. A cell counts as filled when its centre is
  // inside a bead. The ground is there before the first. Work frame. Throws Cancelled.
  GrowingPart(const plan::ToolPlan& plan, double pitchMm, const base::RunContext& ctx,
              std::shared_ptr<const FillTimes> ground = nullptr);

  // The same, of another plan's part in cells as wide, on the same ground: beads that this plan has
  // too, in the same order, are taken over with the cells that they fill. Throws Cancelled.
  GrowingPart(const plan::ToolPlan& plan, const GrowingPart& other, const plan::ToolPlan& itsPlan,
              const base::RunContext& ctx);

  // Of the beads.
  const voxel::VoxelGrid& grid() const { return beads_->grid(); }
  // Index of the waypoint at whose arrival the cell is filled; kNeverFilled otherwise.
  static constexpr std::uint32_t kNeverFilled = FillTimes::kNever;
  std::uint32_t filledAt(std::size_t cell) const { return beads_->filledAt(cell); }

  // Does the shape, placed by work_T_shape and grown by `marginMm` (negative shrinks), hold the
  // centre of a cell of the ground or of one filled at a waypoint index < `before`?
  bool touches(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double marginMm,
               std::size_t before) const;
  // The same, but what lies in the solid by less than half a cell does not count: nearer the grids
  // cannot tell. For the head, which is meant to be there. Its flat underside is held against the
  // beads' sections besides, with a margin of at most kUndersideMm. These know by themselves what
  // is soft: `printing` is the waypoint that the head is at or on the way to, `before` where it is
  // not given; for the cells the caller leaves that out by a `before` that lies behind it.
  bool headTouches(const Revolved& head, const Eigen::Isometry3d& work_T_head, double marginMm,
                   std::size_t before, std::optional<std::size_t> printing = std::nullopt) const;

  // A box that holds the centres of all its cells and of the ground's; empty where there are none.
  Eigen::AlignedBox3d bounds() const;

  // Is the cell that the point is in, of the ground or of beads, filled at a waypoint index <
  // `before`?
  bool holds(const Eigen::Vector3d& point, std::size_t before) const;

  // Distance from the shape to the nearest such centre, capped at `capMm`; 0 when inside. mm.
  double distance(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape, double capMm,
                  std::size_t before) const;

private:
  friend std::shared_ptr<const GrowingPart> regrown(const plan::ToolPlan&, const GrowingPart&,
                                                    const plan::ToolPlan&, const process::Process&,
                                                    const base::RunContext&);
  std::shared_ptr<const FillTimes> ground_, beads_; // never null
  std::shared_ptr<const BeadSections> sections_;    // of the beads; likewise
};

// A plan's part at growingPitch() on the ground of another's, from that one where cells are as
// wide. Throws Cancelled.
std::shared_ptr<const GrowingPart> regrown(const plan::ToolPlan& plan, const GrowingPart& other,
                                           const plan::ToolPlan& itsPlan,
                                           const process::Process& process,
                                           const base::RunContext& ctx);

} // namespace voluta::collision
