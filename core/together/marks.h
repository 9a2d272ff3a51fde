// Writes the rendezvous of an order of work into the motions, as marks.
#pragma once

#include "plan/trajectory.h"
#include "together/order.h"
#include "together/segments.h"

#include <cstddef>
#include <vector>

namespace voluta::together {

struct MarkPlace {
  std::size_t point = 0; // the arm rests there
  int channel = 0;       // of the other machine (plan/marks.h)
  friend bool operator==(const MarkPlace&, const MarkPlace&) = default;
};
// Returns the marks of a machine in their order. Precondition: the rests are the machine's.
std::vector<MarkPlace> marksOf(const Order& order, std::size_t machine, const Rests& rests);

// Returns the trajectory with each mark after the arrival at its point, before other events there.
// Precondition: the points are ascending and below pointCount().
plan::Trajectory withMarks(const plan::Trajectory& trajectory, const std::vector<MarkPlace>& marks);

} // namespace voluta::together
