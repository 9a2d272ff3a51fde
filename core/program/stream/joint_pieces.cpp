#include "program/stream/joint_pieces.h"

#include "base/units.h"
#include "geometry/directions.h"

namespace voluta::program {

namespace {

constexpr int kMaxPieces = 128;
constexpr double kOffMm = 0.2, kOffDeg = 0.5;

bool isStraight(const ProgramInput& input, std::size_t point, double from, double to) {
  const MotionTarget a = jointPiece(input, point, from), b = jointPiece(input, point, to),
                     middle = jointPiece(input, point, 0.5 * (from + to));
  const Eigen::Vector3d step = b.tipMm - a.tipMm;
  const double squared = step.squaredNorm();
  const double along = squared > 0.0 ? (middle.tipMm - a.tipMm).dot(step) / squared : 0.0;
  return (a.tipMm + along * step - middle.tipMm).norm() <= kOffMm &&
         geometry::angleBetween(a.direction + b.direction, middle.direction) <=
             base::degreesToRadians(kOffDeg);
}

} // namespace

int jointPieces(const ProgramInput& input, std::size_t point) {
  int pieces = 1;
  while (pieces < kMaxPieces) {
    int straight = 0;
    while (straight < pieces && isStraight(input, point, static_cast<double>(straight) / pieces,
                                           static_cast<double>(straight + 1) / pieces))
      ++straight;
    if (straight == pieces)
      break;
    pieces *= 2;
  }
  return pieces;
}

MotionTarget jointPiece(const ProgramInput& input, std::size_t point, double t) {
  const plan::Trajectory& trajectory = input.trajectory;
  const Eigen::Map<const Eigen::VectorXd> from(trajectory.at(point - 1), trajectory.dof),
      to(trajectory.at(point), trajectory.dof);
  return targetOf(input.cell, from + t * (to - from));
}

} // namespace voluta::program
