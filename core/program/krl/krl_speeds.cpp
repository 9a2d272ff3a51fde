#include "program/krl/krl_speeds.h"
#include "program/common/arc_motion.h"

#include "base/units.h"
#include "program/krl/krl.h"

#include <algorithm>
#include <string>

namespace voluta::program {

namespace {

constexpr double kMax = 1e5;
constexpr double kRotationDegPerS = 400.0; // for programs that set no limit: usual machine data

std::optional<base::Message> jointSpeed(const KrlVariables& variables, plan::ProgramMotion& m) {
  double percent = 0.0;
  for (int axis = 1; axis <= 6; ++axis)
    percent = std::max(percent,
                       variables.number("$vel_axis[" + std::to_string(axis) + "]").value_or(0.0));
  if (percent == 0.0)
    percent = 100.0;
  if (!(percent > 0.0 && percent <= 100.0))
    return "an invalid speed"_text;
  m.jointSpeedRadPerS = base::degreesToRadians(kKrlPtpDegPerS) * percent / 100.0;
  return std::nullopt;
}

} // namespace

std::optional<base::Message> krlSpeed(const KrlVariables& variables,
                                      const std::optional<Eigen::Isometry3d>& last,
                                      plan::ProgramMotion& m) {
  if (m.jointInterpolated)
    return jointSpeed(variables, m);
  const auto speed = variables.number("$vel.cp");
  if (!speed)
    return "$VEL.CP is not set before this motion"_text;
  const double turning = std::min(variables.number("$vel.ori1").value_or(kRotationDegPerS),
                                  variables.number("$vel.ori2").value_or(kRotationDegPerS));
  const double acceleration = variables.number("$acc.cp").value_or(0.0);
  for (const double v : {*speed, turning})
    if (!(v > 0.0 && v <= kMax))
      return "an invalid speed"_text;
  if (!(acceleration >= 0.0 && acceleration <= kMax))
    return "an acceleration is no sensible number"_text;
  m.speedMmPerS = *speed * 1000.0;
  m.accelerationMmPerS2 = acceleration * 1000.0 < kKrlMaxMmPerS2 ? acceleration * 1000.0 : 0.0;
  if (last)
    slowByRotation(*last, turning, m);
  return std::nullopt;
}

void slowByRotation(const Eigen::Isometry3d& last, double turning, plan::ProgramMotion& m) {
  const double seconds = lengthMm(last.translation(), m) / m.speedMmPerS;
  const double angle =
      base::radiansToDegrees(Eigen::Quaterniond(m.frame_T_tcp.linear())
                                 .angularDistance(Eigen::Quaterniond(last.linear())));
  if (angle / turning > seconds + 1e-9) {
    m.durationS = angle / turning;
    m.speedMmPerS = 0.0;
  }
}

std::optional<base::Message> krlBlend(const KrlVariables& variables, plan::ProgramMotion& m) {
  if (m.jointInterpolated)
    return base::message("how '{word}' rounds a corner is not known to the reader"_text,
                         "PTP C_DIS"_name);
  const auto mm = variables.number("$apo.cdis");
  if (!mm)
    return "$APO.CDIS is not set before this motion"_text;
  if (!(*mm >= 0.0 && *mm <= kMax))
    return "a blend is no sensible number"_text;
  if (variables.number("$advance").value_or(3.0) >= 1.0)
    m.blendMm = *mm;
  return std::nullopt;
}

} // namespace voluta::program
