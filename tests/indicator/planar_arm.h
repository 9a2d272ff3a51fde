// An arm of three links of length 1 in a plane, whose tip is to follow the line y = 1, and a disc
// in its way: collisions are known in closed form (the setting of Dai 2020, 4.4.3).
#pragma once

#include "base/units.h"
#include "robot/robot_model.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace voluta::test {

struct PlanarArm {
  Eigen::Vector2d disc = {1.0, 0.2};
  double radius = 0.35;

  std::vector<robot::JointLimits> limits() const {
    return std::vector<robot::JointLimits>(3, {-base::kTwoPi, base::kTwoPi, 1.0, 1.0});
  }

  static std::array<Eigen::Vector2d, 4> joints(const robot::JointVector& q) {
    std::array<Eigen::Vector2d, 4> at;
    at[0].setZero();
    double angle = 0.0;
    for (std::size_t j = 0; j < 3; ++j) {
      angle += q[static_cast<Eigen::Index>(j)];
      at[j + 1] = at[j] + Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    return at;
  }

  // Of the arm from the disc; negative where a link meets it.
  double clearance(const robot::JointVector& q) const {
    const auto at = joints(q);
    double minimum = 1e9;
    for (std::size_t j = 0; j < 3; ++j) {
      const Eigen::Vector2d along = at[j + 1] - at[j];
      const double t = std::clamp((disc - at[j]).dot(along), 0.0, 1.0);
      minimum = std::min(minimum, (disc - at[j] - t * along).norm());
    }
    return minimum - radius;
  }
  bool collides(const robot::JointVector& q) const { return clearance(q) < 0.0; }

  // All ways to have the tip at (x, 1) with the last link at `angle` to the x axis: elbow up and
  // down; none where it is out of reach.
  static std::vector<robot::JointVector> inverse(double x, double angle) {
    const Eigen::Vector2d wrist(x - std::cos(angle), 1.0 - std::sin(angle));
    const double bend = 0.5 * wrist.squaredNorm() - 1.0;
    std::vector<robot::JointVector> found;
    if (std::abs(bend) > 1.0)
      return found;
    for (const double elbow : {std::acos(bend), -std::acos(bend)}) {
      const double shoulder = std::atan2(wrist.y(), wrist.x()) - 0.5 * elbow;
      found.push_back(Eigen::Vector3d(shoulder, elbow, angle - shoulder - elbow));
    }
    return found;
  }

  static std::vector<robot::JointVector> onTheLine(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> x(-1.5, 1.5), angle(-base::kPi, base::kPi);
    std::vector<robot::JointVector> all;
    while (all.size() < count)
      for (const robot::JointVector& q : inverse(x(engine), angle(engine)))
        all.push_back(q);
    return all;
  }

  // Newton's steps on the tip's height.
  static std::optional<robot::JointVector> project(robot::JointVector q) {
    for (int step = 0; step < 20; ++step) {
      const auto at = joints(q);
      const double left = 1.0 - at[3].y();
      if (std::abs(left) < 1e-9)
        return q;
      robot::JointVector rate(3);
      for (std::size_t j = 0; j < 3; ++j)
        rate[static_cast<Eigen::Index>(j)] = at[3].x() - at[j].x();
      if (rate.squaredNorm() < 1e-6)
        return std::nullopt;
      q += left / rate.squaredNorm() * rate;
    }
    return std::nullopt;
  }
};

inline std::vector<robot::JointVector> shaken(std::vector<robot::JointVector> all, double maximum,
                                              std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> step(-maximum, maximum);
  for (robot::JointVector& q : all)
    for (double& joint : q)
      joint += step(engine);
  return all;
}

} // namespace voluta::test
