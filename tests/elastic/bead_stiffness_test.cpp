// Moduli of beads and tapes in closed form.
#include "elastic/bead_stiffness.h"

#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::elastic {
namespace {

using Eigen::Vector3d;

const process::Elasticity kPla{3120.0, 2770.0, 1050.0, 0.33};

// The modulus under a stress along a direction: that over the strain along it.
double modulusAlong(const Stiffness6& stiffness, const Vector3d& n) {
  const Eigen::Matrix3d dyad = n * n.transpose();
  Tensor6 stress;
  stress << dyad(0, 0), dyad(1, 1), dyad(2, 2), dyad(0, 1), dyad(1, 2), dyad(2, 0);
  const Tensor6 strain = stiffness.inverse() * stress;
  return 1.0 / (strain[0] * n.x() * n.x() + strain[1] * n.y() * n.y() + strain[2] * n.z() * n.z() +
                strain[3] * n.x() * n.y() + strain[4] * n.y() * n.z() + strain[5] * n.z() * n.x());
}

TEST(BeadStiffness, FollowsTheClosedFormOfAnAngle) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Vector3d along = Vector3d(any(random), any(random), any(random)).normalized(),
                   load = Vector3d(any(random), any(random), any(random)).normalized();
    const double c2 = std::pow(along.dot(load), 2), s2 = 1.0 - c2;
    const double inverse = c2 * c2 / kPla.alongMPa + s2 * s2 / kPla.acrossMPa +
                           c2 * s2 * (1.0 / kPla.shearMPa - 2.0 * kPla.poisson / kPla.alongMPa);
    EXPECT_NEAR(modulusAlong(beadStiffness(kPla, along), load), 1.0 / inverse, 1e-6 / inverse);
  }
}

TEST(BeadStiffness, OfAnIsotropicMaterialHasNoDirection) {
  const Stiffness6 stiffness = isotropicStiffness(2000.0, 0.3);
  for (const Vector3d& load : {Vector3d(1, 0, 0), Vector3d(0.6, 0.8, 0), Vector3d(0.6, 0, 0.8)})
    EXPECT_NEAR(modulusAlong(stiffness, load), 2000.0, 1e-6);
  EXPECT_NEAR(stiffness(4, 4), 2000.0 / 2.6, 1e-9);
}

TEST(BeadStiffness, OfTapesIsTheLawOfMixture) {
  process::Process tape;
  tape.tape = process::Tape{.fibreMPa = 230000.0, .fibreShare = 0.3};
  const auto mixed = tapeElasticity(tape, kPla);
  ASSERT_TRUE(mixed);
  EXPECT_NEAR(mixed->alongMPa, 0.3 * 230000.0 + 0.7 * 3120.0, 1e-6);
  EXPECT_NEAR(1.0 / mixed->acrossMPa, 0.3 / 230000.0 + 0.7 / 2770.0, 1e-12);
  tape.tape->fibreShare = 0.0;
  EXPECT_FALSE(tapeElasticity(tape, kPla)) << "the share of fibres is unknown";
}

} // namespace
} // namespace voluta::elastic
