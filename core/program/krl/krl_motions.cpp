#include "program/krl/krl_motions.h"

#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/krl/krl.h"
#include "program/krl/krl_text.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
constexpr double kRotationDegPerS = 200.0; // minimum
constexpr double kMinRotationDegPerS = 0.5;
constexpr double kStartPercent = 10.0;
constexpr double kMinMmPerS = 1.0; // of $VEL.CP
constexpr double kMinBlendMm = 1e-4;
} // namespace

KrlMotions::KrlMotions(const ProgramInput& input, const base::RunContext& ctx)
    : in_(input), targets_(motionTargets(input, ctx)),
      motions_(in_, targets_, writtenShare, TcpFrame::Work), rotationLimit_(kRotationDegPerS) {
  placeInWorkFrame(in_, kKrlMmDecimals, targets_);
  findRotationLimit();
}

Eigen::Vector3d KrlMotions::degrees(std::size_t i) const {
  return zyxDegrees(targets_[i].tcpRotation);
}

std::optional<ViaTarget> KrlMotions::via(std::size_t i) const {
  const ArcVia* arc = motions_.arc(i);
  return arc ? std::optional(viaTarget(in_, targets_, TcpFrame::Work, *arc)) : std::nullopt;
}

double KrlMotions::rotationDegPerS(std::size_t i) const {
  const double s = motions_.seconds(i);
  return s > 0.0 ? base::radiansToDegrees(
                       targets_[i].tcpRotation.angularDistance(targets_[i - 1].tcpRotation)) /
                       s
                 : 0.0;
}

// Returns whether the TCP hardly moves, so that its rotation speed determines the motion's time.
bool KrlMotions::isTimedByRotation(std::size_t i) const {
  return motions_.needsTime(i) && rotationDegPerS(i) > kMinRotationDegPerS;
}

void KrlMotions::findRotationLimit() {
  for (std::size_t i = 1; i < targets_.size(); ++i)
    if (in_.trajectory.move[i] != plan::MoveKind::Joint && !isTimedByRotation(i)) {
      rotationLimit_ = std::max(rotationLimit_, std::ceil(1.05 * rotationDegPerS(i)));
      slow_ += motions_.seconds(i) > 0.0 && motions_.speedMmPerS(i) < kMinMmPerS ? 1 : 0;
    }
}

double KrlMotions::mmPerS(std::size_t i) const {
  const double mmPerS = motions_.speedMmPerS(i);
  return isTimedByRotation(i) || !(mmPerS > 0.0)
             ? std::max(in_.process().travelSpeedMmPerS, 2.0 * mmPerS)
             : mmPerS;
}

double KrlMotions::degPerS(std::size_t i) const {
  return isTimedByRotation(i) ? rotationDegPerS(i) : rotationLimit_;
}

double KrlMotions::blendMm(std::size_t i) const {
  const double blend = motions_.blendMm(i);
  return blend < kMinBlendMm ? 0.0 : blend;
}

double KrlMotions::jointPercent(std::size_t i) const {
  const double s = motionSeconds(in_.trajectory, i);
  if (!(s > 0.0))
    return kStartPercent;
  return std::clamp(
      std::round(100.0 * base::radiansToDegrees(leadingJointRad(in_, i)) / s / kKrlPtpDegPerS), 1.0,
      100.0);
}

} // namespace voluta::program
