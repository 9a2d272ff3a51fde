// Beads with a small gap to printed beads below, made thicker.
#include "collision/growing_part.h"
#include "toolpath/unsupported/thicken_unsupported.h"

#include "one_pass.h"
#include "process/bead_model.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using namespace voluta::test;

namespace {

toolpath::UnsupportedBeads thickened(const plan::ToolPlan& plan) {
  return afterPass("thicken", plan);
}

} // namespace

TEST(Thickened, ReachesDownToThePrintedBead) {
  plan::ToolPlan plan;
  addPath(plan, -15, 15, 0, 0.8, 0);
  addPath(plan, -15, 15, 0, 0.8 + 0.5 + 0.4, 1, 0.4f);
  const toolpath::UnsupportedBeads thickenedBeads = thickened(plan);
  const plan::ToolPath& above = thickenedBeads.plan.paths.back();
  for (std::size_t i = above.first; i < above.first + above.count; ++i) {
    EXPECT_NEAR(thickenedBeads.plan.heightMm[i], 0.9, 0.15 + 0.04); // half a cell, half a step
    EXPECT_EQ(thickenedBeads.plan.position[i], plan.position[i]);
    EXPECT_EQ(thickenedBeads.unsupported[i], 0);
  }
  EXPECT_EQ(thickenedBeads.plan.heightMm.front(), plan.heightMm.front());
}

TEST(Thickened, NotWhereItIsFarOrShortAndNeverThickerThanLayersMayBe) {
  plan::ToolPlan far;
  addPath(far, -15, 15, 0, 0.8, 0);
  addPath(far, -15, 15, 0, 0.8 + 0.9 + 0.4, 1, 0.4f);
  const toolpath::UnsupportedBeads high = thickened(far);
  EXPECT_EQ(high.plan.heightMm, far.heightMm);
  EXPECT_GT(std::ranges::count(high.unsupported, 1), 20);

  plan::ToolPlan shortGap; // a bridge of two millimetres
  addPath(shortGap, -15, 15, 0, 0.8, 0);
  addPath(shortGap, -15, -1, 0, 1.2, 1, 0.4f);
  addPath(shortGap, 1, 15, 0, 1.2, 1, 0.4f);
  addPath(shortGap, -15, 15, 0, 1.6, 2, 0.4f);
  EXPECT_EQ(thickened(shortGap).plan.heightMm, shortGap.heightMm);
}

// By the hundred: no bead is deposited into an earlier one, nor faster than the extruder's flow
// allows.
TEST(Thickened, RandomHeights) {
  std::size_t changed = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    const auto number = [&](double from, double to) {
      return std::uniform_real_distribution<>(from, to)(random);
    };
    plan::ToolPlan plan;
    const double y = number(-0.2, 0.2), height = number(0.4, 0.7);
    addPath(plan, -15, 15, 0, 0.8, 0);
    addPath(plan, number(-15, -8), number(8, 15), y, 0.8 + height + number(0.0, 0.8), 1,
            static_cast<float>(height));
    const toolpath::UnsupportedBeads thickenedBeads = thickened(plan);
    const double pitch = collision::growingPitch(plan, process::Tooling(kProcess));
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      const auto now = static_cast<double>(thickenedBeads.plan.heightMm[i]);
      if (thickenedBeads.plan.heightMm[i] == plan.heightMm[i])
        continue;
      ++changed;
      EXPECT_LE(now, kProcess.layerHeightMaxMm + 1e-6);
      EXPECT_GE(plan.position[i].z() - now, 0.8 - 0.5 * pitch - 1e-6) << seed;
      EXPECT_LE(plan.position[i].z() - now, 0.8 + 0.5 * pitch + 0.125 * pitch) << seed;
      EXPECT_LE(static_cast<double>(thickenedBeads.plan.speedMmPerS[i]) *
                    process::beadArea(static_cast<double>(thickenedBeads.plan.widthMm[i]), now),
                kProcess.maxFlowMm3PerS * (1.0 + 1e-5));
    }
  }
  EXPECT_GT(changed, 500u);
}
