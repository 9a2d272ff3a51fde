// Test pattern: 64 points of a Fibonacci sphere on the ball's surface and again at half its radius,
// and its centre; the nozzle upright, and tilted by a third, two thirds and all of the tilt to 12
// sides; 24 rotations about the nozzle's axis, at least one of which must be in reach. The radius
// is bisected to 0.25 mm: a ball on the plate contains every smaller ball on it, and unreachable
// radii fail quickly.
#include "robot/kinematics/reachable_ball.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "geometry/least_turn.h"
#include "robot/nozzle_turns.h"

#include <cmath>

namespace voluta::robot {

namespace {

using base::kPi;

std::vector<Eigen::Vector3d> unitBallPattern() {
  constexpr int kPoints = 64;
  std::vector<Eigen::Vector3d> points{Eigen::Vector3d::Zero()};
  for (int i = 0; i < kPoints; ++i) {
    // The poles are included: the platform's centre and the point furthest from it.
    const Eigen::Vector3d p = geometry::onSpiral(i, 1.0 - 2.0 * i / (kPoints - 1));
    points.push_back(p);
    points.push_back(0.5 * p);
  }
  return points;
}

// work_R_tool for extrusion against `direction`, before the rotation about the nozzle.
std::vector<Eigen::Matrix3d> toolTurns(double tiltRad) {
  std::vector<Eigen::Matrix3d> turns;
  const auto add = [&](double tilt, double azimuth) {
    const Eigen::Vector3d d(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                            std::cos(tilt));
    turns.push_back(geometry::shortestRotation(Eigen::Vector3d::UnitZ(), d).toRotationMatrix() *
                    Eigen::Vector3d(1, -1, -1).asDiagonal());
  };
  turns.push_back(Eigen::Vector3d(1, -1, -1).asDiagonal());
  if (tiltRad > 0.0)
    for (int ring = 1; ring <= 3; ++ring)
      for (int side = 0; side < 12; ++side)
        add(tiltRad * ring / 3.0, 2.0 * kPi * side / 12.0);
  return turns;
}

constexpr int kNozzleTurns = 24;

class Pattern {
public:
  Pattern(const Cell& cell, double tiltRad)
      : cell_(cell), points_(unitBallPattern()), turns_(toolTurns(tiltRad)) {}

  bool reached(double radius) {
    for (const Eigen::Vector3d& p : points_)
      for (const Eigen::Matrix3d& rotation : turns_)
        if (!reached(radius * (p + Eigen::Vector3d::UnitZ()), rotation))
          return false;
    return true;
  }

private:
  bool reached(const Eigen::Vector3d& tip, const Eigen::Matrix3d& work_R_tool) {
    Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
    work_T_tool.translation() = tip;
    work_T_tool.linear() = work_R_tool;
    const NozzleTurns turns(cell_, work_T_tool, cell_.home());
    // The rotation that reached the last pose is likely to reach this one.
    for (int i = 0; i < kNozzleTurns; ++i) {
      const int rotation = (lastRotation_ + i) % kNozzleTurns;
      turns.at(2.0 * kPi * rotation / kNozzleTurns, solutions_);
      if (!solutions_.empty()) {
        lastRotation_ = rotation;
        return true;
      }
    }
    return false;
  }

  const Cell& cell_;
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::Matrix3d> turns_;
  std::vector<JointVector> solutions_;
  int lastRotation_ = 0;
};

} // namespace

double reachableBallRadius(const Cell& cell, double tiltRad) {
  base::require(tiltRad >= 0.0 && tiltRad <= kPi, "tilt in 0..pi");
  constexpr double kLargestMm = 2560.0, kToleranceMm = 0.25;
  Pattern pattern(cell, tiltRad);
  double good = 0.0, bad = kLargestMm;
  while (bad - good > kToleranceMm) {
    const double middle = 0.5 * (good + bad);
    (pattern.reached(middle) ? good : bad) = middle;
  }
  return good;
}

bool reachesBall(const Cell& cell, double tiltRad, double radiusMm) {
  base::require(tiltRad >= 0.0 && tiltRad <= kPi, "tilt in 0..pi");
  return Pattern(cell, tiltRad).reached(radiusMm);
}

} // namespace voluta::robot
