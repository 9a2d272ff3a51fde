// A cell: robot, nozzle, platform and obstacles as a tree of bodies with a work frame and a tool
// frame (docs/design.md, The road). Planners use only work_T_tool; the cell encapsulates whether
// the nozzle or the plate moves (RoboFDM eq. 2.3: T_E^B = T_N^B T_O^N (T_O^P)^-1 (T_P^E)^-1).
//
// Work frame: origin at the centre of the platform's top, z out of it. For a rod: origin on its
// axis in the middle of its free length, x along it; the frame turns with it. Tool frame: origin at
// the nozzle's tip, z in the direction of extrusion (out of the nozzle, into the part): the build
// direction d of a waypoint is -z.
#pragma once

#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/arm.h"
#include "robot/cell/external_axis.h"
#include "robot/robot_model.h"
#include "robot/tool_change.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voluta::base {
class JsonNode;
}

namespace voluta::robot {

enum class Mount { World, Flange };

// The rod that a cell holds at both ends; its axis is the work frame's x.
struct CellRod {
  double diameterMm = 0.0, lengthMm = 0.0; // free length between its bearings, centred on x = 0
  double printableRadiusMm = 0.0;
};

class Cell {
public:
  // Reads a cell's file, whose keys are described in robot/cell/cell_reader.cpp. The head's solid
  // comes from the process. A cell without a rod has the platform's plate on its own stem; a cell
  // with a rod has the platform's rod, or its own if the platform has none. The platform's mesh is
  // not a body of the cell but the initial part of the growing part. Throws Error{UnreadableFile,
  // UnusableInput} naming file and key; Error{UnusableInput} also if the platform is a rod that
  // does not fit the cell's bearings or printable radius, or the cell has no rod.
  static Cell read(const std::filesystem::path& file, const process::Process& process,
                   platform::PlatformSolid platform);
  // Same from the text of a file, with the robot given. `name` replaces the file in errors.
  static Cell read(std::string_view text, const std::filesystem::path& name, RobotModel robot,
                   const process::Process& process, platform::PlatformSolid platform);
  // Same from the text of a file. Throws Error{UnreadableFile} if it is not JSON.
  static Cell readText(const std::string& text, const std::filesystem::path& file,
                       const process::Process& process, platform::PlatformSolid platform);

  const std::string& id() const { return id_; }
  const std::string& label() const { return label_; }
  // How it was laid out, for the person who sets it up
  const std::string& note() const { return note_; }
  // Id of the extruder (program/extruder.h).
  const std::string& extruder() const { return extruder_; }
  // The robot of the first arm. In a joint vector its joints come first; external axes follow.
  const RobotModel& robot() const { return arms_.front().robot; }
  // Mass on the flange before printing [kg]: the plate and its stem, or head and extruder; assumed
  // if the file does not state it.
  double carriedKg() const { return carriedKg_; }
  bool carriedIsAssumed() const { return carriedIsAssumed_; }
  // The robot's axes and the external ones
  int dof() const { return static_cast<int>(limits_.size()); }
  int armDof() const { return arms_.front().jointCount(); }
  // Their values follow the robot's own in a joint vector; ordered from the base to the platform.
  const std::vector<ExternalAxis>& externalAxes() const { return externalAxes_; }
  // The number of external axes that carry the robot; they come first.
  std::size_t axesUnderRobot() const { return axesUnderRobot_; }
  // Returns whether an external axis carries the platform.
  bool axesMovePlatform() const { return externalAxes_.size() > axesUnderRobot_; }
  // The controller's name of the mechanical unit of the axes that carry the platform; in a cell
  // without such axes, of those that carry the robot. Empty without external axes.
  const std::string& externalUnit() const { return externalUnit_; }
  // Same for the axes that carry the robot.
  const std::string& robotUnit() const { return robotUnit_; }
  const std::optional<CellRod>& rod() const { return rod_; }
  // The platforms that belong to the cell, as users write them, smallest first.
  const std::vector<std::string>& plates() const { return plates_; }
  Mount nozzleMount() const { return nozzleMount_; }

  // Frames for writing programs.
  // of the work frame (plate on the flange) or the tool frame
  const Eigen::Isometry3d& flange_T_moved() const;
  // Tool frame (fixed nozzle) or work frame with the external axes at zero, in the world frame,
  // with which the base then coincides.
  const Eigen::Isometry3d& base_T_fixed() const;
  // Returns the world in the base frame: the identity unless external axes carry the robot.
  Eigen::Isometry3d base_T_world(const JointVector& q) const;

  // The work frame in the moving frame of the last external axis; the identity without any.
  const Eigen::Isometry3d& axis_T_work() const { return axis_T_work_; }
  // Returns the frame of the last external axis' moving side as controllers define it, z along that
  // axis. Precondition: axesMovePlatform().
  Eigen::Isometry3d work_T_unit() const;

  // Forward kinematics: returns the pose of the nozzle in the work frame.
  Eigen::Isometry3d work_T_tool(const JointVector& q) const;
  Eigen::Isometry3d base_T_work(const JointVector& q) const;
  // Returns the flange pose that brings the nozzle to work_T_tool. Uses only the external axes of
  // q.
  Eigen::Isometry3d base_T_flange(const Eigen::Isometry3d& work_T_tool, const JointVector& q) const;
  // The inverse of base_T_flange.
  Eigen::Isometry3d work_T_toolOfFlange(const Eigen::Isometry3d& base_T_flange,
                                        const JointVector& q) const;
  // Computes all IK branches inside the joint limits, each joint as near to `near` as whole turns
  // allow; external axes keep their values in `near`. Replaces the content of `solutions`; reusing
  // the vector avoids allocations.
  void inverse(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
               std::vector<JointVector>& solutions) const;

  // As robot::nextBranch.
  std::optional<JointVector> next(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
                                  double maxRad) const;
  // Returns 1 or -1 if the nozzle is on the axis of the arm's last joint, so that rotating the tool
  // about its z by an angle is rotating that joint by the angle times this sign; otherwise 0.
  int lastJointTurnsNozzle() const { return lastJointTurnsNozzle_; }

  const std::vector<JointLimits>& limits() const { return limits_; } // one per axis (dof)
  // The arms at home, external axes at 0; dof() of them.
  JointVector home() const;
  // Returns whether the cell can orient the nozzle in more than one direction, by its arm or by a
  // turning external axis.
  bool tilts() const;
  const ToolChange& toolChange() const { return toolChange_; }
  // Where the nozzle's tip is to be when its tool is changed and it is purged, in the world [mm];
  // nullopt: the planner chooses the place. None with a fixed nozzle.
  const std::optional<Eigen::Vector3d>& purgePlaceMm() const { return purgePlaceMm_; }
  // Acceleration of the arm's joints in travels with its load [rad/s²]; of a sliding joint by
  // asAngle().
  double travelAcceleration() const { return travelAcceleration_; }

  // Bodies and their frames. Frame indices, n being the number of the robot's joints: 0 robot base
  // (= world if no external axis carries the robot), 1..n links, n + 1 flange, n + 2 work frame, n
  // + 3 tool frame, n + 4 and up the moving side of each external axis (of the last one that
  // carries the robot: the world).
  const std::vector<Body>& bodies() const { return bodies_; }
  int workFrame() const { return armDof() + 2; }
  int toolFrame() const { return armDof() + 3; }
  int axisFrame(std::size_t axis) const { return armDof() + 4 + static_cast<int>(axis); }
  int worldFrame() const { return axesUnderRobot_ > 0 ? axisFrame(axesUnderRobot_ - 1) : 0; }
  void framePoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_frame) const;
  // Pairs of bodies to check for collisions: all except those fixed to each other, neighbours along
  // the arm, and pairs listed in the cell's file as never meeting.
  const std::vector<std::pair<int, int>>& checkedPairs() const { return checkedPairs_; }
  // Bodies to check against the growing part (work frame): all that move relative to it.
  const std::vector<int>& bodiesAgainstPart() const { return bodiesAgainstPart_; }

private:
  class Reader;
  Cell() = default;
  // Returns the moved frame of the last of the first `count` external axes.
  Eigen::Isometry3d base_T_axis(std::size_t count, const JointVector& q) const;
  static Cell read(const base::JsonNode& top, const std::filesystem::path& file, RobotModel robot,
                   const process::Process& process, platform::PlatformSolid solid);
  std::string id_, label_, note_, extruder_ = "outputs";
  std::vector<Arm> arms_; // one or more once it is read
  Mount nozzleMount_ = Mount::World;
  Eigen::Isometry3d flange_T_moved_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d base_T_fixed_ = Eigen::Isometry3d::Identity();
  std::vector<ExternalAxis> externalAxes_;
  std::size_t axesUnderRobot_ = 0;
  std::string externalUnit_, robotUnit_;
  Eigen::Isometry3d axis_T_work_ = Eigen::Isometry3d::Identity();
  std::vector<JointLimits> limits_;
  std::optional<CellRod> rod_;
  std::vector<std::string> plates_;
  double travelAcceleration_ = 0.0, carriedKg_ = 0.0;
  bool carriedIsAssumed_ = true;
  int lastJointTurnsNozzle_ = 0;
  ToolChange toolChange_;
  std::optional<Eigen::Vector3d> purgePlaceMm_;
  std::vector<Body> bodies_;
  std::vector<std::pair<int, int>> checkedPairs_;
  std::vector<int> bodiesAgainstPart_;
};

std::vector<std::string> cellIds();
// `choice`: an id, or the text of a cell's file (base/data_files.h). Throws Error{Usage} for an
// unknown id, naming the nearest; as Cell::readText() for a text.
Cell loadCell(const std::string& choice, const process::Process& process,
              platform::PlatformSolid platform);
// Returns the text of a cell's file. If the robot is the user's own, its description is included,
// so that the text needs no other file. Throws Error{UnreadableFile, UnusableInput, Usage}.
std::string selfContainedCell(const std::filesystem::path& file);

// Returns the largest radius R [mm] such that for every point of a ball of radius R on the platform
// (centre at height R above it) the nozzle can be brought there, upright and tilted up to `tiltRad`
// to all sides. Deterministic sampling; the pattern is in the source file.
double reachableBallRadius(const Cell& cell, double tiltRad);

} // namespace voluta::robot
