// Displacements and stresses against closed forms.
#include "base/error.h"
#include "elastic/bead_stiffness.h"
#include "elastic/elastic_solve.h"
#include "elastic/principal_stress.h"

#include "helpers/made_solids.h"
#include "helpers/shapes.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::elastic {
namespace {

using Eigen::Vector3d;
using test::operator+;

// Held up to x = 2, pushed along its last 2 mm.
LoadCase heldBar(const Vector3d& size, const Vector3d& newton, std::size_t cells) {
  const std::array holds{test::box({-1, -1, -1}, {2, size.y() + 1, size.z() + 1})};
  const std::array forces{BodyForce{
      test::box({size.x() - 2, -1, -1}, {size.x() + 1, size.y() + 1, size.z() + 1}), newton}};
  return loadCase(test::box({0, 0, 0}, size), holds, forces, cells, {});
}

double stiffnessOf(const LoadCase& load, double modulusMPa, double poisson) {
  const Stiffness6 material = isotropicStiffness(modulusMPa, poisson);
  const double newton = load.forces.front().newton.norm();
  return newton * newton / solved(load, [&](std::size_t) { return material; }, {}).workNmm;
}

TEST(Cube, CarriesEvenStrainsExactly) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const Stiffness6 material = isotropicStiffness(1500.0, 0.35);
  for (int i = 0; i < 50; ++i) {
    Eigen::Matrix3d slope;
    for (double& entry : slope.reshaped())
      entry = any(random);
    const double width = 0.5 + std::abs(any(random));
    CubeVector moves;
    for (int n = 0; n < 8; ++n)
      moves.segment<3>(3 * n) = slope * width * Vector3d(n & 1, n >> 1 & 1, n >> 2);
    const Tensor6 strain = centreStrain(moves, width);
    EXPECT_NEAR(strain[0], slope(0, 0), 1e-12);
    EXPECT_NEAR(strain[3], slope(0, 1) + slope(1, 0), 1e-12);
    EXPECT_NEAR(strain[4], slope(1, 2) + slope(2, 1), 1e-12);
    // Energy of the cube: that of its strain in its volume.
    const double energy = 0.5 * moves.dot(cubeStiffness(material, width) * moves);
    EXPECT_NEAR(energy, 0.5 * strain.dot(material * strain) * std::pow(width, 3), 1e-9 * energy);
  }
}

TEST(Cube, ResistsNoRigidMotion) {
  const CubeMatrix stiffness = cubeStiffness(isotropicStiffness(1500.0, 0.35), 2.0);
  CubeVector turn;
  for (int n = 0; n < 8; ++n)
    turn.segment<3>(3 * n) =
        Vector3d(0.3, -0.2, 0.5) + Vector3d(1, 2, 3).cross(Vector3d(n & 1, n >> 1 & 1, n >> 2));
  EXPECT_LT((stiffness * turn).norm(), 1e-9 * stiffness.norm());
}

TEST(ElasticSolve, StretchesABarByItsModulus) {
  const LoadCase load = heldBar({40, 8, 8}, {50, 0, 0}, 2560);
  // The force grows evenly over the last 2 mm: their work is that of a third of them.
  EXPECT_NEAR(stiffnessOf(load, 2000.0, 0.0), 2000.0 * 64.0 / (36.0 + 2.0 / 3.0), 0.005 * 3490.0);
}

TEST(ElasticSolve, BendsACantilever) {
  for (const Vector3d& newton : {Vector3d(0, -5, 0), Vector3d(0, 0, 5)}) {
    const LoadCase load = heldBar({80, 10, 10}, newton, 8000);
    constexpr double kE = 2000.0, kL = 77.0, kI = 10000.0 / 12.0, kG = kE / 2.0;
    const double closed = 1.0 / (std::pow(kL, 3) / (3.0 * kE * kI) + 1.2 * kL / (kG * 100.0));
    EXPECT_NEAR(stiffnessOf(load, kE, 0.0), closed, 0.04 * closed);
  }
}

TEST(ElasticSolve, FindsTheStressOfBending) {
  const LoadCase load = heldBar({80, 10, 10}, {0, -5, 0}, 8000);
  const Stiffness6 material = isotropicStiffness(2000.0, 0.3);
  const ElasticState state = solved(load, [&](std::size_t) { return material; }, {});
  // In the middle, away from both ends: M y / I.
  for (std::size_t c = 0; c < load.share.size(); ++c) {
    const Eigen::Vector3i cell = load.grid.cell(c);
    const Vector3d at = load.grid.centre(cell.x(), cell.y(), cell.z());
    if (!load.isSolid(c) || std::abs(at.x() - 40.0) > 10.0 || std::abs(at.y() - 5.0) < 2.0)
      continue;
    const double closed = 5.0 * (79.0 - at.x()) * (at.y() - 5.0) / (10000.0 / 12.0);
    EXPECT_NEAR(state.stress[c][0], closed, 0.05 * std::abs(closed) + 0.02);
  }
}

TEST(PrincipalStress, IsAlongABentBarAndDiagonalInShear) {
  const LoadCase load = heldBar({80, 10, 10}, {0, -5, 0}, 8000);
  const Stiffness6 material = isotropicStiffness(2000.0, 0.3);
  const PrincipalStress principal(load, solved(load, [&](std::size_t) { return material; }, {}));
  for (const double y : {1.0, 9.0}) {
    const Eigen::Matrix3d dyads = principal.dyadsAt({40, y, 5});
    EXPECT_GT(dyads(0, 0), 0.95 * dyads.trace());
  }
  Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
  shear(0, 1) = shear(1, 0) = 2.0;
  const Eigen::Matrix3d dyads = principalDyads(shear);
  EXPECT_GT(dyads(0, 1), 0.0) << "of two equal stresses the tension counts";
  EXPECT_NEAR(dyads(0, 0), dyads(1, 1), 1e-12);
}

TEST(LoadCase, RefusesForcesThatNothingCarries) {
  const geometry::TriangleMesh part = test::box({0, 0, 0}, {20, 10, 10});
  const geometry::TriangleMesh away = test::box({50, 0, 0}, {60, 10, 10});
  const std::array hold{test::box({-1, -1, -1}, {2, 11, 11})};
  EXPECT_THROW(loadCase(part, std::array{away}, std::array{BodyForce{part, {1, 0, 0}}}, 1000, {}),
               base::Error);
  EXPECT_THROW(loadCase(part, hold, std::array{BodyForce{away, {1, 0, 0}}}, 1000, {}), base::Error);
  EXPECT_NO_THROW(loadCase(part, hold, std::array{BodyForce{part, {1, 0, 0}}}, 1000, {}));
}

TEST(ElasticSolve, RefusesForcesOnHeldCellsAlone) {
  const geometry::TriangleMesh part = test::box({0, 0, 0}, {20, 10, 10});
  const std::array hold{test::box({-1, -1, -1}, {6, 11, 11})};
  const std::array force{BodyForce{test::box({-1, -1, -1}, {3, 11, 11}), {1, 0, 0}}};
  const LoadCase load = loadCase(part, hold, force, 1000, {});
  const Stiffness6 any = isotropicStiffness(1000.0, 0.3);
  EXPECT_THROW(solved(load, [&](std::size_t) { return any; }, {}), base::Error);
}

TEST(LoadCase, KeepsAFrameOfThinRodsWithinReason) {
  geometry::TriangleMesh frame = test::box({0, 0, 0}, {300, 3, 3});
  for (const auto& rod : {test::box({0, 0, 0}, {3, 300, 3}), test::box({0, 0, 0}, {3, 3, 300})})
    frame = frame + rod;
  const std::array hold{test::box({-1, -1, -1}, {20, 20, 20})};
  const std::array force{BodyForce{test::box({280, -1, -1}, {301, 4, 4}), {0, 0, -1}}};
  EXPECT_LE(loadCase(frame, hold, force, 12000, {}).share.size(), 700'000u);
}

TEST(LoadCase, FillsTheVolumeOfThePart) {
  const geometry::TriangleMesh ball = test::sphere({3, -2, 12}, 10.0, 48);
  const std::array hold{test::box({-20, -20, 0}, {20, 20, 4})};
  const std::array force{BodyForce{test::box({-20, -20, 19}, {20, 20, 30}), {0, 0, -1}}};
  const LoadCase load = loadCase(ball, hold, force, 4000, {});
  double cells = 0.0;
  for (const float share : load.share)
    cells += static_cast<double>(share);
  EXPECT_NEAR(cells * std::pow(load.grid.pitch, 3), geometry::volume(ball),
              0.01 * geometry::volume(ball));
}

} // namespace
} // namespace voluta::elastic
