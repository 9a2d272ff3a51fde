#include "timeline/waiting_clock.h"

#include <algorithm>
#include <utility>

namespace voluta::timeline {

WaitingClock::WaitingClock(std::vector<OwnWait> waits, double ownEndS, double endS)
    : waits_(std::move(waits)), ownEndS_(ownEndS), endS_(endS) {}

double WaitingClock::ownTimeS(double commonS) const {
  const auto next = std::ranges::upper_bound(waits_, commonS, {}, &OwnWait::fromS);
  double ownFrom = 0.0, from = 0.0;
  if (next != waits_.begin()) {
    const OwnWait& last = *std::prev(next);
    if (commonS <= last.toS)
      return last.ownS;
    ownFrom = last.ownS;
    from = last.toS;
  }
  const double ownTo = next == waits_.end() ? ownEndS_ : next->ownS;
  const double to = next == waits_.end() ? endS_ : next->fromS;
  const double share = to > from ? std::clamp((commonS - from) / (to - from), 0.0, 1.0) : 1.0;
  return ownFrom + share * (ownTo - ownFrom);
}

} // namespace voluta::timeline
