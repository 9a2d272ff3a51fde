// Inverse kinematics of any arm of six revolute axes, by Newton steps from a table of poses. Joints
// 1 and 6 rotate the arm about a fixed line, so the table covers joints 2-5: how far out and how
// high a point of axis 6 is, and the direction of axis 6 there. Seeds are the entries nearest to
// the requested pose, no two of them close to each other. Deterministic.
//
// It finds the branches that the seeds lead to: nearly all, not provably all (docs/robots.md gives
// the measured share).
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

  // Appends every branch found, each joint in (-pi, pi], without duplicates.
  void inverse(const Eigen::Isometry3d& base_T_flange, std::vector<JointVector>& solutions) const;

private:
  // Relative to axis 1: distance out and up, and axis 6 in outward, sideways, upward components.
  using Place = Eigen::Matrix<float, 5, 1>;
  struct Entry {
    Place place;
    std::array<float, 4> joints; // Joints 2-5
  };
  Place placeOf(const Eigen::Vector3d& point, const Eigen::Vector3d& axis6) const;
  std::size_t cellOf(int outward, int up) const;
  JointVector seedOf(const Entry& entry, const Eigen::Isometry3d& base_T_flange) const;

  SerialChain chain_;
  Eigen::Isometry3d base_T_first_;   // Axis 1 as z, its point nearest to axis 2 as origin
  Eigen::Vector3d pointOn6_, axis6_; // In the flange's frame
  double reach_ = 0.0;
  std::vector<Entry> entries_;       // Sorted by cell
  std::vector<std::uint32_t> cells_; // Start of each cell's entries
};

} // namespace voluta::robot
