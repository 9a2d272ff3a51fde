// Where tapes are cut.
#include "motion/tape_events.h"

#include "base/units.h"

#include <Eigen/Core>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::motion {
namespace {

process::Tooling tooling() {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return process::Tooling({{process::loadProcess("fdm-1.0")}, {process::loadProcess("tape-5")}});
}

// A plan and its motion: straight paths with these waypoints [mm] along x.
struct Motion {
  plan::ToolPlan plan;
  plan::Trajectory trajectory;

  Motion() { point(plan::MoveKind::Joint, plan::kNoWaypoint); }

  void add(const std::vector<double>& along, bool isTape) {
    plan::ToolPath path{.first = plan.waypointCount(), .count = along.size()};
    path.kind = isTape ? plan::PathKind::Tape : plan::PathKind::Infill;
    path.tool = isTape ? 1 : 0;
    point(plan::MoveKind::Linear, plan::kNoWaypoint);
    for (std::size_t k = 0; k < along.size(); ++k) {
      point(k == 0 ? plan::MoveKind::Linear : plan::MoveKind::Print, path.first + k);
      plan.position.emplace_back(along[k], 0.0, 1.0);
    }
    plan.paths.push_back(path);
  }

  std::vector<std::size_t> cuts() const {
    std::vector<std::size_t> waypoints; // at which the arm is when the tape is cut
    for (const plan::TrajectoryEvent& event : trajectory.events)
      if (event.kind == plan::EventKind::Cut)
        waypoints.push_back(trajectory.waypoint[event.point - 1]);
    return waypoints;
  }

private:
  void point(plan::MoveKind move, std::size_t waypoint) {
    plan::Trajectory& t = trajectory;
    t.dof = 1;
    t.joints.push_back(0.0);
    t.timeS.push_back(static_cast<double>(t.timeS.size()));
    t.move.push_back(move);
    t.waypoint.push_back(waypoint);
    t.extrudedMm3.push_back(0.0);
  }
};

TEST(TapeEvents, EveryTapeIsCutAheadOfItsEnd) {
  const process::Tooling tools = tooling();
  const double ahead = tools.at(1).process.tape->cutAheadMm;
  Motion motion;
  motion.add({0, 10, 20}, false);
  motion.add({0, 20, 60 - ahead, 50, 60}, true);
  motion.add({0, 20, 40}, false);
  motion.add({0, 40, 80 - ahead, 80}, true);
  motion.trajectory.events = {{.point = 12, .kind = plan::EventKind::Wait, .seconds = 1.0}};
  addCuts(motion.trajectory, motion.plan, tools);
  EXPECT_EQ(motion.cuts(), (std::vector<std::size_t>{5, 13}));
  EXPECT_EQ(motion.trajectory.events.size(), 3u);
  for (std::size_t e = 1; e < 3; ++e)
    EXPECT_LE(motion.trajectory.events[e - 1].point, motion.trajectory.events[e].point);
}

TEST(TapeEvents, AShortTapeIsCutAtItsBegin) {
  Motion motion;
  motion.add({0, 3, 5}, true); // a piece whose rest cannot be reached
  addCuts(motion.trajectory, motion.plan, tooling());
  EXPECT_EQ(motion.cuts(), std::vector<std::size_t>{0});
}

TEST(TapeEvents, BeadsAreNotCut) {
  Motion motion;
  motion.add({0, 100}, false);
  addCuts(motion.trajectory, motion.plan, tooling());
  EXPECT_TRUE(motion.trajectory.events.empty());
}

} // namespace
} // namespace voluta::motion
