#include "elastic/tension_across.h"

#include "elastic/hexahedron.h"

#include <algorithm>
#include <cmath>

namespace voluta::elastic {

TensionAcross::TensionAcross(const LoadCase& load, const ElasticState& state) {
  for (std::size_t c = 0; c < load.share.size(); ++c)
    if (load.isSolid(c)) {
      stress_.push_back(stressMatrix(state.stress[c]));
      share_.push_back(load.share[c]);
    }
}

double TensionAcross::along(const Eigen::Vector3d& direction) const {
  double sum = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < stress_.size(); ++i) {
    const double tension = std::max(0.0, direction.dot(stress_[i] * direction));
    sum += share_[i] * tension * tension;
    volume += share_[i];
  }
  return volume > 0.0 ? std::sqrt(sum / volume) : 0.0;
}

} // namespace voluta::elastic
