// Bodies that the operator puts into a part: head and arm keep clear of them from then on, and they
// carry beads.
#include "base/run_context.h"
#include "helpers/shapes.h"
#include "program/dialect.h"
#include "replay/replay_ground.h"
#include "replay/replay_scene.h"
#include "replay/told.h"
#include "replay/verification.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

const test::Scene& scene() {
  static const test::Scene s = test::boxScene(3);
  return s;
}

// Replays the print of the scene with a body that is put in before a layer, counted from 0.
Verification replayedWith(const geometry::TriangleMesh& body, int layer,
                          const std::string& format = "urscript") {
  const test::Scene& s = scene();
  plan::ToolPlan plan = s.plan;
  plan.inserts.push_back({"pin", 0, layer, std::make_shared<const geometry::TriangleMesh>(body)});
  const plan::Program written = program::writeProgram(
      format, {s.plan, s.trajectory, s.cell, process::Tooling(s.process), "box"});
  return replayProgram({program::readProgram(format, written.files, process::Tooling(s.process)),
                        plan, s.trajectory, s.cell, process::Tooling(s.process), s.part,
                        s.platform},
                       ReplayThresholds{}, base::RunContext());
}

geometry::TriangleMesh pin(double topMm) {
  return test::box({-1.0, -1.0, 0.0}, {1.0, 1.0, topMm});
}

TEST(InsertedBodies, StandInTheWayFromTheirLayerOn) {
  for (const std::string format : {"urscript", "gcode-extended"}) {
    const Verification last = replayedWith(pin(30.0), 2, format),
                       second = replayedWith(pin(30.0), 1, format);
    EXPECT_GT(last.collisions, 0u) << format;
    EXPECT_GT(second.collidingWaypoints.size(), last.collidingWaypoints.size()) << format;
    EXPECT_FALSE(last.safeToRun);
    EXPECT_THAT(findingsText(last), testing::HasSubstr("inserted part")) << format;
    // Not a place before it.
    for (const std::size_t waypoint : last.collidingWaypoints)
      EXPECT_GE(waypoint, scene().plan.firstAfter({"", 0, 2, nullptr})) << format;
  }
}

TEST(InsertedBodies, AreNoObstacleBeforeTheyAreThereOrBelowTheNozzle) {
  const double heightMm = scene().process.layerHeightMm;
  EXPECT_EQ(replayedWith(pin(30.0), 3).collisions, 0u) << "after the last bead";
  EXPECT_EQ(replayedWith(pin(2.0 * heightMm), 2).collisions, 0u) << "flush with the layer below";
  EXPECT_EQ(replayedWith(test::box({190, 190, 0}, {195, 195, 30}), 0).collisions, 0u)
      << "far from the print";
}

TEST(InsertedBodies, CarryBeadsOnceTheyAreThere) {
  const auto body =
      std::make_shared<const geometry::TriangleMesh>(test::box({-5, -5, 1}, {5, 5, 4}));
  const std::vector<InsertedBody> inserted{{body, 7}};
  const platform::PlatformSolid plate = test::squarePlatform(30.0);
  const GroundProbe probe(plate, inserted);
  EXPECT_FALSE(probe.holds({0, 0, 3}, 0.0, 6));
  EXPECT_TRUE(probe.holds({0, 0, 3}, 0.0, 7));
  EXPECT_TRUE(probe.holds({0, 0, 3}, 0.0, 100));
  EXPECT_FALSE(probe.holds({0, 0, 4.5}, 0.0, 100));
  EXPECT_FALSE(probe.holds({6, 0, 3}, 0.0, 100));
}

} // namespace
} // namespace voluta::replay
