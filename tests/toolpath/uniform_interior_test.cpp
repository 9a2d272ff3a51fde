#include "base/units.h"
#include "toolpath/coverage/plane_samples.h"
#include "toolpath/coverage/uniform_interior.h"
#include "toolpath/coverage/voronoi_shares.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/infill.h"
#include "toolpath/patch_shapes.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;
using toolpath::SurfaceCurve;

constexpr double kHatch = 1.05, kFrom = 2.0, kStep = 0.5;

// Straight infill of a patch, as it is covered.
struct Filled {
  Filled(const std::vector<test::Loop>& loops, double angle)
      : s(toolpath::PatchSurface::refine(
            test::patchOver(
                loops, 0.8, [](const Vector2d& p) { return Vector3d(p.x(), p.y(), 3.0); },
                [](const Vector3d& p) { return 0.8 + 0.002 * p.x(); }),
            0.6)),
        depth(toolpath::distanceToSegments(s, toolpath::boundarySegments(s), 1e9)) {
    for (double& d : depth)
      d /= kHatch;
    const std::vector<double> hatches(depth.size(), kHatch);
    toolpath::InfillLines lines = toolpath::zigzagInfill({s, depth, hatches, kFrom, 0, angle}, {});
    uniformSpacingMm = std::move(lines.uniformSpacingMm);
    toolpath::ResampleOptions o;
    o.stepMm = kStep;
    o.chordMm = INFINITY;
    for (const SurfaceCurve& c : lines.curves)
      curves.push_back(toolpath::resample(s, c, o).curve);
  }
  toolpath::UniformInterior inside() const { return {s, uniformSpacingMm, depth, kHatch, kStep}; }

  toolpath::PatchSurface s;
  std::vector<double> depth, uniformSpacingMm;
  std::vector<SurfaceCurve> curves;
};

std::vector<test::Loop> randomLoops(std::mt19937& random) {
  std::uniform_real_distribution<double> size(12.0, 26.0), hole(2.0, 5.0), place(-5.0, 5.0);
  switch (random() % 4) {
  case 0:
    return {test::circle(size(random)),
            test::circle(hole(random), true, {place(random), place(random)})};
  case 1:
    return {test::star(3 + static_cast<int>(random() % 5), size(random), 9.0)};
  case 2:
    return {test::ell(2.0 * size(random), 14.0)};
  default:
    return {test::rectangle(2.0 * size(random), 2.0 * size(random))};
  }
}

double sumOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

// Stretches that need no samples have the widths that samples give, and take nothing from the
// others.
TEST(UniformStretches, AgreeWithSamples) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0.0, base::kPi);
  std::size_t withEven = 0;
  for (int round = 0; round < 24; ++round) {
    SCOPED_TRACE(round);
    const Filled f(randomLoops(random), angle(random));
    const toolpath::UniformInterior inside = f.inside();
    const toolpath::UniformStretches even = inside.of(f.curves);
    const auto samples = toolpath::PlaneSamples::of(f.s, 0.016);
    ASSERT_TRUE(samples);
    const toolpath::VoronoiShares reported = assignToNearestCurve(*samples, f.curves, 1.8),
                                  known = assignToNearestCurve(*samples, f.curves, 1.8, {}, even);
    double evenMm2 = 0.0, reportedMm2 = 0.0, evenMm3 = 0.0, reportedMm3 = 0.0, off = 0.0;
    for (std::size_t k = 0; k < f.curves.size(); ++k)
      for (std::size_t i = 0; i < reported.share[k].areaMm2.size(); ++i) {
        const auto &a = known.share[k], &b = reported.share[k];
        if (even.segments.empty() || even.segments[k].empty() ||
            even.segments[k][i].areaMm2 == 0.0) {
          EXPECT_DOUBLE_EQ(a.areaMm2[i], b.areaMm2[i]);
          EXPECT_DOUBLE_EQ(a.lateralMm[i], b.lateralMm[i]);
          continue;
        }
        EXPECT_EQ(a.lateralMm[i], 0.0);
        EXPECT_LT(std::abs(b.lateralMm[i]), 0.1);
        off += std::abs(a.areaMm2[i] - b.areaMm2[i]);
        evenMm2 += a.areaMm2[i];
        reportedMm2 += b.areaMm2[i];
        evenMm3 += a.volumeMm3[i];
        reportedMm3 += b.volumeMm3[i];
      }
    withEven += evenMm2 > 0.0 ? 1 : 0;
    EXPECT_NEAR(evenMm2, reportedMm2, 0.004 * evenMm2 + 0.2);
    EXPECT_NEAR(evenMm3, reportedMm3, 0.004 * evenMm3 + 0.2);
    EXPECT_LT(off, 0.1 * evenMm2 + 0.1); // a sample or so to either side
    for (std::size_t k = 0; k < f.curves.size(); ++k) {
      EXPECT_EQ(known.share[k].beyondMm2[0], reported.share[k].beyondMm2[0]);
      EXPECT_EQ(known.share[k].beyondMm2[1], reported.share[k].beyondMm2[1]);
    }

    const auto fewer = toolpath::PlaneSamples::of(f.s, 0.016, inside.triangles());
    ASSERT_TRUE(fewer);
    const toolpath::VoronoiShares rest = assignToNearestCurve(*fewer, f.curves, 1.8, {}, even);
    double all = 0.0, left = 0.0;
    for (std::size_t k = 0; k < f.curves.size(); ++k) {
      all += sumOf(reported.share[k].volumeMm3);
      left += sumOf(rest.share[k].volumeMm3);
    }
    EXPECT_NEAR(left, all, 0.002 * all);
  }
  EXPECT_GT(withEven, 18u);
}

TEST(UniformStretches, AreMostOfAWidePlate) {
  const Filled f({test::rectangle(60, 60)}, 0.3);
  const std::vector<char> triangles = f.inside().triangles();
  double leftOut = 0.0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    leftOut += triangles[t] ? f.s.triangleArea[t] : 0.0;
  EXPECT_GT(leftOut, 0.6 * f.s.areaMm2);
}

TEST(UniformStretches, AreNoneOfABar) {
  const Filled f({test::rectangle(60, 9)}, 0.3);
  const toolpath::UniformStretches even = f.inside().of(f.curves);
  EXPECT_TRUE(std::ranges::none_of(even.triangles, [](char t) { return t; }));
}

TEST(UniformStretches, AreNotMadeForABentSurface) {
  const toolpath::PatchSurface s = toolpath::PatchSurface::refine(
      test::patchOver({test::circle(20)}, 0.8, test::onSphere(60)), 0.6);
  std::vector<double> depth = toolpath::distanceToSegments(s, toolpath::boundarySegments(s), 1e9);
  const std::vector<double> hatches(depth.size(), kHatch);
  EXPECT_TRUE(
      toolpath::zigzagInfill({s, depth, hatches, kFrom, 0, 0.3}, {}).uniformSpacingMm.empty());
}

} // namespace
