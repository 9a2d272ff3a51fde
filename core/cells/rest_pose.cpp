#include "cells/rest_pose.h"

#include "base/units.h"
#include "cells/cell_score.h"
#include "collision/cell_collision.h"
#include "geometry/singular_values.h"
#include "robot/leaning_tool.h"
#include "robot/nozzle_turns.h"

#include <algorithm>
#include <cmath>

namespace voluta::cells {

namespace {

using robot::JointVector;

constexpr int kTurns = 16;
constexpr double kHeightMm = 180.0, kStepMm = 5.0;
constexpr double kFromLimitsRad = 10.0 * base::kPi / 180.0;
constexpr double kFromSingular = 0.06;

double fromSingular(const robot::Cell& cell, const JointVector& q, double reachMm) {
  constexpr double kStep = 1e-5;
  const robot::Kinematics& arm = *cell.robot().kinematics;
  const Eigen::Isometry3d at = arm.flange(q);
  Eigen::Matrix<double, 6, Eigen::Dynamic> moves(6, cell.armDof());
  for (int i = 0; i < cell.armDof(); ++i) {
    const double step = robot::fromAngle(arm.kindOf(i), kStep);
    JointVector next = q;
    next[i] += step;
    const Eigen::Isometry3d moved = arm.flange(next);
    const Eigen::Matrix3d rotation = moved.linear() * at.linear().transpose();
    moves.col(i) << (moved.translation() - at.translation()) / (reachMm * kStep),
        Eigen::Vector3d(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                        rotation(1, 0) - rotation(0, 1)) /
            (2.0 * kStep);
  }
  return geometry::singularValues(Eigen::MatrixXd(moves)).minCoeff();
}

double fromLimits(const robot::Cell& cell, const JointVector& q) {
  double minimum = base::kPi;
  for (int i = 0; i < cell.armDof(); ++i) {
    const robot::JointLimits& limit = cell.limits()[static_cast<std::size_t>(i)];
    minimum =
        std::min(minimum, robot::asAngle(limit.kind, std::min(q[i] - limit.min, limit.max - q[i])));
  }
  return minimum;
}

JointVector onTenths(const robot::Cell& cell, JointVector q) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const robot::JointLimits& limit = cell.limits()[static_cast<std::size_t>(i)];
    const double shown = 0.1 * std::round(10.0 * robot::shownValue(limit.kind, q[i]));
    const double rounded = robot::ofShownValue(limit.kind, shown);
    if (rounded >= limit.min && rounded <= limit.max)
      q[i] = rounded;
  }
  return q;
}

} // namespace

std::optional<RestPose> restPose(const robot::Cell& cell, const process::Process& process,
                                 double reachMm) {
  const collision::CellCollision bodies(cell, process);
  const JointVector zero = JointVector::Zero(cell.dof());
  // An arm that cannot tilt is singular only when stretched.
  const double enough = cell.tilts() ? kFromSingular : 0.0;
  std::vector<JointVector> solutions;
  std::vector<Eigen::Isometry3d> frames;
  std::optional<RestPose> best;
  double bestWorth = -1.0, bestTurns = 0.0;
  for (double height = kHeightMm; height > 0.0 && bestWorth <= 0.0; height -= kStepMm) {
    const robot::NozzleTurns turns(cell, robot::leaningTool({0, 0, height}, 0.0, 0.0), zero);
    for (int rotation = 0; rotation < kTurns; ++rotation) {
      turns.at(base::kTwoPi * rotation / kTurns, solutions);
      for (const JointVector& exact : solutions) {
        RestPose rest{onTenths(cell, exact), 0.0, height, 0.0};
        cell.framePoses(rest.q, frames);
        rest.clearMm = bodies.clearance(frames, kRestClearMm);
        if (bodies.bodies(frames, {kClearMm, kClearMm, 0.0}))
          rest.clearMm = std::min(rest.clearMm, 0.0);
        rest.fromSingular = fromSingular(cell, rest.q, reachMm);
        const auto share = [](double is, double wanted) {
          return wanted > 0.0 ? std::clamp(is / wanted, 0.0, 1.0) : 1.0;
        };
        const double worth = share(rest.clearMm, kRestClearMm) *
                             (0.1 + 0.9 * share(fromLimits(cell, rest.q), kFromLimitsRad)) *
                             (0.1 + 0.9 * share(rest.fromSingular, enough));
        const double turned =
            robot::asAngles(rest.q, cell.limits()).norm() + 3.0 * std::abs(rest.q[0]);
        constexpr double kSame = 1e-6;
        if (worth > bestWorth + kSame || (worth > bestWorth - kSame && turned < bestTurns)) {
          bestWorth = worth;
          bestTurns = turned;
          best = std::move(rest);
        }
      }
    }
  }
  return best;
}

} // namespace voluta::cells
