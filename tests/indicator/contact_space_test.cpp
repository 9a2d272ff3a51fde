#include "indicator/contact_space.h"

#include "indicator/planar_arm.h"
#include "process/process.h"

#include <cstdlib>
#include <gtest/gtest.h>

using namespace voluta;
using robot::JointVector;

namespace {

std::vector<Eigen::Vector2d> square(double half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

// A dome of beads 1.2 mm apart, 40 mm wide.
plan::ToolPlan dome() {
  plan::ToolPlan plan;
  const Eigen::Vector3d centre(0, 0, -20);
  for (double x = -20.0; x <= 20.0; x += 1.2)
    for (double y = -20.0; y <= 20.0; y += 1.2) {
      const Eigen::Vector3d up = (Eigen::Vector3d(x, y, 20.0) - centre).normalized();
      plan.position.push_back(centre + 40.0 * up);
      plan.direction.push_back(up);
      plan.widthMm.push_back(1.2f);
      plan.heightMm.push_back(0.8f);
      plan.speedMmPerS.push_back(20.0f);
    }
  plan.paths.push_back({0, plan.position.size()});
  return plan;
}

} // namespace

TEST(ContactSpace, ProjectsOntoTheSurface) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const process::Process process = process::loadProcess("fdm-1.0");
  const plan::ToolPlan plan = dome();
  // The plate on the flange, and the nozzle on it.
  for (const char* id : {"ur5-fixed", "ur5-moving"}) {
    const robot::Cell cell = robot::loadCell(id, process, square(60.0));
    const indicator::ContactSpace space(cell, plan, 0, plan.waypointCount());
    const std::vector<JointVector> on = space.random(200, 3);
    ASSERT_GE(on.size(), 200u) << id;
    const std::vector<JointVector> beside = test::shaken(on, 0.05, 4);
    int projected = 0;
    for (std::size_t i = 0; i < on.size(); ++i) {
      EXPECT_LT(space.distanceMm(on[i]), 1e-6) << id;
      if (const auto q = space.project(beside[i])) {
        ++projected;
        EXPECT_LE(space.distanceMm(*q), 0.05) << id;
        // There are joints on contact at most this far; the nearest are no further.
        EXPECT_LE((*q - beside[i]).norm(), 1.1 * (on[i] - beside[i]).norm()) << id << " " << i;
      }
    }
    EXPECT_GT(projected, 190) << id;
  }
}

TEST(ContactSpace, OutOfReachHasNone) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const process::Process process = process::loadProcess("fdm-1.0");
  plan::ToolPlan plan = dome();
  for (Eigen::Vector3d& p : plan.position)
    p.x() += 5000.0;
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, square(60.0));
  EXPECT_TRUE(indicator::ContactSpace(cell, plan, 0, plan.waypointCount()).random(50, 1).empty());
}
