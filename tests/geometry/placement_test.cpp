#include "geometry/placement.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace voluta;
using Eigen::Vector3d;
using geometry::Placement;

namespace {

const geometry::TriangleMesh kBox = test::box(Vector3d(10, 20, 30), Vector3d(14, 28, 46));

void expectBox(const geometry::TriangleMesh& mesh, const Vector3d& low, const Vector3d& high) {
  const Eigen::AlignedBox3d box = geometry::bounds(mesh);
  EXPECT_LT((box.min() - low).norm(), 1e-12) << box.min().transpose();
  EXPECT_LT((box.max() - high).norm(), 1e-12) << box.max().transpose();
}

TEST(Placement, TheDefaultIsThePlateBitByBit) {
  EXPECT_EQ(geometry::place(kBox, 0.7, {}).vertices, geometry::placeOnPlate(kBox, 0.7).vertices);
}

TEST(Placement, AQuarterTurnAboutXLaysTheBoxDown) {
  Placement p;
  p.rotation = Eigen::AngleAxisd(0.5 * base::kPi, Vector3d::UnitX());
  expectBox(geometry::place(kBox, 1.0, p), {-2, -8, 0}, {2, 8, 8});
}

TEST(Placement, CentreAndLiftAreNotScaled) {
  Placement p;
  p.centreMm = {30, -5};
  p.liftMm = 1.5;
  expectBox(geometry::place(kBox, 0.5, p), {29, -7, 1.5}, {31, -3, 9.5});
}

TEST(Placement, ARotationNeedNotBeOfUnitLength) {
  Placement once, twice;
  once.rotation = Eigen::Quaterniond(0.6, 0.0, 0.8, 0.0);
  twice.rotation.coeffs() = 2.0 * once.rotation.coeffs();
  const auto a = geometry::place(kBox, 1.0, once), b = geometry::place(kBox, 1.0, twice);
  for (std::size_t v = 0; v < a.vertices.size(); ++v)
    EXPECT_LT((a.vertices[v] - b.vertices[v]).norm(), 1e-12);
}

TEST(Placement, NonsenseIsRefused) {
  Placement p;
  p.rotation.coeffs().setZero();
  EXPECT_THROW(geometry::place(kBox, 1.0, p), base::Error);
  p = {};
  p.liftMm = std::numeric_limits<double>::infinity();
  EXPECT_THROW(geometry::place(kBox, 1.0, p), base::Error);
  EXPECT_THROW(geometry::rotationLayingFlat(Vector3d::Zero()), base::Error);
}

TEST(Placement, LayingFlatPointsTheNormalDown) {
  for (const Vector3d& n :
       {Vector3d(1, 0, 0), Vector3d(0, 0, -1), Vector3d(0, 0, 1), Vector3d(0, 0, 5),
        Vector3d(1e-9, 0, 1), Vector3d(0.3, -2.0, 0.7), Vector3d(-1e-3, 1e-3, 1)}) {
    const Eigen::Quaterniond q = geometry::rotationLayingFlat(n);
    EXPECT_NEAR(q.norm(), 1.0, 1e-12) << n.transpose();
    EXPECT_LT((q * n.normalized() + Vector3d::UnitZ()).norm(), 1e-8) << n.transpose();
  }
  EXPECT_EQ(
      geometry::rotationLayingFlat({0, 0, -3}).angularDistance(Eigen::Quaterniond::Identity()), 0.0)
      << "what lies flat stays as it is";
  Placement p;
  p.rotation = geometry::rotationLayingFlat({1, 0, 0});
  const Vector3d size = geometry::bounds(geometry::place(kBox, 1.0, p)).sizes();
  EXPECT_LT((size - Vector3d(16, 8, 4)).norm(), 1e-9) << size.transpose();
}

} // namespace
