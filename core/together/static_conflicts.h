// A moving machine against the bodies at rest of the other: its plate, obstacles and base, and the
// part that grows on its plate.
#pragma once

#include "collision/margins.h"
#include "together/placed_motion.h"
#include "together/segments.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::together {

inline constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

// Contact of a body of the one machine with one at rest of the other (collision::kPrintedPart: its
// part), at a point of the trajectory.
struct StaticContact {
  std::size_t segment = 0;
  int body = 0, other = 0;
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // nozzle's tip, shared frame [mm]
};

struct StaticConflicts {
  std::vector<std::optional<StaticContact>> bodies; // per segment
  // Per segment, and per rest: the least number of printed waypoints of the other machine's part
  // with which it meets that part; kNever: with none.
  std::vector<std::size_t> segmentMeets, restMeets;
};

// Returns a point (shared frame) at which the machine's part is inside the other's part, or inside
// a body at rest of the other; nullopt if there is none, or if an arm carries one of the parts.
std::optional<Eigen::Vector3d> partOverlap(const PlacedMotion& machine, const PlacedMotion& other);

// Obstacles of the other machine are checked against the bodies that the machine's own cell checks
// against its obstacles. Throws Cancelled.
StaticConflicts staticConflicts(const PlacedMotion& machine, const Rests& rests,
                                const PlacedMotion& other, const collision::Margins& margins,
                                const base::RunContext& ctx);

} // namespace voluta::together
