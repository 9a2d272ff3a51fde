#include "program/common/straight_pieces.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

namespace voluta::program {

namespace {

using Eigen::Isometry3d, Eigen::Quaterniond, Eigen::Vector3d;

constexpr int kMaxPieces = 256;
constexpr double kNextRad = 0.2; // a larger distance between pieces means another IK branch

class StraightMotion {
public:
  StraightMotion(const robot::Cell& cell, const robot::JointVector& a, const robot::JointVector& b)
      : cell_(cell), a_(a), b_(b), from_(cell.work_T_tool(a)), to_(cell.work_T_tool(b)) {}

  std::vector<robot::JointVector> inPieces(double maxMm) {
    for (int pieces = 1; pieces <= kMaxPieces; pieces *= 2) {
      std::vector<robot::JointVector> path;
      // With few pieces a long way is as far from one to the next as another IK branch would be.
      bool leads = true;
      for (int k = 1; k < pieces && leads; ++k) {
        const auto q = at(static_cast<double>(k) / pieces, path.empty() ? a_ : path.back());
        leads = q.has_value();
        if (leads)
          path.push_back(*q);
      }
      if (leads && isNear(path, maxMm))
        return path;
    }
    return {};
  }

private:
  std::optional<robot::JointVector> at(double share, const robot::JointVector& before) {
    Isometry3d pose(Quaterniond(from_.linear()).slerp(share, Quaterniond(to_.linear())));
    pose.pretranslate(
        Vector3d(from_.translation() + share * (to_.translation() - from_.translation())));
    cell_.inverse(pose, before, solutions_);
    const robot::JointVector* best = nullptr;
    double minimum = kNextRad;
    for (const robot::JointVector& q : solutions_)
      if (const double away = (q - before).cwiseAbs().maxCoeff(); away < minimum) {
        minimum = away;
        best = &q;
      }
    return best ? std::optional(*best) : std::nullopt;
  }

  bool isNear(const std::vector<robot::JointVector>& path, double maxMm) const {
    const Vector3d line = to_.translation() - from_.translation();
    const auto off = [&](const robot::JointVector& q) {
      const Vector3d p = cell_.work_T_tool(q).translation() - from_.translation();
      return geometry::distanceToSegment(p, Vector3d::Zero(), line);
    };
    for (std::size_t k = 0; k <= path.size(); ++k) {
      const robot::JointVector &p = k == 0 ? a_ : path[k - 1], &q = k == path.size() ? b_ : path[k];
      for (const double share : {0.25, 0.5, 0.75})
        if (off(p + share * (q - p)) > maxMm)
          return false;
    }
    return true;
  }

  const robot::Cell& cell_;
  const robot::JointVector &a_, &b_;
  Isometry3d from_, to_;
  std::vector<robot::JointVector> solutions_;
};

} // namespace

std::vector<robot::JointVector> straightPieces(const ProgramInput& input, std::size_t point,
                                               double maxMm) {
  const plan::Trajectory& t = input.trajectory;
  const robot::JointVector a = Eigen::Map<const Eigen::VectorXd>(t.at(point - 1), t.dof),
                           b = Eigen::Map<const Eigen::VectorXd>(t.at(point), t.dof);
  return StraightMotion(input.cell, a, b).inPieces(maxMm);
}

} // namespace voluta::program
