#include "program/melfa/melfa_motions.h"

#include "base/units.h"
#include "program/common/euler_angles.h"
#include "program/common/program_text.h"
#include "program/melfa/melfa.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
constexpr double kMinPercent = 1.0, kMinMmPerS = 0.01;
constexpr double kMinBlendMm = 0.0009; // 0.001 mm is written

double countedShare(double share) {
  return std::clamp(std::max(1.0, std::round(share * kMelfaFullFlow)) / kMelfaFullFlow, 0.0, 1.0);
}
} // namespace

std::string melfaPosition(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees, int mmDecimals,
                          int degDecimals, std::string_view flags) {
  std::string text = "(";
  for (int k = 0; k < 3; ++k)
    text += fixedText(mm[k], mmDecimals) + ",";
  for (int k = 0; k < 3; ++k)
    text += fixedText(degrees[k], degDecimals) + (k < 2 ? "," : ")");
  text += flags;
  return text;
}

Eigen::Vector3d melfaDegrees(const Eigen::Isometry3d& pose) {
  return xyzAngles(Eigen::Quaterniond(pose.linear())) * base::radiansToDegrees(1.0);
}

std::string melfaFrame(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees) {
  return melfaPosition(mm, degrees, kMelfaFrameDecimals, kMelfaFrameDecimals, "(0,0)");
}

MelfaMotions::MelfaMotions(const ProgramInput& input, const base::RunContext& ctx)
    : in_(input), targets_(motionTargets(input, ctx)), poses_(targets_), angles_(targets_.size()),
      motions_(input, targets_, countedShare) {
  placeNozzle();
}

// Converts the targets to those of the straight motion: the nozzle relative to the work that the
// arm holds. Uses rounded values as written, so that rounding does not change speeds.
void MelfaMotions::placeNozzle() {
  const Eigen::Isometry3d& nozzle = in_.cell.base_T_fixed();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    angles_[i] = xyzAngles(poses_[i].tcpRotation);
    for (int k = 0; k < 3; ++k) {
      angles_[i][k] = roundedTo(base::radiansToDegrees(angles_[i][k]), kMelfaDegDecimals);
      poses_[i].tcpMm[k] = roundedTo(poses_[i].tcpMm[k], kMelfaMmDecimals);
    }
    if (!holdsWork()) {
      targets_[i].tcpMm = poses_[i].tcpMm;
      continue;
    }
    Eigen::Isometry3d pose(rotationOfXyz(angles_[i] * base::degreesToRadians(1.0)));
    pose.pretranslate(poses_[i].tcpMm);
    targets_[i].tcpMm = pose.inverse() * nozzle.translation();
  }
}

double MelfaMotions::mmPerS(std::size_t i) const {
  return motions_.seconds(i) > 0.0 ? std::max(motions_.speedMmPerS(i), kMinMmPerS)
                                   : in_.process().travelSpeedMmPerS;
}

double MelfaMotions::blendMm(std::size_t i) const {
  const double maximum = motions_.blendMm(i);
  return maximum < kMinBlendMm ? 0.0 : maximum;
}

double MelfaMotions::jointPercent(std::size_t i) const {
  const double s = motionSeconds(in_.trajectory, i);
  if (!(s > 0.0))
    return kMelfaStartPercent;
  return std::clamp(100.0 * leadingJointRad(in_, i) / s / kMelfaJointRadPerS, kMinPercent, 100.0);
}

} // namespace voluta::program
