// A cell: robot, nozzle, platform, obstacles as a tree of bodies with a work frame and a tool
// frame (docs/design.md, The road). Planners know only work_T_tool; whether the nozzle or the plate
// moves is the cell's own affair (RoboFDM eq. 2.3: T_E^B = T_N^B T_O^N (T_O^P)^-1 (T_P^E)^-1).
//
// Work frame: origin at the centre of the platform's top, z out of it; of a rod: origin on its axis
// in the middle of its free length, x along it, and the frame turns with it.
// Tool frame: origin at the nozzle's tip, z in the direction of extrusion (out of the nozzle, into
// the part): the build direction d of a waypoint is -z.
#pragma once

#include "platform/platform_solid.h"
#include "process/process.h"
#include "robot/arm.h"
#include "robot/cell/external_axis.h"
#include "robot/robot_model.h"

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

// The rod that a cell holds at both ends, its axis on the work frame's x.
struct CellRod {
  double diameterMm = 0.0, lengthMm = 0.0; // free between its bearings, its middle at x = 0
  double printableRadiusMm = 0.0;
};

class Cell {
public:
  // The file's keys are described in robot/cell/cell_reader.cpp.
  // Throws Error{UnreadableFile, UnusableInput} naming file and key. The head's solid comes from
  // the process. A cell without a rod has the platform's plate on its own stem; a cell with one has
  // the platform's rod, or its own where the platform has none. Throws Error{UnusableInput} where
  // the platform is a rod and the cell has none, or one that is shorter or has no room for it. The
  // platform's mesh is no body of the cell: it is the first of the growing part.
  static Cell read(const std::filesystem::path& file, const process::Process& process,
                   platform::PlatformSolid platform);
  // The same from the text of a file, which `name` stands for in errors and whose robot is given.
  static Cell read(std::string_view text, const std::filesystem::path& name, RobotModel robot,
                   const process::Process& process, platform::PlatformSolid platform);
  // The same of what such a file would hold. Throws Error{UnreadableFile} where it is no JSON.
  static Cell readText(const std::string& text, const std::filesystem::path& file,
                       const process::Process& process, platform::PlatformSolid platform);

  const std::string& id() const { return id_; }
  const std::string& label() const { return label_; }
  const std::string& note() const { return note_; } // how it was laid out, for who sets it up
  // Id of what turns the filament (program/extruder.h).
  const std::string& extruder() const { return extruder_; }
  // One arm for now. In a joint vector their joints come first, arm by arm; external axes follow.
  const std::vector<Arm>& arms() const { return arms_; }
  // Precondition: i < arms().size().
  const Arm& arm(std::size_t i) const;
  // Of arm(0).
  const RobotModel& robot() const { return arms_.front().robot; }
  // What the flange carries before anything is printed: the plate and its stem, or head and
  // extruder. kg; assumed where the file does not say.
  double carriedKg() const { return carriedKg_; }
  bool carriedIsAssumed() const { return carriedIsAssumed_; }
  int dof() const { return static_cast<int>(limits_.size()); } // the robot's and external axes
  int armDof() const { return arms_.front().jointCount(); }    // of arm(0)
  // In a joint vector they follow the robot's own; from the base to the platform.
  const std::vector<ExternalAxis>& externalAxes() const { return externalAxes_; }
  // How many of them carry the robot: the first ones.
  std::size_t axesUnderRobot() const { return axesUnderRobot_; }
  // Does an external axis carry the platform?
  bool axesMovePlatform() const { return externalAxes_.size() > axesUnderRobot_; }
  // What controllers call the mechanical unit that those which carry the platform are, together; of
  // a cell without such ones, those that carry the robot. Empty without any.
  const std::string& externalUnit() const { return externalUnit_; }
  // The same of those that carry the robot.
  const std::string& robotUnit() const { return robotUnit_; }
  const std::optional<CellRod>& rod() const { return rod_; }
  // What platforms it comes with, as a user writes them, the smallest first.
  const std::vector<std::string>& plates() const { return plates_; }
  Mount nozzleMount() const { return nozzleMount_; }

  // What a program needs to say where things are.
  const Eigen::Isometry3d& flange_T_moved() const; // work frame (plate on the flange) or tool frame
  // Tool frame (fixed nozzle) or work frame with the external axes at zero: in the world, which is
  // where the base then is.
  const Eigen::Isometry3d& base_T_fixed() const;
  // The world as the base sees it: the identity unless external axes carry the robot.
  Eigen::Isometry3d base_T_world(const JointVector& q) const;

  // The work frame in that of the last external axis, which goes with it; identity without any.
  const Eigen::Isometry3d& axis_T_work() const { return axis_T_work_; }
  // The frame of what the last external axis moves as controllers have it, z along that axis.
  // Precondition: axesMovePlatform().
  Eigen::Isometry3d work_T_unit() const;

  // Forward: pose of the nozzle in the work frame.
  Eigen::Isometry3d work_T_tool(const JointVector& q) const;
  Eigen::Isometry3d base_T_work(const JointVector& q) const;
  // The flange pose that brings the nozzle to work_T_tool. Of q only the external axes are read.
  Eigen::Isometry3d base_T_flange(const Eigen::Isometry3d& work_T_tool, const JointVector& q) const;
  // The inverse of base_T_flange.
  Eigen::Isometry3d work_T_toolOfFlange(const Eigen::Isometry3d& base_T_flange,
                                        const JointVector& q) const;
  // All branches inside the joint limits, each joint as near to `near` as whole turns allow;
  // external axes stay where `near` has them. Replaces what `solutions` held; a vector used again
  // allocates nothing.
  void inverse(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
               std::vector<JointVector>& solutions) const;

  // As robot::nextBranch.
  std::optional<JointVector> next(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
                                  double mostRad) const;
  // 1 or -1 where the nozzle stands on the axis of the arm's last joint: turning the tool about its
  // z by an angle is turning that joint by it, or back. 0: it stands elsewhere.
  int lastJointTurnsNozzle() const { return lastJointTurnsNozzle_; }

  const std::vector<JointLimits>& limits() const { return limits_; } // dof() of them
  // The arms at home, external axes at 0; dof() of them.
  JointVector home() const;
  // Can it bring the nozzle to other directions than one? By its arm, or by what its axes turn.
  bool tilts() const;
  // Of the arm's joints in travels with what it carries, rad/s2; a sliding one's by asTurn().
  double travelAcceleration() const { return travelAcceleration_; }

  // Bodies and their frames. Frame indices, n the robot's own joints: 0 robot base (= world where
  // no external axis carries the robot), 1..n links, n + 1 flange, n + 2 work frame, n + 3 tool
  // frame, n + 4 on what each external axis moves (the last that carries the robot: the world).
  const std::vector<Body>& bodies() const { return bodies_; }
  int workFrame() const { return armDof() + 2; }
  int toolFrame() const { return armDof() + 3; }
  int axisFrame(std::size_t axis) const { return armDof() + 4 + static_cast<int>(axis); }
  int worldFrame() const { return axesUnderRobot_ > 0 ? axisFrame(axesUnderRobot_ - 1) : 0; }
  void framePoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_frame) const;
  // Pairs of bodies that may collide and are to be checked: all but those fixed to each other,
  // neighbours along the arm, and pairs that the cell's file lists as never meeting.
  const std::vector<std::pair<int, int>>& checkedPairs() const { return checkedPairs_; }
  // Bodies to be checked against the growing part (work frame): all that move relative to it.
  const std::vector<int>& bodiesAgainstPart() const { return bodiesAgainstPart_; }

private:
  class Reader;
  Cell() = default;
  // The frame of the last of the first `count` external axes, moved by them.
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
  std::vector<Body> bodies_;
  std::vector<std::pair<int, int>> checkedPairs_;
  std::vector<int> bodiesAgainstPart_;
};

std::vector<std::string> cellIds();
// `choice`: an id, or the text of a cell's file (base/data_files.h). Throws Error{Usage} for an
// unknown id, naming the nearest; as Cell::readText() for a text.
Cell loadCell(const std::string& choice, const process::Process& process,
              platform::PlatformSolid platform);
// Returns the text of a cell's file with the whole robot in it where the robot is the user's own,
// so that the text needs no other file. Throws Error{UnreadableFile, UnusableInput, Usage}.
std::string selfContainedCell(const std::filesystem::path& file);

// The largest radius R such that for every point of a ball of radius R standing on the platform
// (centre at height R above it) the nozzle can be brought there, upright and tilted up to
// `tiltRad` to all sides. mm. Deterministic sampling; the pattern is stated in the source file.
double reachableBallRadius(const Cell& cell, double tiltRad);

} // namespace voluta::robot
