// The ladder graph over a stretch of a path: rungs at some of its waypoints, with nodes for the
// rotations about the nozzle and the IK branches. Nodes are checked for collisions only where a
// path would use them (Dai 3.5.3). The cell's external axes follow their schedule (a rod so that
// the nozzle points down in the base, others as in axis_schedule.h); where that fails, the last one
// may deviate from it in steps of 15 degrees.
#pragma once

#include "base/run_context.h"
#include "motion/bead_run.h"
#include "motion/ladder/ladder.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::motion {

struct PathTimes {
  double ik = 0.0, graph = 0.0, jerk = 0.0, collision = 0.0; // Wall time [s]
};

// Maximum joint step [rad] between rungs that are several waypoints apart.
inline constexpr double kRungStepRad = 0.9;

// At every waypoint from the first rung's on [rad].
struct Course {
  // Rotation about the nozzle, relative to the tool's orientation without rotation
  std::vector<double> rotation;
  std::vector<double> offset; // Offset of the last external axis from its schedule
};

// The arguments are referenced and must outlive this object. Results are independent of the number
// of threads.
class PathLadder {
public:
  // Covers waypoints [first, first + count), continuing from `from`; initially without rungs.
  PathLadder(const MotionScene& scene, std::size_t first, std::size_t count, const RobotState& from,
             const base::RunContext& ctx, PathTimes& times);

  // Returns how many of the waypoints the external axes can follow within their limits.
  std::size_t followed() const { return followed_; }
  bool movesPart() const { return !axes_.empty(); }
  std::size_t size() const { return places_.size(); }
  std::size_t waypointOf(std::size_t rung) const { return places_[rung].waypoint; }
  // Returns the rung at a waypoint, or the first one after it.
  std::size_t rungAt(std::size_t waypoint) const;
  LadderNode& node(std::size_t rung, int index) {
    return rungs_[rung][static_cast<std::size_t>(index)];
  }
  // Return the tool's orientation in the work frame before any rotation about the nozzle, and the
  // scheduled external axes with the last one offset by `offset` (empty if there are none).
  const Eigen::Quaterniond& toolAt(std::size_t waypoint) const { return tools_[waypoint - first_]; }
  robot::JointVector axesAt(std::size_t waypoint, double offset = 0.0) const;

  // Sets rungs over the stretch's first `count` waypoints, as densely as distance and rotation
  // require. Existing rungs keep their state.
  void setRungs(std::size_t count, const base::RunContext& ctx);
  // Keeps the rungs up to and including `rung`.
  void keepUpTo(std::size_t rung, const base::RunContext& ctx);
  // Makes every waypoint between rungs r - 1 and r a rung. Returns false if they were adjacent
  // waypoints already.
  bool refine(std::size_t rung, const base::RunContext& ctx);
  // Adds nodes for other angles of the last external axis to the rungs around `rung`, and checks
  // them for collisions. Returns false if they existed already or there is no such axis.
  bool widen(std::size_t rung, const base::RunContext& ctx);
  // Blocks the nodes with collisions; checks each rung only once.
  void judge(const std::vector<std::size_t>& rungs, const base::RunContext& ctx);

  // Prevents connections between nodes of this rung and the previous one that are on different
  // sides of the arm's singular poses.
  void keepJacobianSigns(std::size_t rung);

  // Compares two ways of choosing the whole turns of the start: near the arm's present joints,
  // which may wind it up against its limits, and near home. Returns the path that gets further, of
  // equals the cheaper one.
  LadderPath bestPath(const base::RunContext& ctx) const;
  // Returns rotation and offset at every waypoint: linear between rungs.
  Course courseOf(const LadderPath& path) const;

  // Returns whether the arm can lift the nozzle from there, far enough for a transfer.
  bool liftable(const RobotState& state, std::size_t before) const;
  // Blocks the nodes of a rung from which it cannot; wasLifted() returns whether that was done.
  bool wasLifted(std::size_t rung) const { return places_[rung].lifted; }
  void blockUnliftable(std::size_t rung, std::size_t before, const base::RunContext& ctx);
  // Unblocks those nodes. Returns false if there are none.
  bool allowUnliftable();

  std::optional<collision::Contact> contactAt(const robot::JointVector& q,
                                              std::size_t waypoint) const;
  // Where the path is nearer to an obstacle than options.enoughMm, increases the cost of all nodes
  // of that rung with their proximity. Returns false if this was already done along the whole path,
  // or is not enabled.
  bool seekClearance(const LadderPath& path, const base::RunContext& ctx);
  // Returns why all nodes of a rung are unusable.
  Refused refusalOf(std::size_t rung) const;
  // Refuses the first rung's waypoint and all waypoints up to the last consecutive rung without a
  // usable node for any angle of the last external axis; returns their number. On a rod the arm
  // hardly moves between rungs.
  std::size_t refuseBlocked(const base::RunContext& ctx, std::vector<Refused>& refused);

private:
  struct Place { // The waypoint of a rung and the state of its nodes
    std::size_t waypoint;
    bool judged = false;  // All nodes have been checked for collisions
    bool widened = false; // Has nodes with the last external axis offset
    bool cleared = false; // The cost of the nodes includes their clearance
    int clearNode = -1;   // A node that was found to have enough clearance
    bool sided = false;   // The nodes' side of singular poses has been computed
    bool lifted = false;  // Nodes from which the arm cannot lift the nozzle have been blocked
    std::vector<std::size_t> unliftable = {};      // Those nodes
    std::vector<collision::Contact> contacts = {}; // Collisions of the blocked nodes
  };

  std::size_t carryTools(std::size_t count, const base::RunContext& ctx);
  // As moved by the external axes.
  Eigen::Vector3d pointAt(std::size_t waypoint) const;
  Eigen::Vector3d directionAt(std::size_t waypoint) const;
  bool canOffset() const;
  std::vector<std::size_t> rungWaypoints(std::size_t count) const;
  // Moves the first rung's nodes to the whole turns nearest to these joints, where limits allow it.
  std::vector<LadderStart> startsNear(const robot::JointVector& near,
                                      std::vector<LadderStart> starts) const;
  void setPlaces(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx);
  // Returns the clearance [mm], at most options.enoughMm. `nearest`: as in
  // CellCollision::clearance.
  double clearanceAt(const robot::JointVector& q, std::size_t waypoint, std::size_t& nearest) const;
  void look(LadderNode& node, Place& place) const;
  void computeJacobianSigns(std::size_t rung);
  void addNodes(const Place& place, Rung& rung, const std::vector<int>& offsets) const;

  const MotionScene& scene_;
  PathTimes& times_;
  std::size_t first_;
  RobotState from_;
  std::vector<Eigen::Quaterniond> tools_;
  std::vector<robot::JointVector> axes_; // Empty: none
  std::size_t followed_ = 0;
  std::vector<Place> places_;
  std::vector<Rung> rungs_;
  LadderOptions options_;
};

} // namespace voluta::motion
