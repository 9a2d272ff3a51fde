// Sums the directions of many samples quickly.
#pragma once

#include "toolpath/fibre/tape_curves.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace voluta::toolpath {

// A tree of samples for sums over all of them (Barnes and Hut 1986). Samples that are seen under a
// small angle count together, as one at their weighted middle, with the linear change around it.
class SampleTree {
public:
  // Precondition: at least one sample.
  explicit SampleTree(std::vector<FieldSample> samples);

  // Returns dyadsAt() of all samples, within 3 % of its norm.
  Eigen::Matrix3d dyadsAt(const Eigen::Vector3d& place) const;

private:
  struct Node {
    std::size_t first = 0, count = 0; // of the samples
    int children[2] = {-1, -1};       // -1: none
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double radiusMm = 0.0; // around the middle
    Eigen::Matrix3d dyads = Eigen::Matrix3d::Zero();
    std::array<Eigen::Matrix3d, 3> moments{}; // of the dyads about the middle, per axis
  };

  int addNode(std::size_t first, std::size_t count);

  std::vector<FieldSample> samples_;
  std::vector<Node> nodes_;
};

} // namespace voluta::toolpath
