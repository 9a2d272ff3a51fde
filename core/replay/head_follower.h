// Checks the head for collisions with the part printed so far, along the nozzle's path.
#pragma once

#include "replay/distances.h"
#include "replay/printed_part.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::replay {

// For queries at successive places: as the nozzle moves little in between, the blocks near the head
// are gathered once and reused until the nozzle has left the neighbourhood.
class HeadFollower {
public:
  // Keeps references to both.
  HeadFollower(const HeadSolid& head, const PrintedPart& part) : head_(head), part_(part) {}

  // Returns the centre of a printed cell inside the head, nullopt if there is none. Of several it
  // is the first in the part's order, independent of earlier queries. Work frame, mm; `direction`:
  // unit, from the tip into the head.
  std::optional<Eigen::Vector3d>
  touched(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction, const PrintState& moment);

private:
  bool isNear(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
              const PrintState& moment) const;
  void gather(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
              const PrintState& moment);

  const HeadSolid& head_;
  const PrintedPart& part_;
  // The blocks near a place, from pieces before `before_`.
  Eigen::Vector3d tip_ = Eigen::Vector3d::Zero(), direction_ = Eigen::Vector3d::Zero();
  std::uint32_t before_ = 0;
  std::vector<PrintedPart::Block> blocks_;
};

} // namespace voluta::replay
