// The tension that layers of a part have to bear across their bonds.
#pragma once

#include "elastic/elastic_solve.h"
#include "elastic/load_case.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::elastic {

class TensionAcross {
public:
  TensionAcross(const LoadCase& load, const ElasticState& state);

  // Returns the root mean square, over the part, of the tension along a unit direction; compression
  // counts as none [MPa].
  double along(const Eigen::Vector3d& direction) const;

private:
  std::vector<Eigen::Matrix3d> stress_; // of solid cells
  std::vector<double> share_;           // that the part fills of each
};

} // namespace voluta::elastic
