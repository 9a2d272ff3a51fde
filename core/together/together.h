// Plans the work of several machines in one cell: an order of their segments in which they do not
// meet, whatever their speeds, with marks at which they wait for each other.
#pragma once

#include "together/conflicts.h"
#include "together/placed_motion.h"
#include "together/segments.h"
#include "together/work_order.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::together {

struct Options {
  Distances distances;
  double markS = 1.0;            // cost of a rendezvous
  std::size_t maxSegments = 300; // of each machine
  // A machine may wait amid a bead, with the extruder off, where its last rest is that long ago
  // [s]; infinite: never.
  double insideBeadsS = std::numeric_limits<double>::infinity();
};

// Why there is no order of work.
struct Obstruction {
  enum class Kind {
    Overlap, // the parts of both overlap, or one of them and a body at rest of the other machine
    AtRest,  // the first machine meets a body at rest of the second, in `contact`
    AtStart, // both are too close at their first points
    Moving,  // neither of both gets further than its segment without meeting the other
    All      // every two machines have an order, but none was found for all
  };
  Kind kind = Kind::Moving;
  std::array<std::size_t, 2> machines{};           // not of All
  StaticContact contact;                           // AtRest
  std::array<std::size_t, 2> segments{};           // Moving: the first ones that cannot be run
  Eigen::Vector3d where = Eigen::Vector3d::Zero(); // shared frame [mm]; not of All
};

struct Plan {
  std::vector<Rests> rests;                 // per machine
  std::vector<std::vector<double>> seconds; // durations of the segments of each
  std::optional<PairConflicts> conflicts;
  std::optional<Order> order;
  // Per rendezvous: a place at which both would meet without it; nullopt if that is printed
  // material. Shared frame [mm].
  std::vector<std::optional<Eigen::Vector3d>> conflictPlaces;
  std::optional<Obstruction> obstruction; // without an order
};

// Precondition: at least two machines. Throws Cancelled.
Plan planTogether(std::span<const PlacedMotion> machines, const Options& options,
                  const base::RunContext& ctx);

} // namespace voluta::together
