#include "elastic/hexahedron.h"

#include <cmath>

namespace voluta::elastic {

namespace {
using StrainMatrix = Eigen::Matrix<double, 6, 24>;

// Returns the strains at a place in the cube of width 1, coordinates in [-1, 1].
StrainMatrix strainsAt(const Eigen::Vector3d& place) {
  StrainMatrix strains = StrainMatrix::Zero();
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d side((n & 1) != 0 ? 1.0 : -1.0, (n & 2) != 0 ? 1.0 : -1.0,
                               (n & 4) != 0 ? 1.0 : -1.0);
    const Eigen::Vector3d share =
        (Eigen::Vector3d::Ones() + side.cwiseProduct(place)) / 2.0; // of each axis
    const Eigen::Vector3d slope(side.x() * share.y() * share.z(), side.y() * share.x() * share.z(),
                                side.z() * share.x() * share.y());
    const int x = 3 * n, y = x + 1, z = x + 2;
    strains(0, x) = strains(3, y) = strains(5, z) = slope.x();
    strains(1, y) = strains(3, x) = strains(4, z) = slope.y();
    strains(2, z) = strains(4, y) = strains(5, x) = slope.z();
  }
  return strains;
}
} // namespace

CubeMatrix cubeStiffness(const Stiffness6& material, double widthMm) {
  const double gauss = 1.0 / std::sqrt(3.0);
  CubeMatrix stiffness = CubeMatrix::Zero();
  for (int n = 0; n < 8; ++n) {
    const StrainMatrix strains =
        strainsAt({(n & 1) != 0 ? gauss : -gauss, (n & 2) != 0 ? gauss : -gauss,
                   (n & 4) != 0 ? gauss : -gauss});
    stiffness += strains.transpose() * material * strains;
  }
  return widthMm / 8.0 * stiffness;
}

Tensor6 centreStrain(const CubeVector& displacements, double widthMm) {
  static const StrainMatrix kStrains = strainsAt(Eigen::Vector3d::Zero());
  return kStrains * displacements / widthMm;
}

Eigen::Matrix3d stressMatrix(const Tensor6& s) {
  Eigen::Matrix3d matrix;
  matrix << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return matrix;
}

} // namespace voluta::elastic
