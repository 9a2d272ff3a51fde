// Cache of transfers, including failed searches.
#pragma once

#include "motion/bead_run.h"
#include "motion/transfers/transfer.h"

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace voluta::motion {

// If a motion is connected a second time, most of its transfers are unchanged, and failed searches
// take longest. Thread-safe.
class KnownTransfers {
public:
  enum class Purpose {
    Between,
    BetweenHigh,
    Leave,
    LeaveThoroughly,
    Approach,
    ApproachThoroughly,
    Dock,
    DockStraight
  };

  // Returns the cached result or that of `find()`. The latter must depend only on the kind of
  // transfer, the states at its ends, the waypoints there (which determine the printed material and
  // the seed) and the surroundings.
  template <typename Find>
  std::optional<Transfer> of(Purpose purpose, const RobotState& from, const RobotState& to,
                             std::size_t fromWaypoint, std::size_t toWaypoint,
                             const PrintedBounds& surround, Find&& find) {
    const std::string key = keyOf(purpose, from, to, fromWaypoint, toWaypoint, surround);
    {
      const std::lock_guard lock(mutex_);
      if (const auto known = known_.find(key); known != known_.end())
        return known->second;
    }
    std::optional<Transfer> transfer = find();
    const std::lock_guard lock(mutex_);
    return known_.emplace(key, std::move(transfer)).first->second;
  }

private:
  static std::string keyOf(Purpose purpose, const RobotState& from, const RobotState& to,
                           std::size_t fromWaypoint, std::size_t toWaypoint,
                           const PrintedBounds& surround);

  std::mutex mutex_;
  std::unordered_map<std::string, std::optional<Transfer>> known_;
};

} // namespace voluta::motion
