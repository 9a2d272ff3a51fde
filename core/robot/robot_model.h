// A robot: a JSON file of numbers and a kinematic family with closed-form inverse kinematics. Each
// family's file names the sources of its kinematics and check values.
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

// Joint values [rad] ([mm] for sliding joints); external axes follow the robot's own joints.
using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 8, 1>;

// [rad] and [s]; [mm] for a sliding joint.
struct JointLimits {
  double min, max;
  double velocity;
  double acceleration; // Assumed if the maker publishes none
  JointKind kind = JointKind::Turning;
};

std::vector<JointKind> kindsOf(const std::vector<JointLimits>& limits);
// Returns the steps of joints as rotations [rad] (see asAngle): as many as there are limits, or all
// if there are fewer.
JointVector asAngles(const JointVector& step, const std::vector<JointLimits>& limits);
// Returns the maximum of their absolute values.
double largestRotation(const JointVector& step, const std::vector<JointLimits>& limits);

// Angle [rad] between the axes of flange and base up to which the flange of an arm that cannot tilt
// counts as upright.
inline constexpr double kUprightFlangeRad = 1e-6;

// Closed-form kinematics of one family (UR, ortho-parallel, ...). Stateless after construction.
class Kinematics {
public:
  virtual ~Kinematics() = default;
  virtual int dof() const = 0;
  virtual JointKind kindOf(int /*joint*/) const { return JointKind::Turning; }
  // Returns whether the arm can tilt the flange. If not, the flange's z is the base's in every
  // pose.
  virtual bool tilts() const { return true; }
  // Computes the poses of the links' frames, base first, flange last: dof() + 2 entries (base, link
  // 1 ... link dof, flange), in the controller's base frame.
  virtual void linkPoses(const JointVector& q,
                         std::vector<Eigen::Isometry3d>& base_T_link) const = 0;
  virtual Eigen::Isometry3d flange(const JointVector& q) const = 0; // Returns base_T_flange
  // Appends every IK branch that reaches base_T_flange, each turning joint in (-pi, pi], regardless
  // of limits. Appends nothing if the pose is out of reach. At a singular pose the free joint is
  // set to zero.
  virtual void inverse(const Eigen::Isometry3d& base_T_flange,
                       std::vector<JointVector>& solutions) const = 0;
  // Returns whether inverse() takes microseconds; otherwise it takes about a thousand times as
  // long.
  virtual bool isFast() const { return true; }
  // Computes the IK branch that continues from q, by Newton steps from q to the flange pose; as
  // cheap as a fast inverse. Returns false and leaves q unchanged if the steps do not converge, or
  // if this arm does not need them. Joints may leave (-pi, pi].
  virtual bool solveNear(const Eigen::Isometry3d& /*base_T_flange*/, JointVector& /*q*/) const {
    return false;
  }
};

// RobotModel::controllerModel of ABB controllers with RobotWare 7.
inline constexpr std::string_view kOmniCore = "omnicore";

struct RobotModel {
  std::string id, label, maker, controller; // controller: id of its program format
  std::string controllerModel;              // If programs depend on it: kOmniCore; else empty
  std::shared_ptr<const Kinematics> kinematics;
  std::vector<JointLimits> limits;
  std::vector<Body> links; // Frame: 0 base, 1..dof links (index into linkPoses)
  // Pairs of links (indices into `links`) that need no collision check although they are not
  // adjacent: their joints keep them apart, or only their enclosing shapes overlap. The file states
  // the reason for each.
  std::vector<std::pair<int, int>> neverMeet;
  std::optional<double> payloadKg;  // At the flange, as rated by the maker
  std::vector<std::string> assumed; // Data without a published source; shown to the user

  int dof() const { return kinematics->dof(); }
};

// Reads a robot file; robot/cell/robot_reader.cpp describes its keys. Throws Error{UnreadableFile,
// UnusableInput} naming file and key.
RobotModel readRobot(const std::filesystem::path& file);
std::vector<std::string> robotIds();
// Throws Error{Usage} for an unknown id, naming the nearest.
RobotModel loadRobot(const std::string& id);

// Computes all solutions of inverse() within the limits: of each IK branch the representative (by
// whole turns of each joint) that is nearest to `near` and inside the limits; branches without one
// are omitted. Overwrites `solutions`; its memory is reused, so that repeated calls do not
// allocate. `near` may have more joints than the robot. Sliding joints are not changed by turns.
void inverseNear(const RobotModel& robot, const Eigen::Isometry3d& base_T_flange,
                 const JointVector& near, std::vector<JointVector>& solutions);

// The second half of inverseNear: replaces branches in (-pi, pi] by their representatives near
// `near`, and drops those outside the limits.
void keepWithinLimits(const RobotModel& robot, const JointVector& near,
                      std::vector<JointVector>& solutions);

// For arms without a fast inverse: returns the branch that continues from `near` (only the robot's
// joints are read), with no joint turning by more than `maxRad` and all within their limits.
// Returns nullopt if there is none, or if inverseNear is as fast: use that instead.
std::optional<JointVector> nextBranch(const RobotModel& robot,
                                      const Eigen::Isometry3d& base_T_flange,
                                      const JointVector& near, double maxRad);

} // namespace voluta::robot
