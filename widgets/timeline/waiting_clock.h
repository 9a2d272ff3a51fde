// A machine's own time within the common time of several machines that wait for each other.
#pragma once

#include <vector>

namespace voluta::timeline {

// The machine waits from `fromS` until `toS` of the common time, at `ownS` of its own.
struct OwnWait {
  double ownS = 0.0, fromS = 0.0, toS = 0.0;
};

// Between two waits the machine's own time passes evenly: the controller may be somewhat slower or
// faster than planned.
class WaitingClock {
public:
  // No motion: own time 0.
  WaitingClock() = default;
  // `ownEndS`, `endS`: when the machine ends, in its own and in the common time. Precondition: all
  // times are ascending.
  WaitingClock(std::vector<OwnWait> waits, double ownEndS, double endS);

  // Returns the machine's own time; the ends count before 0 and after endS().
  double ownTimeS(double commonS) const;
  const std::vector<OwnWait>& waits() const { return waits_; }
  double endS() const { return endS_; }

private:
  std::vector<OwnWait> waits_;
  double ownEndS_ = 0.0, endS_ = 0.0;
};

} // namespace voluta::timeline
