// Samples of a bent surface: the ones near a segment, and the ones given to curves.
#include "toolpath/coverage/sample_grid.h"

#include "toolpath/coverage/voronoi_shares.h"
#include "toolpath/patch_shapes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <utility>

using namespace voluta;
using Eigen::Vector3d;
using toolpath::PatchSurface;
using toolpath::SampleGrid;
using toolpath::SurfaceCurve;

namespace {

constexpr double kRadius = 14.0; // of the sphere

PatchSurface cap() {
  return PatchSurface::refine(test::patchOver({test::star(5, 9, 5)}, 0.8, test::onSphere(kRadius)),
                              0.6);
}

// Distance, and where along the segment the foot would be if it went on: below 0 or above 1 beyond
// its ends.
std::pair<double, double> measured(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double squared = (b - a).squaredNorm();
  const double t = squared > 0.0 ? (p - a).dot(b - a) / squared : 0.0;
  return {(p - a - std::clamp(t, 0.0, 1.0) * (b - a)).norm(), t};
}

} // namespace

TEST(SampleGrid, HoldsTheSamplesOfTheSurface) {
  const PatchSurface s = cap();
  const SampleGrid grid(s, 0.05);
  double area = 0.0;
  std::size_t count = 0;
  toolpath::forEachSample(s, 0.05, [&](const toolpath::SurfaceSample&) { ++count; });
  ASSERT_EQ(grid.count(), count);
  for (std::size_t i = 0; i < grid.count(); ++i) {
    area += grid.sample(i).areaMm2;
    EXPECT_EQ(grid.normal(i), s.triangleNormal[grid.sample(i).triangle]);
  }
  EXPECT_NEAR(area, s.areaMm2, 1e-9 * s.areaMm2);
}

TEST(SampleGrid, FindsNearSamplesAsBruteForceDoes) {
  const PatchSurface s = cap();
  const SampleGrid grid(s, 0.1);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-10.0, 10.0);
  std::size_t found = 0, leftOut = 0;
  for (int n = 0; n < 200; ++n) {
    const auto off = [&] { return Vector3d(number(random), number(random), number(random)); };
    const Vector3d a = grid.sample(random() % grid.count()).position + 0.05 * off();
    const Vector3d b = n % 6 == 0 ? a : Vector3d(a + 0.3 * off());
    const double radius = 0.2 + 0.1 * (10.0 + number(random));
    const double beyond = n % 2 == 0 ? radius : 0.1 * radius;
    std::vector<char> near(grid.count(), 0);
    grid.forEachNear(a, b, radius, {beyond, beyond}, [&](std::size_t i, float squared, float) {
      EXPECT_EQ(near[i], 0);
      near[i] = 1;
      const auto [distance, t] = measured(grid.sample(i).position, a, b);
      EXPECT_NEAR(distance * distance, squared, 1e-3);
      EXPECT_LT(distance, radius + 1e-3);
    });
    for (std::size_t i = 0; i < grid.count(); ++i) {
      const auto [distance, t] = measured(grid.sample(i).position, a, b);
      const double past = std::max(-t, t - 1.0) * (b - a).norm();
      if (distance > radius - 1e-3)
        continue;
      found += near[i];
      leftOut += near[i] == 0;
      if (past < beyond - 1e-3 || a == b) {
        EXPECT_NE(near[i], 0) << n << " " << distance << " of " << radius << ", past " << past;
      }
    }
  }
  EXPECT_GT(found, 10000U);
  EXPECT_GT(leftOut, 100U) << "ends that go on are not painted twice";
}

// Curves with corners of all kinds, open and closed: each sample to the nearest segment of all.
TEST(SampleGrid, AreSharedOutToTheNearestCurve) {
  const PatchSurface s = cap();
  const SampleGrid grid(s, 0.03);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<SurfaceCurve> curves;
  for (int k = 0; k < 9; ++k) {
    SurfaceCurve curve;
    curve.closed = k % 3 == 0;
    for (int i = 0; i <= 12; ++i) {
      const double x = -9.0 + 1.5 * i, y = -8.0 + 2.0 * k + 0.4 * number(random);
      const double z = std::sqrt(std::max(1.0, kRadius * kRadius - x * x - y * y));
      curve.points.push_back(s.project({x, y, z}, 0));
    }
    curves.push_back(curve);
  }
  constexpr double kReach = 1.8;
  const toolpath::VoronoiShares cells = assignToNearestCurve(grid, curves, kReach);
  std::vector<double> expected(curves.size(), 0.0), got(curves.size(), 0.0);
  double orphan = 0.0, off = 0.0;
  std::vector<std::vector<double>> bySegment;
  for (const SurfaceCurve& c : curves)
    bySegment.emplace_back(c.points.size() - (c.closed ? 0 : 1), 0.0);
  for (std::size_t i = 0; i < grid.count(); ++i) {
    double minimum = kReach;
    std::size_t curve = curves.size(), segment = 0;
    for (std::size_t k = 0; k < curves.size(); ++k)
      for (std::size_t j = 0; j < bySegment[k].size(); ++j) {
        const auto& points = curves[k].points;
        const double d = measured(grid.sample(i).position, points[j].position,
                                  points[(j + 1) % points.size()].position)
                             .first;
        if (d < minimum) {
          minimum = d;
          curve = k;
          segment = j;
        }
      }
    if (curve == curves.size())
      orphan += grid.sample(i).areaMm2;
    else
      bySegment[curve][segment] += grid.sample(i).areaMm2;
  }
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (std::size_t j = 0; j < bySegment[k].size(); ++j) {
      expected[k] += bySegment[k][j];
      got[k] += cells.share[k].areaMm2[j];
      off += std::abs(bySegment[k][j] - cells.share[k].areaMm2[j]);
    }
  for (std::size_t k = 0; k < curves.size(); ++k)
    EXPECT_NEAR(got[k], expected[k], 0.002 * s.areaMm2) << k;
  EXPECT_NEAR(cells.orphanMm2, orphan, 0.002 * s.areaMm2);
  EXPECT_LT(off, 0.05 * s.areaMm2) << "but for what is as near to two of a corner";
}
