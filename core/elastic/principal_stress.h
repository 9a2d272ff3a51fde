// The directions of the strongest stress in a part.
#pragma once

#include "elastic/elastic_solve.h"
#include "elastic/load_case.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::elastic {

// Returns the sum of the dyads of a stress's principal directions, each times the size of its
// stress; of compression a little less, so that of two equal ones the tension counts.
Eigen::Matrix3d principalDyads(const Eigen::Matrix3d& stress);

class PrincipalStress {
public:
  PrincipalStress(const LoadCase& load, const ElasticState& state);

  // Returns the dyads at a place, linear between the centres of cells; beyond them as in the
  // nearest cell of the part.
  Eigen::Matrix3d dyadsAt(const Eigen::Vector3d& place) const;

private:
  Eigen::Matrix3d ofCell(const Eigen::Vector3i& cell) const;

  voxel::VoxelGrid grid_;
  std::vector<Eigen::Matrix3f> dyads_; // per cell
};

} // namespace voluta::elastic
