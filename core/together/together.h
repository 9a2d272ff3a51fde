// Plans the work of two machines in one cell: an order of their segments in which they do not meet,
// whatever their speeds, with marks at which they wait for each other.
#pragma once

#include "together/conflicts.h"
#include "together/machine.h"
#include "together/schedule.h"
#include "together/segments.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::together {

struct Options {
  Distances distances;
  double markS = 1.0;             // cost of a mark
  std::size_t mostSegments = 300; // of each machine
};

// Why there is no schedule.
struct Obstruction {
  enum class Kind {
    Overlap, // the parts overlap, or one of them and a body at rest of the other machine
    AtRest,  // `machine` meets a body at rest of the other, in `contact`
    AtStart, // the two are too close at their first points
    Moving   // neither machine gets further than its segment without meeting the other
  };
  Kind kind = Kind::Moving;
  int machine = 0;                                 // 0 or 1
  StaticContact contact;                           // AtRest
  std::size_t aSegment = 0, bSegment = 0;          // Moving: the first ones that cannot be run
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // shared frame [mm]
};

struct Plan {
  Rests a, b;
  std::vector<double> aS, bS; // durations of the segments
  Conflicts conflicts;
  std::optional<Schedule> schedule;
  std::optional<Obstruction> obstruction; // without a schedule
};

// Throws Cancelled.
Plan planTogether(const Machine& a, const Machine& b, const Options& options,
                  const base::RunContext& ctx);

} // namespace voluta::together
