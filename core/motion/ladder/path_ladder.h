// The ladder graph over a stretch of a path: rungs at some of its waypoints, nodes for the turns
// about the nozzle and the branches of the inverse kinematics, looked at for collisions only where
// a way would use them (Dai 3.5.3). The cell's external axes go as they are to before (a rod so
// that the nozzle points down in the base, others as in axis_schedule.h), or with the last one
// turned on from there in steps of 15 degrees where that does not do.
#pragma once

#include "base/run_context.h"
#include "motion/ladder/ladder.h"
#include "motion/motion_scene.h"
#include "motion/refusal.h"
#include "motion/run.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::motion {

struct PathTimes {
  double ik = 0.0, graph = 0.0, jerk = 0.0, collision = 0.0; // wall seconds
};

// The largest joint step, rad, between rungs that are some waypoints apart.
inline constexpr double kRungStepRad = 0.9;

// At every waypoint from the first rung's on, rad.
struct Course {
  std::vector<double> turn;  // about the nozzle, from the tool's orientation without any
  std::vector<double> aside; // of the last external axis, from where it stands by itself
};

// All that takes part is referenced and outlives it. The same for any number of threads.
class PathLadder {
public:
  // Over waypoints [first, first + count), to follow on `from`; without rungs as yet.
  PathLadder(const MotionScene& scene, std::size_t first, std::size_t count, const RobotState& from,
             const base::RunContext& ctx, PathTimes& times);

  // How many of the waypoints the external axes can follow without leaving their limits.
  std::size_t followed() const { return followed_; }
  bool movesPart() const { return !axes_.empty(); }
  std::size_t size() const { return places_.size(); }
  std::size_t waypointOf(std::size_t rung) const { return places_[rung].waypoint; }
  // The rung at a waypoint, or the first one behind it.
  std::size_t rungAt(std::size_t waypoint) const;
  LadderNode& node(std::size_t rung, int index) {
    return rungs_[rung][static_cast<std::size_t>(index)];
  }
  // The tool's orientation in work before any turn about the nozzle, and where the external axes
  // are by themselves, with the last one by so much aside (none without any).
  const Eigen::Quaterniond& toolAt(std::size_t waypoint) const { return tools_[waypoint - first_]; }
  robot::JointVector axesAt(std::size_t waypoint, double aside = 0.0) const;

  // Rungs over the stretch's first `count` waypoints, as often as its way and turns ask for. What
  // is known of those that are there already stays.
  void setRungs(std::size_t count, const base::RunContext& ctx);
  // Keeps those up to a rung, and it.
  void keepUpTo(std::size_t rung, const base::RunContext& ctx);
  // Makes every waypoint between rungs r - 1 and r a rung. False: they were neighbours already.
  bool refine(std::size_t rung, const base::RunContext& ctx);
  // Adds nodes for other angles of the last external axis about a rung, checked for collisions.
  // False: they were there already, or there is none.
  bool widen(std::size_t rung, const base::RunContext& ctx);
  // Blocks nodes in which something collides, each rung once.
  void judge(const std::vector<std::size_t>& rungs, const base::RunContext& ctx);

  // Joins no nodes of this rung and the one before that are on different sides of the arm's
  // singular poses.
  void keepJacobianSigns(std::size_t rung);

  // Of two ways to begin, by whole turns: near where the arm is, which may wind it up against its
  // limits, and near home. The one that gets further, then the cheaper one.
  LadderWay bestWay(const base::RunContext& ctx) const;
  // Linear in the way between rungs.
  Course courseOf(const LadderWay& way) const;

  // Can the arm lift the nozzle from there, far enough for a transfer?
  bool liftable(const RobotState& state, std::size_t before) const;
  // Blocks the nodes of a rung from which it cannot; was that done?
  bool wasLifted(std::size_t rung) const { return places_[rung].lifted; }
  void blockUnliftable(std::size_t rung, std::size_t before, const base::RunContext& ctx);
  // Takes that back. False: there were none.
  bool allowUnliftable();

  std::optional<collision::Contact> contactAt(const robot::JointVector& q,
                                              std::size_t waypoint) const;
  // Where the way comes nearer to something than options.enoughMm, all nodes of that rung cost the
  // more the nearer they come. False: that was known all along the way, or is not asked for.
  bool seekClearance(const LadderWay& way, const base::RunContext& ctx);
  // Why all nodes of a rung are of no use.
  Refused refusalOf(std::size_t rung) const;
  // Refuses the first rung's waypoint and those up to the last rung that has no node of use either,
  // whatever the last external axis' angle; returns how many. On a rod the arm stands nearly still
  // between rungs.
  std::size_t refuseBlocked(const base::RunContext& ctx, std::vector<Refused>& refused);

private:
  struct Place { // a rung: its waypoint and what is known of its nodes
    std::size_t waypoint;
    bool judged = false;  // all nodes were checked for collisions
    bool widened = false; // has nodes with the last external axis aside too
    bool cleared = false; // nodes cost what their clearance asks for
    int clearNode = -1;   // one that was found to stay clear of all
    bool sided = false;   // nodes know their side of singular poses
    bool lifted = false;  // nodes from which the arm cannot lift the nozzle were blocked
    std::vector<std::size_t> unliftable = {};      // those nodes
    std::vector<collision::Contact> contacts = {}; // why nodes are blocked, where by collision
  };

  std::size_t carryTools(std::size_t count, const base::RunContext& ctx);
  // As the external axes have them.
  Eigen::Vector3d pointAt(std::size_t waypoint) const;
  Eigen::Vector3d directionAt(std::size_t waypoint) const;
  bool canStandAside() const;
  std::vector<std::size_t> rungWaypoints(std::size_t count) const;
  // The first rung's nodes by the whole turns nearest to such joints, where limits allow it.
  std::vector<LadderStart> startsNear(const robot::JointVector& near,
                                      std::vector<LadderStart> starts) const;
  void setPlaces(const std::vector<std::size_t>& waypoints, const base::RunContext& ctx);
  // How far everything is then, mm, at most options.enoughMm. `nearest`: as of
  // CellCollision::clearance.
  double clearanceAt(const robot::JointVector& q, std::size_t waypoint, std::size_t& nearest) const;
  void look(LadderNode& node, Place& place) const;
  void computeJacobianSigns(std::size_t rung);
  void addNodes(const Place& place, Rung& rung, const std::vector<int>& asides) const;

  const MotionScene& scene_;
  PathTimes& times_;
  std::size_t first_;
  RobotState from_;
  std::vector<Eigen::Quaterniond> tools_;
  std::vector<robot::JointVector> axes_; // empty: there are none
  std::size_t followed_ = 0;
  std::vector<Place> places_;
  std::vector<Rung> rungs_;
  LadderOptions options_;
};

} // namespace voluta::motion
