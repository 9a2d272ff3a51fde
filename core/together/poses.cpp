#include "together/poses.h"

#include "collision/cell_collision.h"
#include "collision/shape_distance.h"
#include "plan/trajectory.h"
#include "robot/body.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include <algorithm>
#include <cmath>

namespace voluta::together {

using Eigen::Isometry3d;
using robot::JointVector;

namespace {
JointVector jointsAt(const plan::Trajectory& t, std::size_t point) {
  return Eigen::Map<const Eigen::VectorXd>(t.at(point), t.dof);
}

Frames framesOf(const PlacedMotion& machine, const JointVector& q) {
  Frames frames;
  machine.cell->framePoses(q, frames);
  const Isometry3d shared_T_base =
      machine.shared_T_world * machine.cell->base_T_world(q).inverse(Eigen::Isometry);
  for (Isometry3d& frame : frames)
    frame = shared_T_base * frame;
  return frames;
}

double largestDisplacement(const PlacedMotion& machine, const std::vector<collision::Ball>& balls,
                           const Frames& from, const Frames& to) {
  double maximum = 0.0;
  const auto& bodies = machine.cell->bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto frame = static_cast<std::size_t>(bodies[b].frame);
    maximum = std::max(maximum, displacementOf(balls[b], from[frame], to[frame]));
  }
  return maximum;
}
} // namespace

double displacementOf(const collision::Ball& ball, const Isometry3d& from, const Isometry3d& to) {
  const double chord = (from.linear() - to.linear()).norm() / std::sqrt(2.0); // 2 sin(angle / 2)
  const double angle = 2.0 * std::asin(std::min(1.0, 0.5 * chord));
  return (from * ball.centre - to * ball.centre).norm() + angle * ball.radius;
}

Frames framesAt(const PlacedMotion& machine, std::size_t point) {
  return framesOf(machine, jointsAt(*machine.trajectory, point));
}

void visitPoses(const PlacedMotion& machine, std::size_t first, std::size_t last, double stepMm,
                const std::function<void(const Frames&)>& visit) {
  std::vector<collision::Ball> balls;
  for (std::size_t b = 0; b < machine.cell->bodies().size(); ++b)
    balls.push_back(machine.collision->ballAbout(static_cast<int>(b)));
  JointVector q = jointsAt(*machine.trajectory, first);
  Frames frames = framesOf(machine, q);
  visit(frames);
  for (std::size_t point = first + 1; point <= last; ++point) {
    const JointVector to = jointsAt(*machine.trajectory, point);
    Frames end = framesOf(machine, to);
    const int pieces = std::max(
        1, static_cast<int>(std::ceil(largestDisplacement(machine, balls, frames, end) / stepMm)));
    for (int k = 1; k < pieces; ++k)
      visit(framesOf(machine, q + static_cast<double>(k) / pieces * (to - q)));
    visit(end);
    q = to;
    frames = std::move(end);
  }
}

bool isMoved(const robot::Cell& cell, const robot::Body& body) {
  if (body.frame == cell.worldFrame())
    return false;
  if (body.frame == 0)
    return cell.axesUnderRobot() > 0;
  if (body.frame == cell.workFrame())
    return isPartMoved(cell);
  return body.frame != cell.toolFrame() || cell.nozzleMount() == robot::Mount::Flange;
}

bool isPartMoved(const robot::Cell& cell) {
  return cell.nozzleMount() == robot::Mount::World || cell.axesMovePlatform();
}

} // namespace voluta::together
