#include "toolpath/infill/sample_tree.h"

#include "base/error.h"
#include "base/index.h"
#include "toolpath/infill/strand_text.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace voluta::toolpath {

using base::at;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {
constexpr std::size_t kLeaf = 16; // samples
constexpr double kFar = 4.0;      // [radii]: from there on samples count together
constexpr double kNearMm = 0.1;   // samples of one place too
} // namespace

SampleTree::SampleTree(std::vector<FieldSample> samples) : samples_(std::move(samples)) {
  base::require(!samples_.empty(), "a tree of samples");
  addNode(0, samples_.size());
}

int SampleTree::addNode(std::size_t first, std::size_t count) {
  const std::span<FieldSample> own = std::span(samples_).subspan(first, count);
  Node node{.first = first, .count = count};
  node.moments.fill(Matrix3d::Zero());
  Eigen::AlignedBox3d box;
  double weight = 0.0;
  for (const FieldSample& sample : own) {
    box.extend(sample.place);
    weight += sample.weight;
    node.middle += sample.weight * sample.place;
  }
  node.middle /= weight;
  for (const FieldSample& sample : own) {
    const Vector3d offset = sample.place - node.middle;
    const Matrix3d dyad = sample.weight * sample.direction * sample.direction.transpose();
    node.radiusMm = std::max(node.radiusMm, offset.norm());
    node.dyads += dyad;
    for (int axis = 0; axis < 3; ++axis)
      node.moments[at(axis)] += offset[axis] * dyad;
  }
  const auto index = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
  if (count > kLeaf) {
    Eigen::Index longest = 0;
    box.sizes().maxCoeff(&longest);
    const std::size_t half = count / 2;
    std::ranges::nth_element(own, own.begin() + static_cast<std::ptrdiff_t>(half), {},
                             [&](const FieldSample& sample) { return sample.place[longest]; });
    const int low = addNode(first, half), high = addNode(first + half, count - half);
    nodes_[at(index)].children[0] = low;
    nodes_[at(index)].children[1] = high;
  }
  return index;
}

Matrix3d SampleTree::dyadsAt(const Vector3d& place) const {
  Matrix3d sum = Matrix3d::Zero();
  std::vector<int> open{0};
  while (!open.empty()) {
    const Node& node = nodes_[at(open.back())];
    open.pop_back();
    const Vector3d away = node.middle - place;
    const double squared = away.squaredNorm();
    const double near = std::max(kNearMm, kFar * node.radiusMm);
    if (squared > near * near) {
      sum += node.dyads / squared;
      for (int axis = 0; axis < 3; ++axis)
        sum -= 2.0 * away[axis] / (squared * squared) * node.moments[at(axis)];
    } else if (node.children[0] < 0) {
      sum += toolpath::dyadsAt(std::span(samples_).subspan(node.first, node.count), place);
    } else {
      open.insert(open.end(), {node.children[1], node.children[0]});
    }
  }
  return sum;
}

} // namespace voluta::toolpath
