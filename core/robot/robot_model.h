// A robot: a JSON file of numbers and a kinematic family that knows closed-form inverses.
// Sources: references on kinematics and check values are named in each family's file.
#pragma once

#include "robot/body.h"
#include "robot/kinematics/joint_kind.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::robot {

// Joint values, radians (mm for sliding joints); external axes follow the robot's own.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 8, 1>;

// rad and seconds; mm of a sliding joint.
struct JointLimits {
  double min, max;
  double velocity;
  double acceleration; // assumed where the maker publishes none
  JointKind kind = JointKind::Turning;
};

std::vector<JointKind> kindsOf(const std::vector<JointLimits>& limits);
// The steps of joints as turns, rad (asTurn): as many as there are limits, or all of fewer.
JointVector asTurns(const JointVector& step, const std::vector<JointLimits>& limits);
// The largest of them, 0 or more.
double largestTurn(const JointVector& step, const std::vector<JointLimits>& limits);

// A flange's axis nearer to the base's than this is upright to an arm that cannot tilt it, rad.
inline constexpr double kUprightFlangeRad = 1e-6;

// Closed-form kinematics of one family (UR, ortho-parallel, ...). Stateless after construction.
class Kinematics {
public:
  virtual ~Kinematics() = default;
  virtual int dof() const = 0;
  virtual JointKind kindOf(int /*joint*/) const { return JointKind::Turning; }
  // Can it tilt the flange? Else the flange's z is the base's in every pose that it has.
  virtual bool tilts() const { return true; }
  // Poses of the links' frames, base first, flange last: dof() + 2 entries
  // (base, link 1 ... link dof, flange), in the controller's base frame.
  virtual void linkPoses(const JointVector& q,
                         std::vector<Eigen::Isometry3d>& base_T_link) const = 0;
  virtual Eigen::Isometry3d flange(const JointVector& q) const = 0; // base_T_flange
  // Appends every branch that reaches base_T_flange, each turning joint in (-pi, pi], without
  // regard to limits. Nothing is appended where the pose is out of reach. At a singular pose the
  // free joint is taken as zero.
  virtual void inverse(const Eigen::Isometry3d& base_T_flange,
                       std::vector<JointVector>& solutions) const = 0;
  // Does inverse() take microseconds? Else one that takes a thousand times as long.
  virtual bool isFast() const { return true; }
  // Newton's steps from q to where the flange is as wanted: the branch that goes on from q, which
  // costs as little as a fast inverse. False, and q is as it was: they do not come there, or this
  // arm has no need of them. Joints may have left (-pi, pi].
  virtual bool solveNear(const Eigen::Isometry3d& /*base_T_flange*/, JointVector& /*q*/) const {
    return false;
  }
};

// RobotModel::controllerModel of ABB's controllers with RobotWare 7.
inline constexpr std::string_view kOmniCore = "omnicore";

struct RobotModel {
  std::string id, label, maker, controller; // controller: id of its program format
  std::string controllerModel;              // where programs differ by it: kOmniCore; else empty
  std::shared_ptr<const Kinematics> kinematics;
  std::vector<JointLimits> limits;
  std::vector<Body> links; // frame: 0 base, 1..dof links (index into linkPoses)
  // Pairs of links (indices into `links`) that need no check though they are no neighbours: their
  // joints keep them apart, or only their enclosing shapes overlap. Each has its reason in the
  // file.
  std::vector<std::pair<int, int>> neverMeet;
  std::optional<double> payloadKg;  // at the flange, as the maker rates it
  std::vector<std::string> assumed; // what is not from a published source, said where shown

  int dof() const { return kinematics->dof(); }
};

// The file's keys are described in robot/cell/robot_reader.cpp.
// Throws Error{UnreadableFile, UnusableInput} naming file and key.
RobotModel readRobot(const std::filesystem::path& file);
std::vector<std::string> robotIds();
// Throws Error{Usage} for an unknown id, naming the nearest.
RobotModel loadRobot(const std::string& id);

// All solutions of inverse() as joints can be turned by whole turns within the limits: for each
// branch the representative nearest to `near` (each joint separately) that is inside the limits;
// branches with none are left out. What `solutions` held before is dropped; its memory is kept, so
// that a vector used again allocates nothing. `near` may be longer than the robot's dof. What
// slides stays where it is.
void inverseNear(const RobotModel& robot, const Eigen::Isometry3d& base_T_flange,
                 const JointVector& near, std::vector<JointVector>& solutions);

// The second half of inverseNear: branches in (-pi, pi] become representatives near `near`, those
// outside the limits are dropped.
void keepWithinLimits(const RobotModel& robot, const JointVector& near,
                      std::vector<JointVector>& solutions);

// Where the arm's inverse is not fast: the branch that goes on from `near` (at least the robot's
// joints; only they are read), none of its joints turning further than `mostRad` and all within
// their limits. Nothing where there is none, or where inverseNear is as good: ask that.
std::optional<JointVector> nextBranch(const RobotModel& robot,
                                      const Eigen::Isometry3d& base_T_flange,
                                      const JointVector& near, double mostRad);

} // namespace voluta::robot
