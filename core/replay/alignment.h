// Alignment of a program's motions with the points of the trajectory it was written from.
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

// A sequence of nozzle poses in the work frame [mm]; directions are unit vectors.
struct PoseSequence {
  const std::vector<Eigen::Vector3d>& tip;
  const std::vector<Eigen::Vector3d>& direction;
  std::size_t size() const { return tip.size(); }
};

enum class DeviationKind {
  Moved,   // motion `motion` belongs to point `point` but is at another position
  Missing, // `count` points from `point` on have no motion; `motion` follows the gap
  Extra,   // `count` motions from `motion` on have no point
  Swapped, // motions `motion` and `other` have swapped positions
  CutShort // `count` points from `point` to the last have no motion
};
struct Deviation {
  DeviationKind kind;
  std::size_t motion = 0, other = 0, point = 0, count = 1;
  double distanceMm = 0.0, angleRad = 0.0;
};

struct AlignmentOptions {
  double sameMm = 0.05;            // a target this close to its point is in place
  double sameRad = 0.01;           // likewise for the angle between the nozzle axes
  std::size_t window = 400;        // number of points or motions searched for a resumption
  std::size_t maxDeviations = 500; // the comparison stops after this many
};

struct Alignment {
  std::vector<std::size_t> pointOf;  // per motion: its point, or kUnmatched
  std::vector<std::size_t> leadsTo;  // per motion without a point: the point it leads to
  std::vector<Deviation> deviations; // in the order of the text
  // Returns the point of a motion, or the one that it is on the way to; kUnmatched if there is
  // none.
  std::size_t pointAhead(std::size_t motion) const {
    return pointOf[motion] != kUnmatched ? pointOf[motion] : leadsTo[motion];
  }
  bool gaveUp = false; // the text is a different program
};

// Walks both sequences in step. After a difference, the comparison resumes at the nearest position
// (fewest skipped motions and points) from which three pairs in a row agree. Motions and points in
// between are paired as moved or swapped if their numbers are equal, otherwise by minimum edit
// distance. Leading and trailing motions without a point are `Extra` too. `isVia`, if given,
// returns whether a motion that is not at a point is on the way to it; such a motion has no point
// and is no deviation. Throws Cancelled.
using IsVia = std::function<bool(std::size_t motion, std::size_t point)>;
Alignment alignToPlan(PoseSequence motions, PoseSequence points, const AlignmentOptions& options,
                      const base::RunContext& ctx, const IsVia& isVia = {});

} // namespace voluta::replay
