#include "indicator/contact_space.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/least_turn.h"
#include "robot/nozzle_turns.h"

#include <algorithm>
#include <limits>
#include <random>

namespace voluta::indicator {

using Eigen::Vector3d;
using robot::JointVector;

namespace {
constexpr double kThereMm = 0.05;
constexpr int kSteps = 20;
constexpr std::size_t kTriesASample = 50;
} // namespace

ContactSpace::ContactSpace(const robot::Cell& cell, const plan::ToolPlan& plan, std::size_t first,
                           std::size_t count)
    : cell_(cell), plan_(plan), first_(first), count_(count), twists_(*cell.robot().kinematics) {
  base::require(count > 0 && first + count <= plan.waypointCount(), "waypoints inside the plan");
  base::require(cell.externalAxes().empty(), "a cell without external axes");
}

std::vector<JointVector> ContactSpace::random(std::size_t count, std::uint64_t seed) const {
  std::mt19937_64 engine(seed);
  std::uniform_int_distribution<std::size_t> waypoint(first_, first_ + count_ - 1);
  std::uniform_real_distribution<double> rotation(-base::kPi, base::kPi);
  std::vector<JointVector> samples, solutions;
  for (std::size_t tries = 0; samples.size() < count && tries < kTriesASample * count; ++tries) {
    const std::size_t w = waypoint(engine);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = plan_.position[w];
    pose.linear() =
        geometry::shortestRotation(Vector3d::UnitZ(), -plan_.direction[w]).toRotationMatrix();
    robot::NozzleTurns(cell_, pose, cell_.home()).at(rotation(engine), solutions);
    samples.insert(samples.end(), solutions.begin(), solutions.end());
  }
  return samples;
}

Vector3d ContactSpace::missing(const Vector3d& tip) const {
  std::size_t nearest = first_;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t w = first_; w < first_ + count_; ++w)
    if (const double d = (plan_.position[w] - tip).squaredNorm(); d < minimum) {
      minimum = d;
      nearest = w;
    }
  const Vector3d& n = plan_.direction[nearest];
  const Vector3d from = tip - plan_.position[nearest];
  const Vector3d along = from - from.dot(n) * n;
  const double length = along.norm(), reach = static_cast<double>(plan_.widthMm[nearest]);
  return (length > reach ? reach / length : 1.0) * along - from;
}

double ContactSpace::distanceMm(const JointVector& q) const {
  return missing(cell_.work_T_tool(q).translation()).norm();
}

std::optional<JointVector> ContactSpace::project(const JointVector& from) const {
  const auto& limits = cell_.robot().limits;
  const bool movesNozzle = cell_.nozzleMount() == robot::Mount::Flange;
  std::vector<Eigen::Isometry3d> links;
  JointVector q = from;
  for (int step = 0; step <= kSteps; ++step) {
    const Vector3d left = missing(cell_.work_T_tool(q).translation());
    const double distance = left.norm();
    if (distance <= kThereMm)
      return q;
    // Compute the tip's speed towards the surface per joint. If the arm moves the surface below a
    // fixed nozzle, the sign is reversed.
    Eigen::Isometry3d base_T_flange;
    const robot::ArmJacobian jacobian = twists_.jacobian(q, base_T_flange, links);
    const Eigen::Isometry3d base_T_work = cell_.base_T_work(q);
    const Vector3d wanted = (movesNozzle ? 1.0 : -1.0) * (base_T_work.linear() * left) / distance;
    const Vector3d tip = base_T_work * cell_.work_T_tool(q).translation();
    const Vector3d lever = tip - base_T_flange.translation();
    JointVector rate = JointVector::Zero(q.size()); // mm per rad
    for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
      const Vector3d velocity = jacobian.col(j).head<3>(), rotation = jacobian.col(j).tail<3>();
      rate[j] = robot::fromAngle(limits[static_cast<std::size_t>(j)].kind,
                                 wanted.dot(velocity + rotation.cross(lever)));
    }
    const double all = rate.squaredNorm();
    // The arm cannot approach: a whole radian would move the tip by less than a millimetre
    if (all < 1.0)
      return std::nullopt;
    for (Eigen::Index j = 0; j < rate.size(); ++j)
      q[j] += robot::fromAngle(limits[static_cast<std::size_t>(j)].kind, distance * rate[j] / all);
  }
  return std::nullopt;
}

} // namespace voluta::indicator
