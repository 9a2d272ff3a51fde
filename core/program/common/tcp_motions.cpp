#include "program/common/tcp_motions.h"

#include "program/common/blend.h"
#include "program/common/extruder_outputs.h"
#include "program/extruder.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
// Below these the TCP's path is too short to define the motion's time.
constexpr double kMinTcpMm = 0.05, kMinTcpShare = 0.1;
constexpr double kMinSpeedMmPerS = 0.2;
// blendRadiusMm assumes that the nozzle's path on the part is straight near the corner. A plate
// that turns while it moves bends that path, in extreme random motions by up to 5 % of the
// tolerance.
constexpr double kFirstOrderShare = 0.85;
} // namespace

double assumedLoadKg(const ProgramInput& input) {
  if (input.cell.nozzleMount() != robot::Mount::World)
    return input.cell.carriedKg();
  return input.cell.carriedKg() +
         input.trajectory.extrudedMm3.back() * 1e-6 * input.process().material.densityGPerCm3;
}

std::string_view assumedLoadText(const ProgramInput& input) {
  const bool plate = input.cell.nozzleMount() == robot::Mount::World;
  if (!input.cell.carriedIsAssumed())
    return plate ? "the plate as the cell has it, and the part" : "the head as the cell has it";
  return plate ? "0.5 kg of plate, and the part" : "1 kg of head";
}

TcpMotions::TcpMotions(const ProgramInput& input, const std::vector<MotionTarget>& targets,
                       double (*written)(double share))
    : in_(input), targets_(targets), seconds_(targets.size(), 0.0), flow_(targets.size(), 0.0) {
  const double full = in_.process().maxFlowMm3PerS;
  const Extruder& extruder = extruderOf(in_);
  double held = 0.0;
  for (std::size_t i = 1; i < targets.size(); ++i) {
    double s = motionSeconds(in_.trajectory, i);
    if (isPrint(in_.trajectory, i)) {
      const double volume = motionVolumeMm3(in_.trajectory, i);
      s = std::max(s, volume / full);
      const double wanted = s > 0.0 ? volume / s : 0.0;
      // an extruder axis is given amounts, so that its flow need not be stepped
      if (extruder.byAxis) {
        flow_[i] = wanted;
      } else if (wanted > 0.0) {
        if (std::abs(wanted - held) > kFlowBand * held)
          held = writtenBy(extruder, in_.process(), wanted / full, written) * full;
        flow_[i] = held;
        s = held > 0.0 ? volume / held : s;
      }
    }
    seconds_[i] = s;
  }
}

double TcpMotions::tcpMm(std::size_t i) const {
  return (targets_[i].tcpMm - targets_[i - 1].tcpMm).norm();
}

double TcpMotions::tipMm(std::size_t i) const {
  return (targets_[i].tipMm - targets_[i - 1].tipMm).norm();
}

double TcpMotions::speedMmPerS(std::size_t i) const {
  const double s = seconds(i);
  return s > 0.0 ? tcpMm(i) / s : 0.0;
}

bool TcpMotions::needsTime(std::size_t i) const {
  const double tcp = tcpMm(i);
  return seconds(i) > 0.0 &&
         (tcp < kMinTcpMm || tcp < kMinTcpShare * tipMm(i) || speedMmPerS(i) < kMinSpeedMmPerS);
}

double TcpMotions::blendMm(std::size_t i) const {
  const plan::Trajectory& t = in_.trajectory;
  if (i + 1 >= t.pointCount() || t.move[i] == plan::MoveKind::Joint || t.move[i + 1] != t.move[i])
    return 0.0;
  const BlendSegment in{tcpMm(i), targets_[i].tipMm - targets_[i - 1].tipMm};
  const BlendSegment out{tcpMm(i + 1), targets_[i + 1].tipMm - targets_[i].tipMm};
  if (turnRad(in.nozzle, out.nozzle) > kTurnsBackRad)
    return 0.0;
  // Round down, so that the allowed radius is not exceeded.
  return std::floor(blendRadiusMm(in, out, kFirstOrderShare * kBlendToleranceMm) * 1e3) / 1e3;
}

double TcpMotions::blendMmPerS2(std::size_t i) const {
  const double r = blendMm(i);
  if (!(r > 0.0 && seconds(i) > 0.0 && seconds(i + 1) > 0.0))
    return 0.0;
  const auto velocity = [&](std::size_t k) -> Eigen::Vector3d {
    return (targets_[k].tcpMm - targets_[k - 1].tcpMm) / seconds(k);
  };
  const double s = r / speedMmPerS(i) + r / speedMmPerS(i + 1);
  return (velocity(i + 1) - velocity(i)).norm() / s;
}

} // namespace voluta::program
