// Minimum clearance along whole motions, not only at sampled points.
#pragma once

#include "collision/cell_collision.h"
#include "collision/shape_distance.h"
#include "robot/robot_model.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::collision {

// Maximum amount by which a reported distance is below the true minimum [mm].
inline constexpr double kMotionExactMm = 0.1;

class MotionClearance {
public:
  // Both arguments must outlive the object.
  MotionClearance(const CellCollision& collision, const GrowingPart& part);

  // The joints move from `from` to `to`; all material filled before waypoint `before` is present.
  // Returns `minMm` if all pairs (CellCollision::clearancePairs) keep that distance all the way.
  // Otherwise returns a lower bound of the minimum distance, at most kMotionExactMm below the true
  // one and not negative. Between two poses, the distance of a pair is at least half of (the sum of
  // its distances at both minus the maximum displacement of its points); where that is not
  // sufficient, the interval is halved. `detour`: factor by which the joints' path may be longer
  // than linear interpolation.
  double along(const robot::JointVector& from, const robot::JointVector& to, std::size_t before,
               double minMm, double detour = 1.0) const;

private:
  using Frames = CellCollision::Frames;
  // of a pair: its ends, the distances there, the maximum displacement of its points
  struct Stretch;
  struct Speeds; // of all bodies, for each moving joint
  double alongPiece(const robot::JointVector& from, const robot::JointVector& to,
                    std::size_t before, double minMm, double detour) const;
  double refined(const Stretch& stretch, double minMm) const;
  double displacementOf(const Contact& pair, const Speeds& speeds) const;
  Speeds speedsAt(const robot::JointVector& q, const robot::JointVector& step) const;

  const CellCollision& collision_;
  const GrowingPart& part_;
  std::vector<Contact> pairs_;
  // about bodies, in their frames; the last one about the part, in the work frame
  std::vector<Ball> balls_;
};

} // namespace voluta::collision
