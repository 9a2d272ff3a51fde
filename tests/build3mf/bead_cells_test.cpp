// The solid of beads that come without a part.
#include "base/error.h"
#include "base/run_context.h"
#include "build3mf/bead_cells.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "process/bead_model.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

// Rows side by side, a hatch apart, in layers.
plan::ToolPlan rows(int count, int layers, double length) {
  const double width = 1.2, height = 0.8, hatch = process::hatchOf(width, height);
  plan::ToolPlan plan;
  for (int layer = 0; layer < layers; ++layer)
    for (int row = 0; row < count; ++row) {
      plan::ToolPath path;
      path.first = plan.waypointCount();
      path.count = 2;
      path.layer = layer;
      for (const double x : {0.0, length}) {
        plan.position.emplace_back(x, hatch * row, height * (layer + 1));
        plan.direction.emplace_back(0, 0, 1);
        plan.widthMm.push_back(static_cast<float>(width));
        plan.heightMm.push_back(static_cast<float>(height));
        plan.speedMmPerS.push_back(20.0f);
      }
      plan.paths.push_back(path);
    }
  return plan;
}

TEST(BeadCells, TheSolidsVolumeIsTheMaterials) {
  const plan::ToolPlan plan = rows(12, 5, 20.0);
  const geometry::TriangleMesh solid = build3mf::solidOfBeads(plan, 0.1, base::RunContext());
  const double material = 12 * 5 * 20.0 * process::beadArea(1.2, 0.8);
  EXPECT_NEAR(geometry::volume(solid) / material, 1.0, 0.02);
  EXPECT_TRUE(geometry::diagnose(solid).watertight);
}

TEST(BeadCells, SupportsAreNoPartOfIt) {
  plan::ToolPlan plan = rows(4, 2, 20.0);
  const double before = geometry::volume(build3mf::solidOfBeads(plan, 0.2, base::RunContext()));
  for (std::size_t p = 4; p < 8; ++p)
    plan.paths[p].kind = plan::PathKind::Support;
  EXPECT_NEAR(geometry::volume(build3mf::solidOfBeads(plan, 0.2, base::RunContext())), 0.5 * before,
              0.02 * before);
}

TEST(BeadCells, BeadsWithoutASectionAreNone) {
  plan::ToolPlan plan = rows(2, 1, 5.0);
  plan.widthMm[1] = plan.widthMm[0] = 0.0f;
  EXPECT_THROW(build3mf::solidOfBeads(plan, 0.2, base::RunContext()), base::Error);
}

} // namespace
