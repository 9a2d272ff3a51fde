// One path of the tool plan in joints: a lazily checked ladder graph over the turn about the
// nozzle and the branches of the inverse kinematics (Dai 3.5.3). Where the cell turns a rod, it
// stands so that the nozzle points down in the base, or turned on from there in steps of 15 degrees
// where that does not do.
#pragma once

#include "base/units.h"
#include "motion/ladder.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "motion/run.h"

#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

struct PathTimes {
  double ik = 0.0, graph = 0.0, collision = 0.0; // wall seconds
};

class PathPlanner {
public:
  explicit PathPlanner(const MotionScene& scene) : scene_(scene) {}

  // Plans waypoints [first, first + count) of path `path`, none of which the head refuses, to
  // follow on `from`. Appends the runs that are printed (usually one) and the waypoints that are
  // not. Each run's first waypoint is the last one's of the run before where no waypoint lies
  // between them. The same for any number of threads.
  void plan(std::size_t path, std::size_t first, std::size_t count, const RobotState& from,
            const base::RunContext& ctx, std::vector<Run>& runs, std::vector<Refused>& refused);

  const PathTimes& times() const { return times_; }

private:
  static constexpr double kRodStep =
      base::degreesToRadians(15.0); // of its angle from the upright one

  struct Place { // a rung: its waypoint and what is known of its nodes
    std::size_t waypoint;
    bool judged = false;  // all nodes were checked for collisions
    bool widened = false; // has nodes for other angles of the rod too
    bool lifted = false;  // nodes from which the arm cannot lift the nozzle were blocked
    std::vector<std::size_t> unliftable;      // those nodes
    std::vector<collision::Contact> contacts; // why nodes are blocked, where by collision
  };
  struct Ladder {
    std::vector<Place> places;
    std::vector<Rung> rungs;
    LadderOptions options;
  };

  struct Course {             // at every waypoint from the first rung's on, rad
    std::vector<double> turn; // about the nozzle, from tools_
    std::vector<double> rod;  // from rod_
  };

  LadderWay bestWay(Ladder& ladder, const RobotState& from) const;
  // Fills tools_ and rod_. Returns how many of the waypoints the rod can follow without leaving its
  // limits.
  std::size_t carryTools(std::size_t first, std::size_t count, const RobotState& from);
  double rodAt(std::size_t waypoint) const {
    return rod_.empty() ? 0.0 : rod_[waypoint - toolsFirst_];
  }
  Eigen::Vector3d inBase(const Eigen::Vector3d& v, std::size_t waypoint) const;
  void addNodes(const Place& place, Rung& rung, const std::vector<int>& rodSteps,
                const RobotState& from) const;
  std::vector<std::size_t> rungWaypoints(std::size_t first, std::size_t count) const;
  void addNodes(Ladder& ladder, const std::vector<std::size_t>& rungs, const RobotState& from,
                const base::RunContext& ctx);
  // Adds nodes for other angles of the rod about a rung, checked for collisions. False: they were
  // there already, or there is no rod.
  bool widen(Ladder& ladder, std::size_t rung, const RobotState& from, const base::RunContext& ctx);
  void judge(Ladder& ladder, const std::vector<std::size_t>& rungs, const base::RunContext& ctx);
  Course courseOf(const Ladder& ladder, const LadderWay& way) const;
  bool fill(std::size_t first, const Course& course, const robot::JointVector& start,
            std::vector<RunPoint>& points, std::size_t& failedAt) const;
  std::vector<std::size_t> failures(const std::vector<RunPoint>& points,
                                    const base::RunContext& ctx) const;
  // Why all of a rung's nodes are of no use.
  static Refused refusal(const Place& place, const Rung& rung);
  // Refuses the first rung's waypoint and those up to the last rung that has no node of use either,
  // whatever the rod's angle; returns how many. On a rod the arm stands nearly still between rungs.
  std::size_t refuseBlocked(Ladder& ladder, const RobotState& from, const base::RunContext& ctx,
                            std::vector<Refused>& refused);
  // Can the arm lift the nozzle from there, far enough for a transfer?
  bool liftable(const RobotState& state, std::size_t before) const;
  // Blocks the nodes of a path's first or last rung from which it cannot.
  void blockUnliftable(Ladder& ladder, std::size_t rung, std::size_t before,
                       const base::RunContext& ctx);
  std::optional<collision::Contact> contactAt(const robot::JointVector& q,
                                              std::size_t waypoint) const;
  // Plans as many of the waypoints as can be joined; returns how many it dealt with (>= 1).
  std::size_t planPrefix(std::size_t path, std::size_t first, std::size_t count,
                         const RobotState& from, const base::RunContext& ctx,
                         std::vector<Run>& runs, std::vector<Refused>& refused);

  const MotionScene& scene_;
  PathTimes times_;
  std::vector<Eigen::Quaterniond> tools_; // of the stretch in work, before any turn
  std::vector<double> rod_; // of the stretch, the rod's angle with the nozzle down; empty: no rod
  std::size_t toolsFirst_ = 0;
};

} // namespace voluta::motion
