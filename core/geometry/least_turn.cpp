#include "geometry/least_turn.h"

namespace voluta::geometry {

Eigen::Quaterniond leastTurn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

} // namespace voluta::geometry
