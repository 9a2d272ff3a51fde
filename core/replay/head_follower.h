// A head along the nozzle's path, against the part as printed so far.
#pragma once

#include "replay/distances.h"
#include "replay/printed_part.h"

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::replay {

// Asked place after place: from one to the next a nozzle moves little, so what the head may meet
// about a place is gathered once and looked through until the nozzle has left it.
class HeadFollower {
public:
  // Keeps references to both.
  HeadFollower(const HeadSolid& head, const PrintedPart& part) : head_(head), part_(part) {}

  // The centre of a printed cell that the head holds; of several the first in the part's order,
  // whatever was asked before. Work frame, mm; `direction`: unit, from the tip into the head.
  std::optional<Eigen::Vector3d>
  touched(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction, const PrintState& moment);

private:
  bool isNear(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
              const PrintState& moment) const;
  void gather(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
              const PrintState& moment);

  const HeadSolid& head_;
  const PrintedPart& part_;
  // About a place, and for pieces before `before_`.
  Eigen::Vector3d tip_ = Eigen::Vector3d::Zero(), direction_ = Eigen::Vector3d::Zero();
  std::uint32_t before_ = 0;
  std::vector<PrintedPart::Block> blocks_;
};

} // namespace voluta::replay
