#include "base/run_context.h"
#include "process/bead_model.h"
#include "toolpath/cover_patch.h"
#include "toolpath/painter.h"
#include "toolpath/shapes.h"

#include <Eigen/Geometry>
#include <cstdio>
#include <gtest/gtest.h>
#include <numbers>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

toolpath::PatchCover cover(const layers::Patch& patch, const toolpath::ToolpathOptions& o = {}) {
  return toolpath::coverPatch(patch, process::Process{}, o, base::RunContext{});
}

double wavy(const Vector3d& p) {
  return 0.7 + 0.3 * std::sin(0.25 * p.x()) * std::cos(0.2 * p.y());
}

struct Shape {
  const char* name;
  layers::Patch patch;
  double covered; // at least
};

std::vector<Shape> shapes() {
  const test::Lift flat = [](const Vector2d& p) { return Vector3d(p.x(), p.y(), 0.4); };
  return {
      {"disc", test::patchOver({test::circle(15)}), 0.97},
      {"disc of varying thickness", test::patchOver({test::circle(15)}, 0.8, flat, wavy), 0.97},
      {"square", test::patchOver({test::rectangle(30, 30)}), 0.97},
      {"annulus", test::patchOver({test::circle(15), test::circle(9, true)}), 0.97},
      {"L", test::patchOver({test::ell(25, 9)}), 0.97},
      {"star", test::patchOver({test::star(5, 20, 8)}), 0.97},
      {"cap", test::patchOver({test::circle(20 * kPi / 3)}, 0.8, test::onSphere(20), wavy), 0.97},
      {"saddle", test::patchOver({test::circle(15)}, 0.8, test::onSaddle(15), wavy), 0.97},
      {"cylinder", test::patchOver({test::rectangle(40, 20)}, 0.8, test::onCylinder(15), wavy),
       0.97},
      {"three holes",
       test::patchOver({test::circle(18), test::circle(4, true, {8, 0}),
                        test::circle(3, true, {-6, 6}), test::circle(2, true, {-5, -8})}),
       0.97},
  };
}

TEST(CoverPatch, BeadsTileShapes) {
  for (const Shape& s : shapes()) {
    SCOPED_TRACE(s.name);
    const toolpath::PatchCover c = cover(s.patch);
    const test::Painted p = test::paint(s.patch, c.beads);
    std::printf("%-28s area %7.1f beads %3zu own: covered %.4f overlap %.4f | painted %.4f excess "
                "%.4f | volume %.4f\n",
                s.name, c.areaMm2, c.beads.size(), c.coveredMm2 / c.areaMm2,
                c.overlapMm2 / c.areaMm2, p.coveredMm2 / p.areaMm2, p.excessMm2 / p.areaMm2,
                c.beadVolumeMm3 / c.volumeMm3);
    EXPECT_GE(p.coveredMm2 / p.areaMm2, s.covered);
    EXPECT_LE(p.excessMm2 / p.areaMm2, 0.03);
    EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.01);
  }
}

TEST(CoverPatch, StripsOfEveryWidth) {
  for (double w = 1.0; w <= 6.01; w += 0.25) {
    SCOPED_TRACE(w);
    const layers::Patch strip = test::patchOver({test::rectangle(30, w)});
    const toolpath::PatchCover c = cover(strip);
    const test::Painted p = test::paint(strip, c.beads);
    std::printf("strip %.2f beads %zu own %.4f overlap %.4f painted %.4f excess %.4f volume %.4f\n",
                w, c.beads.size(), c.coveredMm2 / c.areaMm2, c.overlapMm2 / c.areaMm2,
                p.coveredMm2 / p.areaMm2, p.excessMm2 / p.areaMm2, c.beadVolumeMm3 / c.volumeMm3);
    EXPECT_GE(p.coveredMm2 / p.areaMm2, 0.975);
    EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.01);
  }
}

} // namespace
