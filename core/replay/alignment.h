// Which motion of a program is which point of the trajectory it was written from.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

inline constexpr std::size_t kUnmatched = std::numeric_limits<std::size_t>::max();

// A sequence of nozzle poses: work frame, mm; directions unit.
struct PoseSequence {
  const std::vector<Eigen::Vector3d>& tip;
  const std::vector<Eigen::Vector3d>& direction;
  std::size_t size() const { return tip.size(); }
};

enum class DeviationKind {
  Moved,   // motion `motion` stands for point `point` but is not there
  Missing, // `count` points from `point` on have no motion; `motion` comes after the gap
  Extra,   // `count` motions from `motion` on have no point
  Swapped, // motions `motion` and `other` have each other's places
  CutShort // `count` points from `point` to the last have no motion
};
struct Deviation {
  DeviationKind kind;
  std::size_t motion = 0, other = 0, point = 0, count = 1;
  double distanceMm = 0.0, angleRad = 0.0;
};

struct AlignmentOptions {
  double sameMm = 0.05;            // a target this near to its point is where it was planned
  double sameRad = 0.01;           // likewise, angle of the nozzle's axis
  std::size_t window = 400;        // points or motions that are searched for a place to go on
  std::size_t maxDeviations = 500; // after that many the rest is not compared
};

struct Alignment {
  std::vector<std::size_t> pointOf;  // per motion: its point, or kUnmatched
  std::vector<std::size_t> leadsTo;  // per motion without one: the point that it is on the way to
  std::vector<Deviation> deviations; // in order of the text
  bool gaveUp = false;               // the program is another one altogether
};

// Walks both sequences in step. Where they differ, the nearest place (fewest motions and points
// skipped) where three pairs in a row agree is where they go on; what lies between is paired as
// moved or swapped when there are as many motions as points, else by least edits.
// Leading and trailing motions without a point are `Extra` too. `isVia`, where given: does a motion
// that is not at a point yet lie on the way to it? Such a one has no point and is no deviation.
// Throws Cancelled.
using IsVia = std::function<bool(std::size_t motion, std::size_t point)>;
Alignment alignToPlan(PoseSequence motions, PoseSequence points, const AlignmentOptions& options,
                      const base::RunContext& ctx, const IsVia& isVia = {});

} // namespace voluta::replay
