// The least clearance along whole motions, not only at the points that are looked at.
#pragma once

#include "collision/cell_collision.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::collision {

// How far below the true least distance a reported one may be, mm.
inline constexpr double kWayExactMm = 0.1;

class WayClearance {
public:
  // Both must outlive it.
  WayClearance(const CellCollision& collision, const GrowingPart& part);

  // The joints go from `from` to `to`, with everything in place that is filled before waypoint
  // `before`. Returns `leastMm` if all pairs (CellCollision::clearancePairs) keep that far apart
  // all the way; else a distance that none of them comes closer than, at most kWayExactMm below
  // the true one and not below 0. Between two poses a pair comes no closer than half of what its
  // distances there leave over the way that its points go at most; where that does not tell, the
  // way is halved. `detour`: how much further the joints may go than evenly from one to the other,
  // as a factor.
  double along(const robot::JointVector& from, const robot::JointVector& to, std::size_t before,
               double leastMm, double detour = 1.0) const;

private:
  using Frames = CellCollision::Frames;
  struct Stretch; // of a pair: its ends, the distances there, how far its points go at most
  struct Speeds;  // of all bodies, of each joint that moves
  double alongPiece(const robot::JointVector& from, const robot::JointVector& to,
                    std::size_t before, double leastMm, double detour) const;
  double refined(const Stretch& stretch, double leastMm) const;
  double wayOf(const Contact& pair, const Speeds& speeds) const;
  Speeds speedsAt(const robot::JointVector& q, const robot::JointVector& step) const;

  const CellCollision& collision_;
  const GrowingPart& part_;
  std::vector<Contact> pairs_;
  std::vector<Ball> balls_; // about bodies, in their frames; last about the part, in the work frame
};

} // namespace voluta::collision
