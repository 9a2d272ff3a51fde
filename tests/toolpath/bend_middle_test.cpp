// The middle of a ring's share, in closed form, and pins that one ring fills.
#include "toolpath/coverage/bend_middle.h"

#include "base/run_context.h"
#include "base/units.h"
#include "process/process.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/patch_shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

// A counter-clockwise ring of `points` points.
SurfaceCurve ring(const PatchSurface& s, double radiusMm, int points) {
  SurfaceCurve curve;
  curve.closed = true;
  for (int i = 0; i < points; ++i) {
    const double angle = 2.0 * base::kPi * i / points;
    curve.points.push_back(
        s.project(radiusMm * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0), 0));
  }
  return curve;
}

// The share of a ring of radius r between radii a and R extends by r - a inwards and by R - r
// outwards: its middle is r - (a + R) / 2 to the left. The mean of the share is farther out.
// Without a hole the inner extent is the root of a number near zero, and less exact.
void expectMiddle(double innerMm, double outerMm, double withinMm) {
  std::vector<test::Loop> loops{test::circle(outerMm)};
  if (innerMm > 0.0)
    loops.push_back(test::circle(innerMm, true));
  const PatchSurface s = PatchSurface::refine(test::patchOver(loops, 0.3), 0.2);
  const SampleGrid samples(s, 0.0005);
  const double halfway = 0.5 * (innerMm + outerMm);
  for (const double radiusMm : {halfway - 0.1, halfway, halfway + 0.1, halfway + 0.25}) {
    const SurfaceCurve curve = ring(s, radiusMm, 24);
    const CellShare share = assignToNearestCurve(samples, {curve}, 4.0).share[0];
    const std::vector<double> middle = middleOfExtents(s, curve, share);
    ASSERT_EQ(middle.size(), 24u);
    double mean = 0.0;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      mean += middle[i] / static_cast<double>(middle.size());
      EXPECT_LT(share.lateralMm[i], middle[i]) << radiusMm;
    }
    EXPECT_NEAR(mean, radiusMm - halfway, withinMm) << radiusMm;
  }
}

TEST(BendMiddle, OfARingIsHalfwayBetweenTheEdgesOfItsShare) {
  expectMiddle(0.6, 2.0, 0.03);
  expectMiddle(1.0, 2.2, 0.03);
}

TEST(BendMiddle, OfARingInADiscIsHalfwayToItsCentre) {
  expectMiddle(0.0, 1.6, 0.1);
}

TEST(BendMiddle, OfAStraightLineIsTheMeanOfItsShare) {
  const PatchSurface s = PatchSurface::refine(test::patchOver({test::rectangle(12, 3)}, 0.8), 0.3);
  SurfaceCurve line;
  for (double x = -6.0; x <= 6.0; x += 0.5)
    line.points.push_back(s.project({x, 0.4, 0.0}, 0));
  const CellShare share = assignToNearestCurve(SampleGrid(s, 0.001), {line}, 4.0).share[0];
  const std::vector<double> middle = middleOfExtents(s, line, share);
  for (std::size_t i = 0; i < middle.size(); ++i)
    EXPECT_NEAR(middle[i], share.lateralMm[i], 1e-6);
}

// One bead around the axis of a pin covers it to its centre.
TEST(BendMiddle, FillsPins) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> diameter(2.7, 3.4);
  for (int run = 0; run < 40; ++run) {
    const double d = diameter(random);
    const layers::Patch patch = test::patchOver({test::circle(0.5 * d)}, 0.8);
    const PatchCover cover = coverPatch(patch, process::Process{}, {}, base::RunContext{});
    EXPECT_GT(cover.coveredMm2, 0.985 * cover.areaMm2) << d;
    EXPECT_NEAR(cover.beadVolumeMm3, cover.volumeMm3, 0.01 * cover.volumeMm3) << d;
  }
}

} // namespace
} // namespace voluta::toolpath
