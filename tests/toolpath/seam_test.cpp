// Seams: every row of the table on beads in closed form, in layers of any direction.
#include "toolpath/order/seam.h"

#include "base/error.h"
#include "base/units.h"
#include "toolpath/unsupported/bead_tip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

using base::kTwoPi;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kWidth = 1.2, kHeight = 0.8;

// Closed, through the points in their order; directions are `up`.
Bead closedBead(const std::vector<Vector3d>& tips, const std::vector<Vector3d>& up) {
  Bead b;
  b.closed = true;
  for (std::size_t i = 0; i < tips.size(); ++i)
    b.points.push_back({tips[i] - 0.5 * kHeight * up[i], up[i], up[i], kWidth, kHeight});
  b.points.push_back(b.points.front());
  return b;
}

// The polygon's sides in steps of about 0.8 mm, moved.
Bead polygonBead(const std::vector<Vector2d>& corners,
                 const Isometry3d& at = Isometry3d::Identity()) {
  std::vector<Vector3d> tips;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2d a = corners[i], side = corners[(i + 1) % corners.size()] - a;
    const int steps = std::max(1, static_cast<int>(side.norm() / 0.8));
    for (int k = 0; k < steps; ++k) {
      const Vector2d p = a + side * k / steps;
      tips.push_back(at * Vector3d(p.x(), p.y(), 0.0));
    }
  }
  return closedBead(tips, std::vector<Vector3d>(tips.size(), at.linear() * Vector3d::UnitZ()));
}

std::vector<Vector2d> circle(double radius, int sides = 96) {
  std::vector<Vector2d> points;
  for (int i = 0; i < sides; ++i)
    points.emplace_back(radius * std::cos(kTwoPi * i / sides),
                        radius * std::sin(kTwoPi * i / sides));
  return points;
}

// Around a rod along y: the layer's normals point away from the rod.
Bead lathedBead(double radius, double y) {
  std::vector<Vector3d> tips, up;
  for (int i = 0; i < 80; ++i) {
    const double a = kTwoPi * i / 80;
    up.emplace_back(std::cos(a), 0.0, std::sin(a));
    tips.push_back(radius * up.back() + y * Vector3d::UnitY());
  }
  return closedBead(tips, up);
}

const std::vector<Vector2d> kSquare{{0, 0}, {20, 0}, {20, 20}, {0, 20}};
const std::vector<Vector2d> kEll{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}};

Isometry3d randomMotion(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  Isometry3d at = Isometry3d::Identity();
  at.linear() = q.normalized().toRotationMatrix();
  at.translation() = 20.0 * Vector3d(normal(random), normal(random), normal(random));
  return at;
}

double lengthOf(const Bead& b) {
  double mm = 0.0;
  for (std::size_t i = 1; i < b.points.size(); ++i)
    mm += (tipOf(b.points[i]) - tipOf(b.points[i - 1])).norm();
  return mm;
}

SeamPlace placeOf(const SeamKind& kind, const Bead& bead, int layer = 0,
                  std::span<const Vector3d> below = {}) {
  return kind.place({bead, layer, 0, below});
}

TEST(Seams, EveryRowOfTheTableBeginsOnTheBeadAndChangesNothingElse) {
  std::mt19937 random(7);
  ASSERT_EQ(seamKinds().front().place, nullptr);
  for (const SeamKind& kind : seamKinds()) {
    SCOPED_TRACE(kind.id);
    EXPECT_EQ(&seamKind(kind.id), &kind);
    if (!kind.place)
      continue;
    for (int round = 0; round < 100; ++round) {
      const Isometry3d at = randomMotion(random);
      for (const Bead& bead : {polygonBead(kSquare, at), polygonBead(kEll, at),
                               polygonBead(circle(7), at), lathedBead(12, 3.0 + round)}) {
        const std::vector<Vector3d> below{tipOf(bead.points[round % 10U]) +
                                          0.3 * Vector3d::UnitX()};
        const SeamPlace place = placeOf(kind, bead, round, below);
        ASSERT_LT(place.segment + 1, bead.points.size());
        EXPECT_GE(place.share, 0.0);
        EXPECT_LT(place.share, 1.0);
        const SeamPlace again = placeOf(kind, bead, round, below);
        EXPECT_EQ(again.segment, place.segment);
        EXPECT_EQ(again.share, place.share);
        const Bead begun = begunAt(bead, place);
        EXPECT_TRUE(begun.closed);
        EXPECT_LE((tipOf(begun.points.front()) - tipAt(bead, place)).norm(), 0.1);
        EXPECT_EQ(begun.points.front().middle, begun.points.back().middle);
        EXPECT_NEAR(lengthOf(begun), lengthOf(bead), 1e-5);
        EXPECT_LE(begun.points.size(), bead.points.size() + 1);
        for (const BeadPoint& p : begun.points) {
          EXPECT_NEAR(p.widthMm, kWidth, 1e-9);
          EXPECT_NEAR(p.direction.norm(), 1.0, 1e-9);
        }
      }
    }
  }
  EXPECT_THROW(seamKind("alligned"), base::Error);
}

// For any first point of the bead.
TEST(Seams, AlignedAndCornerDependOnTheShapeOnly) {
  for (const std::string_view id : {"aligned", "corner"})
    for (const Bead& bead : {polygonBead(kEll), polygonBead(circle(7)), lathedBead(12, 3)}) {
      const Vector3d tip = tipAt(bead, placeOf(seamKind(id), bead));
      for (std::size_t k = 1; k < bead.points.size() - 1; k += 7) {
        const Bead turned = begunAt(bead, {k, 0.0});
        EXPECT_LT((tipAt(turned, placeOf(seamKind(id), turned)) - tip).norm(), 1e-9) << id;
      }
    }
}

TEST(Seams, CornerTakesTheConcaveCornerInAnyLayer) {
  std::mt19937 random(11);
  for (int round = 0; round < 100; ++round) {
    const Isometry3d at = randomMotion(random);
    const Bead ell = polygonBead(kEll, at);
    const Vector3d tip = tipAt(ell, placeOf(seamKind("corner"), ell));
    EXPECT_LT((tip - at * Vector3d(8, 8, 0)).norm(), 1e-9);
    // The same outline as a hole: material on the other side of it.
    std::vector<Vector2d> hole(kEll.rbegin(), kEll.rend());
    const Bead around = polygonBead(hole, at);
    const Vector3d inHole = tipAt(around, placeOf(seamKind("corner"), around));
    EXPECT_GT((inHole - at * Vector3d(8, 8, 0)).norm(), 1.0);
    const bool isCorner = std::ranges::any_of(kEll, [&](const Vector2d& c) {
      return (inHole - at * Vector3d(c.x(), c.y(), 0)).norm() < 1e-9;
    });
    EXPECT_TRUE(isCorner);
  }
}

// A square has four corners of one sharpness: the seam stays with one of them.
TEST(Seams, CornerStaysWithTheCornerBelow) {
  const Bead square = polygonBead(kSquare);
  for (const Vector2d& corner : kSquare) {
    const std::vector<Vector3d> below{Vector3d(corner.x() + 0.2, corner.y() - 0.3, -kHeight)};
    const Vector3d tip = tipAt(square, placeOf(seamKind("corner"), square, 1, below));
    EXPECT_LT((tip - Vector3d(corner.x(), corner.y(), 0)).norm(), 1e-9);
  }
}

// Cones of which every layer has its points elsewhere: the seams are on a straight line.
TEST(Seams, AlignedSeamsOfAConeAreInOneLine) {
  std::vector<Vector3d> below;
  for (int layer = 0; layer < 100; ++layer) {
    Isometry3d at = Isometry3d(Eigen::AngleAxisd(0.37 * layer, Vector3d::UnitZ()));
    at.translation().z() = kHeight * layer;
    const double radius = 30.0 - 0.2 * layer;
    const Bead ring = polygonBead(circle(radius), at);
    const Vector3d tip = tipAt(ring, placeOf(seamKind("aligned"), ring, layer, below));
    EXPECT_NEAR(tip.head<2>().norm(), radius, 0.05);
    if (layer == 0)
      EXPECT_NEAR(tip.y(), radius, 0.05);
    else
      EXPECT_LT(std::atan2(std::abs(tip.x() - below.front().x()), tip.y()) * radius, 0.6);
    below = {tip};
  }
}

TEST(Seams, AlignedSeamsAroundARodAreInOneLine) {
  std::vector<Vector3d> below;
  for (int layer = 0; layer < 30; ++layer) {
    const Bead ring = lathedBead(5.0 + kHeight * layer, 4.0);
    const Vector3d tip = tipAt(ring, placeOf(seamKind("aligned"), ring, layer, below));
    EXPECT_NEAR(tip.z(), 5.0 + kHeight * layer, 0.05);
    below = {tip};
  }
}

TEST(Seams, AlignedFollowsOnlySeamsWithinReach) {
  const Bead ring = polygonBead(circle(15));
  const auto tipFor = [&](const Vector3d& below) -> Vector3d {
    const std::vector<Vector3d> seams{below};
    return tipAt(ring, placeOf(seamKind("aligned"), ring, 1, seams));
  };
  EXPECT_LT((tipFor({15 + 1.5, 0, -kHeight}) - Vector3d(15, 0, 0)).norm(), 0.01);
  EXPECT_LT((tipFor({15 + 4.0, 0, -kHeight}) - Vector3d(0, 15, 0)).norm(), 0.01);
}

TEST(Seams, SpreadSeamsAreUniform) {
  const Bead ring = polygonBead(circle(15));
  std::vector<int> count(8, 0);
  for (int layer = 0; layer < 800; ++layer) {
    const Vector3d tip = tipAt(ring, placeOf(seamKind("spread"), ring, layer));
    const double revolution = std::atan2(tip.y(), tip.x()) / kTwoPi + 0.5;
    ++count[std::min<std::size_t>(7, static_cast<std::size_t>(8.0 * revolution))];
  }
  for (const int c : count)
    EXPECT_NEAR(c, 100, 40);
}

} // namespace
} // namespace voluta::toolpath
