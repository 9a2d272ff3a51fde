// A cube as a finite element with eight nodes and linear functions (Zienkiewicz, Taylor 2000).
#pragma once

#include <Eigen/Core>

namespace voluta::elastic {

// Stresses and strains are vectors xx, yy, zz, xy, yz, zx; strains of shear are the angles.
using Tensor6 = Eigen::Matrix<double, 6, 1>;
using Stiffness6 = Eigen::Matrix<double, 6, 6>;
// Displacements of the nodes x, y, z, one node after the other: node n is at (n & 1, n >> 1 & 1,
// n >> 2) of the cube's lowest corner [widths].
using CubeVector = Eigen::Matrix<double, 24, 1>;
using CubeMatrix = Eigen::Matrix<double, 24, 24>;

// Returns the stiffness of a cube of that width. Lengths in mm, moduli in MPa: N/mm.
CubeMatrix cubeStiffness(const Stiffness6& material, double widthMm);

// Returns the strain at the centre of a cube.
Tensor6 centreStrain(const CubeVector& displacements, double widthMm);

// Returns the symmetric matrix of a stress.
Eigen::Matrix3d stressMatrix(const Tensor6& stress);

} // namespace voluta::elastic
