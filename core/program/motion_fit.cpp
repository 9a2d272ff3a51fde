#include "program/motion_fit.h"

#include "base/units.h"
#include "program/common/blend.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::program {

using Eigen::Vector3d;

namespace {
constexpr double kSlack = 1e-9; // for rounding errors
// Larger circles are lines as far as a bead reaches.
constexpr double kMaxRadiusMm = 1000.0, kMinRadiusMm = 0.2;
// Controllers limit arcs to less than a turn, and the point on it to its middle part.
constexpr double kMaxSweepRad = base::kPi;
// Of the nozzle on arcs in Base or in a plane of X and Y. Others turn it evenly along the arc.
constexpr double kArcRotationRad = 2e-3;
// Larger turns of the arm's tool would take another way.
constexpr double kMaxArcRotationRad = 0.5 * base::kPi;
// A part that turns while its TCP moves along an arc moves on another curve below the nozzle.
constexpr double kPartRotationRad = 2e-5, kSameRotationRad = 1e-7;
constexpr double kSameHeightMm = 1e-3;
// Further turns about the nozzle's axis would move the arm elsewhere.
constexpr double kTcpRotationRad = 0.05;
} // namespace

MotionFit::MotionFit(const ProgramInput& input, const MergeLimits& limits,
                     const std::vector<MotionTarget>& targets)
    : in_(input.trajectory), cell_(input.cell), limits_(limits), targets_(targets),
      heldInBase_(limits.inBase && input.cell.nozzleMount() == robot::Mount::World) {}

bool MotionFit::growsEvenly(const std::vector<double>& amount, double share, std::size_t from,
                            std::size_t to, double lengthMm) const {
  const double perMm = (amount[to] - amount[from]) / lengthMm;
  for (std::size_t i = from + 1; i <= to; ++i) {
    const double step = (targets_[i].tipMm - targets_[i - 1].tipMm).norm();
    if (std::abs(amount[i] - amount[i - 1] - perMm * step) > share * perMm * step)
      return false;
  }
  return true;
}

bool MotionFit::hasSection(std::size_t from, std::size_t to, double lengthMm) const {
  return growsEvenly(in_.extrudedMm3, limits_.sectionShare, from, to, lengthMm);
}

bool MotionFit::hasSpeed(std::size_t from, std::size_t to, double lengthMm) const {
  return growsEvenly(in_.timeS, limits_.speedShare, from, to, lengthMm);
}

bool MotionFit::hasDirection(std::size_t from, std::size_t to, std::size_t point,
                             double share) const {
  const Vector3d axis =
      ((1.0 - share) * targets_[from].direction + share * targets_[to].direction).normalized();
  return angleRad(axis, targets_[point].direction) <= limits_.toleranceRad;
}

bool MotionFit::turnsPart(std::size_t from, std::size_t to, double rad) const {
  return targets_[from].tcpRotation.angularDistance(targets_[to].tcpRotation) > rad;
}

Vector3d MotionFit::tipOnLine(std::size_t from, std::size_t to, double share) const {
  const MotionTarget &a = targets_[from], &b = targets_[to];
  if (!heldInBase_ || !turnsPart(from, to, kSameRotationRad))
    return a.tipMm + share * (b.tipMm - a.tipMm);
  Eigen::Isometry3d tcp = Eigen::Isometry3d::Identity();
  tcp.linear() = a.tcpRotation.slerp(share, b.tcpRotation).toRotationMatrix();
  tcp.translation() = a.tcpMm + share * (b.tcpMm - a.tcpMm);
  return cell_.work_T_toolOfFlange(tcp * cell_.flange_T_moved().inverse(), cell_.home())
      .translation();
}

bool MotionFit::isLine(std::size_t from, std::size_t to) const {
  const Vector3d a = targets_[from].tipMm, span = targets_[to].tipMm - a;
  const double length = span.norm();
  if (!(length > 0.0) || !hasSection(from, to, length) ||
      (limits_.all && !hasSpeed(from, to, length)))
    return false;
  for (std::size_t i = from + 1; i <= to; ++i) {
    const double u = (targets_[i].tipMm - a).dot(span) / (length * length);
    if (u < -kSlack || u > 1.0 + kSlack)
      return false;
    const Vector3d tip = limits_.all ? tipOnLine(from, to, u) : Vector3d(a + u * span);
    if ((targets_[i].tipMm - tip).norm() > limits_.toleranceMm || !hasDirection(from, to, i, u))
      return false;
    if (limits_.all && targets_[from]
                               .tcpRotation.slerp(u, targets_[to].tcpRotation)
                               .angularDistance(targets_[i].tcpRotation) > kTcpRotationRad)
      return false;
  }
  return true;
}

bool MotionFit::fits(const Arc& arc, std::size_t from, std::size_t to) const {
  double last = 0.0;
  for (std::size_t i = from + 1; i <= to; ++i) {
    const Vector3d middle = 0.5 * (targets_[i - 1].tipMm + targets_[i].tipMm);
    if (arc.distanceMm(targets_[i].tipMm) > limits_.arcMm || arc.distanceMm(middle) > limits_.arcMm)
      return false;
    const double angle = i == to ? arc.sweepRad : arc.angleOf(targets_[i].tipMm);
    if (!(angle > last) || angle > arc.sweepRad + kSlack ||
        !hasDirection(from, to, i, angle / arc.sweepRad))
      return false;
    last = angle;
  }
  return true;
}

bool MotionFit::canRotate(std::size_t from, std::size_t to) const {
  for (std::size_t i = from + 1; i <= to; ++i)
    if (((limits_.inBase || limits_.levelArcs) &&
         angleRad(targets_[from].direction, targets_[i].direction) > kArcRotationRad) ||
        (heldInBase_ && turnsPart(from, i, kPartRotationRad)) ||
        (limits_.levelArcs &&
         std::abs(targets_[i].tipMm.z() - targets_[from].tipMm.z()) > kSameHeightMm) ||
        targets_[from].tcpRotation.angularDistance(targets_[i].tcpRotation) > kMaxArcRotationRad)
      return false;
  return true;
}

std::optional<Vector3d> MotionFit::arcVia(std::size_t from, std::size_t to) const {
  if (!canRotate(from, to))
    return std::nullopt;
  const Vector3d &start = targets_[from].tipMm, &end = targets_[to].tipMm;
  Vector3d via = targets_[from + (to - from) / 2].tipMm;
  std::optional<Arc> arc;
  // Moves the middle of the arc until the largest deviations on both sides are equal.
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    arc = arcThrough(start, via, end);
    if (!arc || arc->radiusMm > kMaxRadiusMm || arc->radiusMm < kMinRadiusMm ||
        arc->sweepRad > kMaxSweepRad)
      return std::nullopt;
    double minimum = 0.0, maximum = 0.0;
    for (std::size_t i = from + 1; i <= to; ++i)
      for (const Vector3d& p :
           {targets_[i].tipMm, Vector3d(0.5 * (targets_[i - 1].tipMm + targets_[i].tipMm))}) {
        const double off = (p - arc->centre).norm() - arc->radiusMm;
        minimum = std::min(minimum, off);
        maximum = std::max(maximum, off);
      }
    const double angle = 0.5 * arc->sweepRad;
    via = arc->at(angle) + 0.5 * (minimum + maximum) * (arc->at(angle) - arc->centre).normalized();
  }
  arc = arcThrough(start, via, end);
  if (!arc || arc->sweepRad > kMaxSweepRad || !fits(*arc, from, to) ||
      !hasSection(from, to, arc->lengthMm()) || !hasSpeed(from, to, arc->lengthMm()))
    return std::nullopt;
  return arc->at(0.5 * arc->sweepRad);
}

} // namespace voluta::program
