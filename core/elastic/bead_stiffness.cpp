#include "elastic/bead_stiffness.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <utility>

namespace voluta::elastic {

namespace {
// Rows and columns of a stress matrix, by index in a Tensor6.
constexpr std::array<std::pair<int, int>, 6> kEntries{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};

// Returns the matrix that turns strains of the world into those along the columns of `axes`.
Stiffness6 strainTurn(const Eigen::Matrix3d& axes) {
  Stiffness6 turn;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const auto [a, b] = kEntries[static_cast<std::size_t>(i)];
      const auto [c, d] = kEntries[static_cast<std::size_t>(j)];
      // Shear strains are angles, twice the entries of the matrix.
      const double both = c == d ? axes(c, a) * axes(c, b)
                                 : 0.5 * (axes(c, a) * axes(d, b) + axes(d, a) * axes(c, b));
      turn(i, j) = (a == b ? 1.0 : 2.0) * both;
    }
  return turn;
}

// Returns axes whose first is along the direction.
Eigen::Matrix3d axesAlong(const Eigen::Vector3d& along) {
  Eigen::Matrix3d axes;
  axes.col(0) = along;
  axes.col(1) = along.unitOrthogonal();
  axes.col(2) = along.cross(axes.col(1));
  return axes;
}
} // namespace

Stiffness6 isotropicStiffness(double modulusMPa, double poisson) {
  return beadStiffness({modulusMPa, modulusMPa, modulusMPa / (2.0 * (1.0 + poisson)), poisson},
                       Eigen::Vector3d::UnitX());
}

Stiffness6 beadStiffness(const process::Elasticity& e, const Eigen::Vector3d& along) {
  Stiffness6 compliance = Stiffness6::Zero();
  compliance(0, 0) = 1.0 / e.alongMPa;
  compliance(1, 1) = compliance(2, 2) = 1.0 / e.acrossMPa;
  compliance(0, 1) = compliance(1, 0) = compliance(0, 2) = compliance(2, 0) =
      -e.poisson / e.alongMPa;
  compliance(1, 2) = compliance(2, 1) = -e.poisson / e.acrossMPa;
  compliance(3, 3) = compliance(5, 5) = 1.0 / e.shearMPa;
  compliance(4, 4) = 2.0 * (1.0 + e.poisson) / e.acrossMPa;
  const Stiffness6 turn = strainTurn(axesAlong(along));
  return turn.transpose() * compliance.inverse() * turn;
}

std::optional<process::Elasticity> tapeElasticity(const process::Process& process,
                                                  const process::Elasticity& matrix) {
  const process::Tape& tape = *process.tape;
  if (tape.fibreMPa <= 0.0 || tape.fibreShare <= 0.0)
    return std::nullopt;
  const double fibre = tape.fibreShare, rest = 1.0 - fibre;
  const double fibreShearMPa = tape.fibreMPa / (2.0 * (1.0 + matrix.poisson));
  return process::Elasticity{.alongMPa = fibre * tape.fibreMPa + rest * matrix.alongMPa,
                             .acrossMPa = 1.0 / (fibre / tape.fibreMPa + rest / matrix.acrossMPa),
                             .shearMPa = 1.0 / (fibre / fibreShearMPa + rest / matrix.shearMPa),
                             .poisson = matrix.poisson};
}

} // namespace voluta::elastic
