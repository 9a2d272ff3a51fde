#include "program/tcp_motions.h"

#include "program/blend.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
// Below these the TCP's path says too little of the motion's time.
constexpr double kLeastTcpMm = 0.05, kLeastTcpShare = 0.1;
constexpr double kLeastSpeedMmPerS = 0.2;
// blendRadiusMm takes the nozzle's path on the part as straight near the corner; a plate that turns
// while it moves bends it, in hard random motions by up to 5 % of the tolerance.
constexpr double kFirstOrderShare = 0.85;
constexpr double kPlateKg = 0.5, kHeadKg = 1.0;
} // namespace

double assumedLoadKg(const ProgramInput& input) {
  if (input.cell.nozzleMount() != robot::Mount::World)
    return kHeadKg;
  return kPlateKg + input.trajectory.extrudedMm3.back() * 1e-6 * input.process.densityGPerCm3;
}

double TcpMotions::seconds(std::size_t i) const {
  double s = motionSeconds(in_.trajectory, i);
  if (isPrint(in_.trajectory, i))
    s = std::max(s, motionVolumeMm3(in_.trajectory, i) / in_.process.maxFlowMm3PerS);
  return s;
}

double TcpMotions::flowMm3PerS(std::size_t i) const {
  const double s = seconds(i);
  return s > 0.0 ? motionVolumeMm3(in_.trajectory, i) / s : 0.0;
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
  return seconds(i) > 0.0 && (tcp < kLeastTcpMm || tcp < kLeastTcpShare * tipMm(i) ||
                              speedMmPerS(i) < kLeastSpeedMmPerS);
}

double TcpMotions::blendMm(std::size_t i) const {
  const plan::Trajectory& t = in_.trajectory;
  if (!isPrint(t, i) || i + 1 >= t.pointCount() || !isPrint(t, i + 1))
    return 0.0;
  const double r = blendRadiusMm({tcpMm(i), targets_[i].tipMm - targets_[i - 1].tipMm},
                                 {tcpMm(i + 1), targets_[i + 1].tipMm - targets_[i].tipMm},
                                 kFirstOrderShare * kBlendToleranceMm);
  // Rounded down: it must not grow past what was allowed.
  return std::floor(r * 1e3) / 1e3;
}

} // namespace voluta::program
