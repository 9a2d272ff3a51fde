#include "program/stream/pvt_velocities.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {

constexpr double kMaxOfOne = 4.0 / 27.0; // of u (1 - u)^2
constexpr double kMaxFaster = 1.5;
constexpr double kMinMm = 1e-9;
// Maximum deviation of an angle caused by the velocity at one end: share of its displacement, plus
// a constant.
constexpr double kRotationShare = 0.25, kMinRotationDeg = 0.15;

// Returns the lateral deviation of a motion from its line caused by the velocity at one end [mm].
double acrossMm(const PvtMotion& motion, const PvtVector& velocity) {
  const Eigen::Vector3d displacement = motion.displacement.head<3>();
  const Eigen::Vector3d v = velocity.head<3>();
  const double length = displacement.norm();
  const Eigen::Vector3d across =
      length > kMinMm
          ? Eigen::Vector3d(v - displacement * (v.dot(displacement) / (length * length)))
          : v;
  return kMaxOfOne * motion.seconds * across.norm();
}

} // namespace

PvtDeviation pvtDeviation(const PvtMotion& motion, const PvtVector& from, const PvtVector& to) {
  PvtDeviation worst;
  const Eigen::Vector3d displacement = motion.displacement.head<3>();
  const double length = displacement.norm(), t = motion.seconds;
  constexpr int kSteps = 16;
  for (int k = 1; k < kSteps; ++k) {
    const double u = static_cast<double>(k) / kSteps;
    const double in = u * (1.0 - u) * (1.0 - u), out = -u * u * (1.0 - u);
    const double rise = u * u * (3.0 - 2.0 * u);
    const Eigen::Vector3d at = rise * displacement + t * (in * from.head<3>() + out * to.head<3>());
    const double along = length > kMinMm ? at.dot(displacement) / (length * length) : 0.0;
    worst.acrossMm = std::max(worst.acrossMm, (at - along * displacement).norm());
    if (length > kMinMm)
      worst.alongShare = std::max(worst.alongShare, std::abs(along - u));
  }
  return worst;
}

bool pvtTurnsEvenly(const PvtMotion& motion, int k, double from, double to) {
  const double even = motion.displacement[k] / motion.seconds;
  const double off = kMaxOfOne * motion.seconds * (std::abs(from - even) + std::abs(to - even));
  // Twice the limit for one end, plus twice the deviation caused by a stop.
  return off <=
         2.0 * ((kRotationShare + kMaxOfOne) * std::abs(motion.displacement[k]) + kMinRotationDeg);
}

PvtFit pvtFit(const PvtVector& stated, const PvtMotion& in, const PvtMotion& out,
              double toleranceMm) {
  // Tolerated deviation from the suitable velocity, as a share of the mean ones of both motions,
  // and of the angles [degrees/s] in addition.
  constexpr double kShare = 0.2, kSlackDegPerS = 1.0, kBackShare = 0.1;
  const PvtVector suits = pvtVelocity(in, out, toleranceMm);
  const auto meanOf = [&](int first) {
    return 0.5 * (in.displacement.segment<3>(first).norm() / in.seconds +
                  out.displacement.segment<3>(first).norm() / out.seconds);
  };
  const auto offBy = [&](int first) {
    return (stated.segment<3>(first) - suits.segment<3>(first)).norm();
  };
  const auto reverses = [&](int first, double slack) {
    const Eigen::Vector3d a = stated.segment<3>(first), b = suits.segment<3>(first);
    return a.dot(b) < -kBackShare * b.squaredNorm() && a.norm() > slack;
  };
  PvtFit fit;
  fit.statedMmPerS = stated.head<3>().norm();
  fit.suitsMmPerS = suits.head<3>().norm();
  fit.isSpeedSuitable = std::abs(fit.statedMmPerS - fit.suitsMmPerS) <= kShare * meanOf(0);
  fit.isDirectionSuitable =
      offBy(0) <= kShare * meanOf(0) && offBy(3) <= kShare * meanOf(3) + kSlackDegPerS;
  fit.reverses = reverses(0, 0.0) || reverses(3, kSlackDegPerS);
  return fit;
}

PvtVector pvtVelocity(const PvtMotion& in, const PvtMotion& out, double toleranceMm) {
  const double s = in.seconds + out.seconds;
  PvtVector velocity = (in.displacement * (out.seconds / in.seconds) +
                        out.displacement * (in.seconds / out.seconds)) /
                       s;
  double share = 1.0;
  for (const PvtMotion* motion : {&in, &out}) {
    if (const double off = acrossMm(*motion, velocity); off > toleranceMm)
      share = std::min(share, toleranceMm / off);
    if (velocity.head<3>().dot(motion->displacement.head<3>()) < 0.0)
      return PvtVector::Zero(); // it would reverse
    const double speed = motion->displacement.head<3>().norm() / motion->seconds;
    if (const double own = velocity.head<3>().norm(); own > kMaxFaster * speed)
      share = std::min(share, kMaxFaster * speed / own);
    for (int k = 3; k < 6; ++k) {
      const double maximum =
          (kRotationShare * std::abs(motion->displacement[k]) + kMinRotationDeg) /
          (kMaxOfOne * motion->seconds);
      if (const double rate = std::abs(velocity[k]); rate > maximum)
        share = std::min(share, maximum / rate);
    }
  }
  return share * velocity;
}

} // namespace voluta::program
