// Finds which segments of two machines must not happen at the same time.
#pragma once

#include "collision/margins.h"
#include "together/placed_motion.h"
#include "together/schedule.h"
#include "together/segments.h"
#include "together/static_conflicts.h"

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>

namespace voluta::base {
class RunContext;
}

namespace voluta::together {

struct Distances {
  double clearanceMm = 10.0; // least distance of moving bodies of the one to those of the other
  collision::Margins still;  // of moving bodies to bodies at rest and the part of the other
};

struct FoundConflicts {
  Conflicts table;
  StaticConflicts ofA, ofB;
  // The middle of a cell in which the two meet at their first rests; nullopt if they do not.
  std::optional<Eigen::Vector3d> atStart;
  // Returns the middle of a cell in which segments of the two meet; nullopt if they do not.
  std::function<std::optional<Eigen::Vector3d>(std::size_t a, std::size_t b)> place;
};

// Segments are compared without regard to time, by the space that they pass through: cells of
// kSweptCellMm, or wider if there would be too many. Segments nearer than the clearance always
// conflict; those further apart than it by two cells and two steps never do. Printed material
// counts from the waypoint on that the other machine has reached. Throws Cancelled.
inline constexpr double kSweptCellMm = 6.0;
FoundConflicts conflictsOf(const PlacedMotion& a, const Rests& aRests, const PlacedMotion& b,
                           const Rests& bRests, const Distances& distances,
                           const base::RunContext& ctx);

} // namespace voluta::together
