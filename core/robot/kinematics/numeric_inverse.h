// Inverse of any arm of six turning axes, by Newton's steps from a table of poses. Joints 1 and 6
// turn the arm about a line that stays, so that what is left is a table over joints 2-5: how far
// out and how high a point of axis 6 stands, and how axis 6 points from there. Seeds are the
// entries nearest to what is wanted, no two of them near each other. Deterministic.
//
// It finds what the seeds lead to: nearly all branches, not provably all (docs/robots.md has the
// measured share).
#pragma once

#include "robot/kinematics/serial_chain.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::robot {

class NumericInverse {
public:
  // Precondition: six joints. Takes some tenths of a second.
  explicit NumericInverse(SerialChain chain);

  // Appends every branch found, each joint in (-pi, pi], none twice.
  void inverse(const Eigen::Isometry3d& base_T_flange, std::vector<JointVector>& solutions) const;

private:
  // Seen from axis 1: how far out and up, and axis 6 in outward, sideways, upward parts.
  using Place = Eigen::Matrix<float, 5, 1>;
  struct Entry {
    Place place;
    std::array<float, 4> joints; // 2-5
  };
  Place placeOf(const Eigen::Vector3d& point, const Eigen::Vector3d& axis6) const;
  std::size_t cellOf(int outward, int up) const;
  JointVector seedOf(const Entry& entry, const Eigen::Isometry3d& base_T_flange) const;

  SerialChain chain_;
  Eigen::Isometry3d base_T_first_;   // axis 1 as z, its point nearest to axis 2 as origin
  Eigen::Vector3d pointOn6_, axis6_; // in the flange's frame
  double reach_ = 0.0;
  std::vector<Entry> entries_;       // by cell
  std::vector<std::uint32_t> cells_; // where each cell's entries begin
};

} // namespace voluta::robot
