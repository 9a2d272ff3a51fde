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
// The counts of a very small flow are so coarse that its motion would take another time than
// planned: the time is kept where the material differs by less than this.
constexpr double kCoarseShare = 0.04, kHardlyMm3 = 0.002;

bool keepsTime(double seconds, double volumeMm3, double flowMm3PerS) {
  return std::abs(volumeMm3 / flowMm3PerS - seconds) > kCoarseShare * seconds &&
         std::abs(volumeMm3 - flowMm3PerS * seconds) < kHardlyMm3;
}
} // namespace

double assumedLoadKg(const ProgramInput& input) {
  if (input.cell.nozzleMount() != robot::Mount::World)
    return input.cell.carriedKg();
  return input.cell.carriedKg() + 1e-3 * input.tooling.printedG(input.trajectory);
}

std::string_view assumedLoadText(const ProgramInput& input) {
  const bool plate = input.cell.nozzleMount() == robot::Mount::World;
  if (!input.cell.carriedIsAssumed())
    return plate ? "the plate as the cell has it, and the part" : "the head as the cell has it";
  return plate ? "0.5 kg of plate, and the part" : "1 kg of head";
}

ViaTarget viaTarget(const ProgramInput& input, const std::vector<MotionTarget>& targets,
                    TcpFrame frame, const ArcVia& arc) {
  const MotionTarget& to = targets[arc.point];
  ViaTarget via{targets[arc.point - 1].tcpRotation.slerp(0.5, to.tcpRotation), arc.tipMm};
  if (frame == TcpFrame::Work)
    return via;
  // The TCP moves with the tip, or the part against it.
  const robot::Cell& cell = input.cell;
  const Eigen::Vector3d step = arc.tipMm - to.tipMm;
  via.mm = cell.nozzleMount() == robot::Mount::World
               ? Eigen::Vector3d(to.tcpMm - to.tcpRotation * step)
               : Eigen::Vector3d(to.tcpMm + cell.base_T_work(cell.home()).linear() * step);
  return via;
}

TcpMotions::TcpMotions(const ProgramInput& input, const std::vector<MotionTarget>& targets,
                       double (*written)(double share), TcpFrame frame)
    : in_(input), targets_(targets), frame_(frame), seconds_(targets.size(), 0.0),
      flow_(targets.size(), 0.0) {
  const double full = in_.tooling.fullFlowMm3PerS();
  const Extruder& extruder = extruderOf(in_);
  double held = 0.0;
  bool trails = false; // the extruder is off and its stop lag ends the bead
  for (std::size_t i = 1; i < targets.size(); ++i) {
    double s = motionSeconds(in_.trajectory, i);
    trails = isPrint(in_.trajectory, i) &&
             (trails || std::ranges::any_of(in_.trajectory.eventsBefore(i), [](const auto& event) {
                return event.kind == plan::EventKind::StopLag;
              }));
    if (isPrint(in_.trajectory, i)) {
      const double volume = motionVolumeMm3(in_.trajectory, i);
      s = std::max(s, volume / full);
      const double wanted = s > 0.0 ? volume / s : 0.0;
      // an extruder axis is given amounts, so that its flow need not be stepped
      if (trails) {
        flow_[i] = 0.0;
      } else if (extruder.byAxis) {
        flow_[i] = wanted;
      } else if (wanted > 0.0) {
        if (std::abs(wanted - held) > kFlowBand * held)
          held = writtenBy(extruder, in_.process(), wanted / full, written) * full;
        flow_[i] = held;
        if (held > 0.0 && !keepsTime(s, volume, held))
          s = volume / held;
      }
    }
    seconds_[i] = s;
  }
}

const ArcVia* TcpMotions::arc(std::size_t i) const {
  const auto at = std::ranges::lower_bound(in_.arcs, i, {}, &ArcVia::point);
  return at != in_.arcs.end() && at->point == i ? &*at : nullptr;
}

std::optional<Arc> TcpMotions::tipArc(std::size_t i) const {
  const ArcVia* via = arc(i);
  return via ? arcThrough(targets_[i - 1].tipMm, via->tipMm, targets_[i].tipMm) : std::nullopt;
}

std::optional<Arc> TcpMotions::tcpArc(std::size_t i) const {
  const ArcVia* via = arc(i);
  return via ? arcThrough(targets_[i - 1].tcpMm, viaTarget(in_, targets_, frame_, *via).mm,
                          targets_[i].tcpMm)
             : std::nullopt;
}

namespace {
Eigen::Vector3d alongArc(const Arc& arc, bool start) {
  return arc.lengthMm() * arc.directionAt(start ? 0.0 : arc.sweepRad);
}
} // namespace

Eigen::Vector3d TcpMotions::tipAlong(std::size_t i, End end) const {
  if (const std::optional<Arc> arc = tipArc(i))
    return alongArc(*arc, end == End::Start);
  return targets_[i].tipMm - targets_[i - 1].tipMm;
}

Eigen::Vector3d TcpMotions::tcpAlong(std::size_t i, End end) const {
  if (const std::optional<Arc> arc = tcpArc(i))
    return alongArc(*arc, end == End::Start);
  return targets_[i].tcpMm - targets_[i - 1].tcpMm;
}

double TcpMotions::tcpMm(std::size_t i) const {
  return tcpAlong(i, End::Start).norm();
}

double TcpMotions::tipMm(std::size_t i) const {
  return tipAlong(i, End::Start).norm();
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
  const BlendSegment in{tcpMm(i), tipAlong(i, End::Stop)};
  const BlendSegment out{tcpMm(i + 1), tipAlong(i + 1, End::Start)};
  if (angleRad(in.nozzle, out.nozzle) > kTurnsBackRad)
    return 0.0;
  // Round down, so that the allowed radius is not exceeded.
  double radius = blendRadiusMm(in, out, kFirstOrderShare * kBlendToleranceMm);
  // A blend follows the tangent of an arc, which adds a quarter of r^2 / R: at most a sixteenth of
  // the tolerance.
  for (const std::optional<Arc>& arc : {tipArc(i), tipArc(i + 1)})
    if (arc)
      radius = std::min(radius, 0.5 * std::sqrt(arc->radiusMm * kBlendToleranceMm));
  return std::floor(radius * 1e3) / 1e3;
}

double TcpMotions::blendMmPerS2(std::size_t i) const {
  const double r = blendMm(i);
  if (!(r > 0.0 && seconds(i) > 0.0 && seconds(i + 1) > 0.0))
    return 0.0;
  const double s = r / speedMmPerS(i) + r / speedMmPerS(i + 1);
  return (tcpAlong(i + 1, End::Start) / seconds(i + 1) - tcpAlong(i, End::Stop) / seconds(i))
             .norm() /
         s;
}

} // namespace voluta::program
