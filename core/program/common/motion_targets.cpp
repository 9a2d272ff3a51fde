#include "program/common/motion_targets.h"

#include "plan/waypoints.h"

#include "base/error.h"
#include "base/parallel.h"
#include "process/bead_model.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <cmath>

namespace voluta::program {

namespace {
const char* nameOf(plan::PathKind kind) {
  switch (kind) {
  case plan::PathKind::Wall:
    return "wall";
  case plan::PathKind::Infill:
    return "infill";
  case plan::PathKind::GapFill:
    return "gap fill";
  case plan::PathKind::Skirt:
    return "skirt";
  case plan::PathKind::Support:
    return "support";
  case plan::PathKind::Prime:
    return "prime";
  case plan::PathKind::SparseInfill:
    return "sparse infill";
  case plan::PathKind::Bridge:
    return "bridge";
  case plan::PathKind::Tape:
    return "tape";
  case plan::PathKind::Shot:
    return "shot";
  }
  return "path";
}
} // namespace

void checkInput(const ProgramInput& input) {
  const plan::Trajectory& t = input.trajectory;
  const std::size_t n = t.pointCount();
  base::require(t.dof == input.cell.dof() && t.dof > 0, "trajectory and cell differ in axes");
  base::require(n > 0, "a program needs at least one trajectory point");
  base::require(t.joints.size() == n * static_cast<std::size_t>(t.dof) && t.move.size() == n &&
                    t.waypoint.size() == n && t.extrudedMm3.size() == n,
                "the trajectory's arrays differ in length");
}

MotionTarget targetOf(const robot::Cell& cell, const robot::JointVector& q) {
  const Eigen::Isometry3d flange = cell.robot().kinematics->flange(q);
  const Eigen::Isometry3d tcp = flange * cell.flange_T_moved();
  const Eigen::Isometry3d tool = cell.work_T_toolOfFlange(flange, q);
  return {Eigen::Quaterniond(tcp.linear()), tcp.translation(), tool.translation(),
          -tool.linear().col(2)};
}

std::vector<MotionTarget> motionTargets(const ProgramInput& input, const base::RunContext& ctx) {
  checkInput(input);
  const plan::Trajectory& t = input.trajectory;
  const robot::Cell& cell = input.cell;
  std::vector<MotionTarget> targets(t.pointCount());
  base::parallelChunks(ctx, targets.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      targets[i] = targetOf(cell, Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof));
    }
  });
  return targets;
}

void placeInWorkFrame(const ProgramInput& input, int decimals, std::vector<MotionTarget>& targets) {
  const plan::Trajectory& t = input.trajectory;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const Eigen::Isometry3d pose =
        input.cell.work_T_tool(Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof));
    targets[i].tcpRotation = Eigen::Quaterniond(pose.linear());
    for (int k = 0; k < 3; ++k)
      targets[i].tcpMm[k] = roundedTo(pose.translation()[k], decimals);
  }
}

double motionSeconds(const plan::Trajectory& trajectory, std::size_t point) {
  return point == 0 ? 0.0 : trajectory.timeS[point] - trajectory.timeS[point - 1];
}

double leadingJointRad(const ProgramInput& input, std::size_t point) {
  const plan::Trajectory& t = input.trajectory;
  if (point == 0)
    return 0.0;
  const Eigen::Map<const Eigen::VectorXd> from(t.at(point - 1), t.dof), to(t.at(point), t.dof);
  return robot::largestRotation(to - from, input.cell.limits());
}

double rampedSpeed(double rad, double seconds, double radPerS2) {
  // twice the maximum speed of a motion without a constant-speed phase
  const double maximum = radPerS2 * seconds;
  const double spare = maximum * maximum - 4.0 * radPerS2 * rad;
  return spare >= 0.0 ? 0.5 * (maximum - std::sqrt(spare))
                      : std::min(std::sqrt(radPerS2 * rad), 2.0 * rad / seconds);
}

double motionVolumeMm3(const plan::Trajectory& trajectory, std::size_t point) {
  return point == 0 ? 0.0 : trajectory.extrudedMm3[point] - trajectory.extrudedMm3[point - 1];
}

bool isPrint(const plan::Trajectory& trajectory, std::size_t point) {
  return point > 0 && trajectory.move[point] == plan::MoveKind::Print;
}

bool standsClear(const plan::Trajectory& trajectory, std::size_t point) {
  return point > 0 && !isPrint(trajectory, point) && !isPrint(trajectory, point - 1) &&
         trajectory.move[point - 1] != plan::MoveKind::Wipe;
}

bool primesStanding(const ProgramInput& input) {
  return input.process().primeS > 0.0 && plan::primesAtStart(input.toolPlan, input.trajectory);
}

std::string PathNames::at(std::size_t waypoint) {
  const auto& paths = toolPlan_.paths;
  if (waypoint == plan::kNoWaypoint)
    return {};
  while (path_ < paths.size() && paths[path_].first < waypoint)
    ++path_;
  if (path_ == paths.size() || paths[path_].first != waypoint)
    return {};
  return joined({"layer ", std::to_string(paths[path_].layer + 1), ", ", nameOf(paths[path_].kind),
                 ", path ", std::to_string(path_ + 1)});
}

} // namespace voluta::program
