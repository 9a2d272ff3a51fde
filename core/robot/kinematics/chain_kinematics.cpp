#include "robot/kinematics/chain_kinematics.h"

#include "robot/angles.h"

#include <algorithm>

namespace voluta::robot {

namespace {
constexpr double kSameMm = 1e-6, kSameRad = 1e-9;
constexpr int kSteps = 8;
} // namespace

ChainKinematics::ChainKinematics(SerialChain chain)
    : chain_(std::move(chain)), arm_(recognisedArm(chain_)) {}

void ChainKinematics::linkPoses(const JointVector& q,
                                std::vector<Eigen::Isometry3d>& base_T_link) const {
  chainPoses(chain_, q, base_T_link);
}

Eigen::Isometry3d ChainKinematics::flange(const JointVector& q) const {
  return chainFlange(chain_, q);
}

void ChainKinematics::inverse(const Eigen::Isometry3d& base_T_flange,
                              std::vector<JointVector>& solutions) const {
  // Descriptions round right angles, which a solver treats as exact; Newton steps on the chain
  // correct the result.
  constexpr double kExactMm = 1e-9, kExactRad = 1e-12;
  const std::size_t before = solutions.size();
  arm_.inverse(base_T_flange, solutions);
  const auto missed = [&](JointVector& q) {
    PoseError error = poseError(chainFlange(chain_, q), base_T_flange);
    if (error.mm > kExactMm || error.rad > kExactRad) {
      error = settle(chain_, base_T_flange, kSteps, q);
      for (int i = 0; i < 6; ++i)
        q[i] = wrappedAngle(q[i]);
    }
    return error.mm > kSameMm || error.rad > kSameRad;
  };
  solutions.erase(std::remove_if(solutions.begin() + static_cast<std::ptrdiff_t>(before),
                                 solutions.end(), missed),
                  solutions.end());
}

bool ChainKinematics::solveNear(const Eigen::Isometry3d& base_T_flange, JointVector& q) const {
  JointVector next = q;
  const PoseError error = settle(chain_, base_T_flange, kSteps, next);
  if (error.mm > kSameMm || error.rad > kSameRad)
    return false;
  q = next;
  return true;
}

} // namespace voluta::robot
