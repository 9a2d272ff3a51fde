// A ring as wide as a bead is one closed bead.
#include "base/run_context.h"
#include "helpers/all_seeds.h"
#include "patch_shapes.h"
#include "process/bead_model.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/options.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;

toolpath::PatchCover coverOf(const layers::Patch& patch) {
  return toolpath::coverPatch(patch, process::Process{}, {}, base::RunContext{});
}

double hatch() {
  const process::Process p;
  return process::hatchOf(p.beadWidthMm, p.layerHeightMm);
}

TEST(RingSpines, ARingOfOneBeadIsClosedAndHasTheBeadsWidth) {
  const double width = process::Process{}.beadWidthMm;
  for (const double radius : {4.0, 9.0, 15.0}) {
    const toolpath::PatchCover cover = coverOf(test::patchOver(
        {test::circle(radius + 0.5 * hatch()), test::circle(radius - 0.5 * hatch(), true)}, 0.5));
    ASSERT_EQ(cover.beads.size(), 1u) << radius;
    const toolpath::Bead& bead = cover.beads.front();
    EXPECT_TRUE(bead.closed);
    EXPECT_EQ(bead.points.front().middle, bead.points.back().middle);
    for (const toolpath::BeadPoint& p : bead.points) {
      EXPECT_NEAR(p.widthMm, width, 0.03 * width) << radius;
      EXPECT_NEAR(p.middle.head<2>().norm(), radius, 0.05) << radius;
    }
  }
}

// Rings cut open by a slit wider than the reach of an end.
TEST(RingSpines, AnOpenRingStaysOpen) {
  layers::Patch ring = test::patchOver(
      {test::circle(10.0 + 0.5 * hatch()), test::circle(10.0 - 0.5 * hatch(), true)}, 0.5);
  std::erase_if(ring.surface.triangles, [&](const std::array<int, 3>& t) {
    const Vector3d& p = ring.surface.vertices[static_cast<std::size_t>(t[0])];
    return p.x() > 0.0 && std::abs(p.y()) < 1.5;
  });
  for (const toolpath::Bead& bead : coverOf(ring).beads)
    EXPECT_FALSE(bead.closed);
}

TEST(RingSpines, RandomRingsOnPlanesAndSpheresAreOneClosedBead) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int run = 0; run < test::ofSeeds(30, 120); ++run) {
    const double radius = 3.0 + 5.0 * unit(random),
                 half = 0.5 * hatch() * (0.95 + 0.2 * unit(random));
    const std::vector<test::Loop> loops{test::circle(radius + half),
                                        test::circle(radius - half, true)};
    const auto seed = static_cast<unsigned>(run + 1);
    const layers::Patch ring =
        run % 2 == 0
            ? test::patchOver(
                  loops, 0.6, [](const Vector2d& p) { return Vector3d(p.x(), p.y(), 0.4); },
                  [](const Vector3d&) { return 0.8; }, seed)
            : test::patchOver(
                  loops, 0.6, test::onSphere(20.0), [](const Vector3d&) { return 0.8; }, seed);
    const toolpath::PatchCover cover = coverOf(ring);
    ASSERT_EQ(cover.beads.size(), 1u) << run;
    EXPECT_TRUE(cover.beads.front().closed) << run;
    EXPECT_GT(cover.coveredMm2, 0.97 * cover.areaMm2) << run;
  }
}

} // namespace
