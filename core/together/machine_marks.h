// Writes the rendezvous of an order of work into the motions, as marks.
#pragma once

#include "plan/trajectory.h"
#include "together/segments.h"
#include "together/work_order.h"

#include <cstddef>
#include <vector>

namespace voluta::together {

struct MarkPlace {
  std::size_t point = 0; // the arm rests there
  int link = 0;          // with the other machine (plan/marks.h)
  friend bool operator==(const MarkPlace&, const MarkPlace&) = default;
};
// Returns the marks of a machine in their order: a start mark for each machine that it meets, at
// its first point, and one for each rendezvous. All machines have their start marks in one order,
// so that none waits for ever. Precondition: the rests are the machine's.
std::vector<MarkPlace> marksOf(const Order& order, std::size_t machine, const Rests& rests);

// Returns the trajectory with each mark after the arrival at its point, before other events there.
// Precondition: the points are ascending and below pointCount().
plan::Trajectory withMarks(const plan::Trajectory& trajectory, const std::vector<MarkPlace>& marks);

} // namespace voluta::together
