#include "elastic/principal_stress.h"

#include "geometry/symmetric_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::elastic {

namespace {
constexpr double kOfCompression = 0.95;

constexpr std::array<std::array<int, 3>, 6> kSides{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
} // namespace

Eigen::Matrix3d principalDyads(const Eigen::Matrix3d& stress) {
  const auto [values, axes] = geometry::symmetricAxes(stress);
  Eigen::Matrix3d dyads = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    dyads += (values[i] > 0.0 ? values[i] : -kOfCompression * values[i]) * axes.col(i) *
             axes.col(i).transpose();
  return dyads;
}

PrincipalStress::PrincipalStress(const LoadCase& load, const ElasticState& state)
    : grid_(load.grid), dyads_(load.share.size(), Eigen::Matrix3f::Zero()) {
  // Cells outside the part take the dyads of those beside them, ring by ring.
  std::vector<std::size_t> ring;
  std::vector<char> isKnown(load.share.size(), 0);
  for (std::size_t c = 0; c < load.share.size(); ++c)
    if (load.isSolid(c)) {
      dyads_[c] = principalDyads(stressMatrix(state.stress[c])).cast<float>();
      isKnown[c] = 1;
      ring.push_back(c);
    }
  while (!ring.empty()) {
    std::vector<std::size_t> next;
    for (const std::size_t c : ring) {
      const Eigen::Vector3i cell = grid_.cell(c);
      for (const auto& [i, j, k] : kSides) {
        const Eigen::Vector3i beside = cell + Eigen::Vector3i(i, j, k);
        if (!grid_.contains(beside.x(), beside.y(), beside.z()))
          continue;
        const std::size_t index = grid_.index(beside.x(), beside.y(), beside.z());
        if (isKnown[index])
          continue;
        isKnown[index] = 1;
        dyads_[index] = dyads_[c];
        next.push_back(index);
      }
    }
    ring = std::move(next);
  }
}

Eigen::Matrix3d PrincipalStress::ofCell(const Eigen::Vector3i& cell) const {
  const Eigen::Vector3i within = cell.cwiseMax(0).cwiseMin(grid_.size - Eigen::Vector3i::Ones());
  return dyads_[grid_.index(within.x(), within.y(), within.z())].cast<double>();
}

Eigen::Matrix3d PrincipalStress::dyadsAt(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d at = ((place - grid_.origin) / grid_.pitch).array() - 0.5;
  const Eigen::Vector3i low = at.array().floor().matrix().cast<int>();
  const Eigen::Vector3d beyond = at - low.cast<double>();
  Eigen::Matrix3d dyads = Eigen::Matrix3d::Zero();
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3i corner(n & 1, n >> 1 & 1, n >> 2);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
      weight *= corner[axis] != 0 ? beyond[axis] : 1.0 - beyond[axis];
    dyads += weight * ofCell(low + corner);
  }
  return dyads;
}

} // namespace voluta::elastic
