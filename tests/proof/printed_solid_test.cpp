// The part as printed: one closed solid whose volume is the material's.
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "pipeline/box_request.h"
#include "pipeline/checked_program.h"
#include "pipeline/printed_mesh.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

const base::RunContext kCtx;

TEST(PrintedSolid, ABoxIsAsMuchAsTheReplayLays) {
  const pipeline::PlanResult& plan = test::boxPlan();
  const geometry::TriangleMesh solid =
      pipeline::printedSolid(*plan.job.toolPlan, plan.tooling().first().process, kCtx);
  const geometry::Diagnosis found = geometry::diagnose(solid);
  EXPECT_TRUE(found.watertight);
  EXPECT_EQ(found.components, 1u); // no walls are left inside
  const double deposited =
      plan.checked[0]->verdict.massRatio * geometry::volume(plan.job.item().printed()); // mm3
  EXPECT_NEAR(geometry::volume(solid), deposited, 0.03 * deposited);
  const Eigen::AlignedBox3d box = geometry::bounds(solid);
  EXPECT_NEAR(box.sizes().x(), 20.0, 0.8);
  EXPECT_NEAR(box.sizes().z(), 8.0, 0.8);
}

} // namespace
