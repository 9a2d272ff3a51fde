// Walls and rings between one bead and three: their number of beads is the same all along.
#include "base/run_context.h"
#include "base/units.h"
#include "process/bead_model.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/infill/thin_rings.h"
#include "toolpath/painter.h"
#include "toolpath/patch_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;

process::Process fine() {
  process::Process process;
  process.nozzleDiameterMm = 0.4;
  process.layerHeightMm = 0.2;
  process.layerHeightMinMm = 0.08;
  process.layerHeightMaxMm = 0.32;
  process.beadWidthMm = 0.45;
  process.beadWidthMinMm = 0.4;
  process.beadWidthMaxMm = 0.8;
  return process;
}

struct Covered {
  layers::Patch patch;
  toolpath::PatchCover cover;
  test::Painted painted;
};
Covered covered(const std::vector<test::Loop>& loops, double widthMm,
                const process::Process& process) {
  const double h = process.layerHeightMm;
  Covered c;
  c.patch = test::patchOver(
      loops, std::min(0.5 * process.beadWidthMm, 0.4 * widthMm),
      [&](const Vector2d& p) { return Vector3d(p.x(), p.y(), 0.5 * h); },
      [&](const Vector3d&) { return h; });
  c.cover = toolpath::coverPatch(c.patch, process, {}, base::RunContext{});
  c.painted = test::paint(c.patch, c.cover.beads);
  return c;
}

// A regular polygon or a star, and what is `width` inside it.
std::vector<test::Loop> ringOf(int tips, bool isStar, double radius, double width) {
  test::Loop outer;
  const int n = isStar ? 2 * tips : tips;
  for (int k = 0; k < n; ++k) {
    const double a = 2.0 * base::kPi * k / n + 0.1,
                 r = isStar && k % 2 == 1 ? 0.6 * radius : radius;
    outer.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  test::Loop inner;
  for (int k = 0; k < n; ++k) {
    const auto at = [&](int i) { return outer[static_cast<std::size_t>((i + n) % n)]; };
    const auto inwards = [](const Vector2d& along) {
      return Vector2d(-along.normalized().y(), along.normalized().x());
    };
    const Vector2d one = inwards(at(k) - at(k - 1)), other = inwards(at(k + 1) - at(k));
    inner.push_back(at(k) + width * (one + other) / (1.0 + one.dot(other)));
  }
  std::ranges::reverse(inner);
  return {outer, inner};
}

constexpr double kStep = 0.05; // [beads]

TEST(ThinWalls, PlatesOfOneToThreeBeadsHaveAConstantNumberOfBeads) {
  for (const process::Process& process : {process::Process(), fine()}) {
    std::size_t before = 0; // beads side by side
    for (double beads = 0.9; beads <= 3.1; beads += kStep) {
      const double bead = process.beadWidthMm, width = beads * bead;
      SCOPED_TRACE(testing::Message() << beads << " beads of " << bead);
      const Covered c = covered({test::rectangle(25.0 * bead, width)}, width, process);
      const std::vector<toolpath::Bead>& laid = c.cover.beads;
      ASSERT_GE(laid.size(), 1u);
      ASSERT_LE(laid.size(), 2u) << "no dashes";
      const std::size_t across = (laid.front().closed ? 2 : 1) + laid.size() - 1;
      EXPECT_TRUE(laid.size() == 1 || laid.front().closed);
      EXPECT_GE(across, before);
      before = across;
      EXPECT_GE(c.painted.coveredMm2, 0.958 * c.painted.areaMm2); // the ends of two are round
      EXPECT_NEAR(c.cover.beadVolumeMm3, c.cover.volumeMm3, 0.015 * c.cover.volumeMm3);
      EXPECT_GE(c.cover.coveredMm2, 0.98 * c.cover.areaMm2);
    }
    EXPECT_EQ(before, 3u);
  }
}

TEST(ThinWalls, RingsOfAnyShapeAreClosedBeads) {
  struct Row {
    int tips;
    bool isStar;
    double covered; // at least: sharp corners stay open
  };
  for (const process::Process& process : {process::Process(), fine()})
    for (const Row& row : {Row{48, false, 0.97}, Row{4, false, 0.96}, Row{6, false, 0.965},
                           Row{3, false, 0.93}, Row{5, true, 0.91}}) {
      std::size_t before = 0;
      for (double beads = 0.9; beads <= 3.1; beads += kStep) {
        const double bead = process.beadWidthMm, width = beads * bead;
        SCOPED_TRACE(testing::Message()
                     << row.tips << (row.isStar ? " tips, " : " corners, ") << beads << " beads");
        const Covered c = covered(ringOf(row.tips, row.isStar, 12.5 * bead, width), width, process);
        const std::vector<toolpath::Bead>& laid = c.cover.beads;
        ASSERT_GE(laid.size(), 1u);
        ASSERT_LE(laid.size(), 4u);
        for (const toolpath::Bead& b : laid)
          EXPECT_TRUE(b.closed);
        EXPECT_GE(laid.size(), before);
        before = laid.size();
        EXPECT_GE(c.painted.coveredMm2, row.covered * c.painted.areaMm2);
        EXPECT_NEAR(c.cover.beadVolumeMm3, c.cover.volumeMm3, 0.02 * c.cover.volumeMm3);
      }
      EXPECT_GE(before, 3u);
    }
}

// Two wider beads, where three would be narrower than the narrowest.
TEST(ThinWalls, ARingOfTwoAndAHalfBeadsHasTwo) {
  const Covered c = covered({test::circle(5.0), test::circle(5.0 - 1.05, true)}, 1.05, fine());
  ASSERT_EQ(c.cover.beads.size(), 2u);
  for (const toolpath::Bead& bead : c.cover.beads)
    for (const toolpath::BeadPoint& p : bead.points)
      EXPECT_NEAR(p.widthMm, process::widthOfHatch(0.525, 0.2), 0.04);
}

TEST(ThinWalls, OtherPatchesAreNoRings) {
  const process::Process process;
  const auto rings = [&](const std::vector<test::Loop>& loops) {
    return toolpath::thinRings(toolpath::PatchSurface::refine(test::patchOver(loops, 0.5), 0.4),
                               process, 3)
        .size();
  };
  EXPECT_EQ(rings({test::circle(8), test::circle(6.5, true)}), 1u);
  EXPECT_EQ(rings({test::circle(8)}), 0u) << "one boundary";
  EXPECT_EQ(rings({test::circle(8), test::circle(2, true, {-3, 0}), test::circle(2, true, {3, 0})}),
            0u)
      << "three boundaries";
  EXPECT_EQ(rings({test::circle(8), test::circle(3, true)}), 0u) << "too wide";
  EXPECT_EQ(rings({test::circle(8), test::circle(6, true, {1.2, 0})}), 0u) << "of changing width";
}

} // namespace
