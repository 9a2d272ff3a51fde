#include "replay/head_follower.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;

// Size of a neighbourhood: motion of the tip, its part along the axis, motion of the axis' end,
// pieces printed in between.
constexpr double kShiftMm = 2.0, kAlongMm = 0.1, kRotation = 0.03;
constexpr std::uint32_t kPieces = 16;
constexpr double kRoundingMm = 1e-9;

} // namespace

bool HeadFollower::isNear(const Vector3d& tip, const Vector3d& direction,
                          const PrintState& moment) const {
  const Vector3d step = tip - tip_;
  return moment.before <= before_ && step.squaredNorm() <= kShiftMm * kShiftMm &&
         std::abs(step.dot(direction)) <= kAlongMm &&
         (direction - direction_).squaredNorm() <= kRotation * kRotation;
}

void HeadFollower::gather(const Vector3d& tip, const Vector3d& direction,
                          const PrintState& moment) {
  tip_ = tip;
  direction_ = direction;
  before_ = moment.before + std::min(kPieces, kNeverFilled - moment.before);
  const double bottom = head_.lowest(0.0, 1.0), share = direction.lpNorm<1>() / std::sqrt(3.0);
  Eigen::AlignedBox3d box = head_.boxRound(tip, direction);
  const Vector3d slack = Vector3d::Constant(kShiftMm + kRotation * head_.reach());
  box = {box.min() - slack, box.max() + slack};
  blocks_.clear();
  part_.blocksWithin(
      box, before_,
      [&](const Vector3d& q, double reach) {
        const Vector3d r = q - tip;
        const double z = r.dot(direction), squared = r.squaredNorm();
        // A rotation moves points in proportion to their distance from the tip, along the axis and
        // across it.
        const double turned = kRotation * (std::sqrt(squared) + reach);
        return z >= bottom - share * reach - kAlongMm - turned &&
               head_.within(squared - z * z, z, reach + kShiftMm + turned);
      },
      blocks_);
}

std::optional<Vector3d> HeadFollower::touched(const Vector3d& tip, const Vector3d& direction,
                                              const PrintState& moment) {
  if (!isNear(tip, direction, moment))
    gather(tip, direction, moment);
  // Nearly all queried cells are below the tip. A block's reach is that of its corners; along the
  // axis it is less.
  const double bottom = head_.lowest(0.0, 1.0) - kRoundingMm,
               along = direction.lpNorm<1>() / std::sqrt(3.0);
  const auto within = [&](const Vector3d& q, double reach) {
    const Vector3d r = q - tip;
    const double z = r.dot(direction);
    return z >= bottom - along * reach &&
           head_.within(std::max(0.0, r.squaredNorm() - z * z), z, reach);
  };
  for (const PrintedPart::Block& block : blocks_) {
    if (!within(block.middle, part_.blockReach()))
      continue;
    if (const auto cell = part_.firstIn(block, moment, within)) {
      const Eigen::Vector3i c = part_.grid().cell(*cell);
      return part_.grid().centre(c.x(), c.y(), c.z());
    }
  }
  return std::nullopt;
}

} // namespace voluta::replay
