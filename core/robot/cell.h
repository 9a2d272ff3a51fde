// A cell: robot, nozzle, platform, obstacles as a tree of bodies with a work frame and a tool
// frame (DESIGN §3). Planners know only work_T_tool; whether the nozzle or the plate moves is the
// cell's own affair (RoboFDM eq. 2.3: T_E^B = T_N^B T_O^N (T_O^P)^-1 (T_P^E)^-1).
//
// Work frame: origin at the centre of the platform's top, z out of it.
// Tool frame: origin at the nozzle's tip, z in the direction of extrusion (out of the nozzle, into
// the part): the build direction d of a waypoint is -z.
#pragma once

#include "process/process.h"
#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace voluta::robot {

enum class Mount { World, Flange };

class Cell {
public:
  // The file's keys are described in robot/cell_reader.cpp.
  // Throws Error{UnreadableFile, UnusableInput} naming file and key. The head's solid comes from
  // the process; the platform is a prism of `platformPolygon` (convex, work frame, counter-
  // clockwise) on the cell's own stem.
  static Cell read(const std::filesystem::path& file, const process::Process& process,
                   std::vector<Eigen::Vector2d> platformPolygon);

  const std::string& id() const { return id_; }
  const std::string& label() const { return label_; }
  const std::string& note() const { return note_; } // how it was laid out, for who sets it up
  const RobotModel& robot() const { return robot_; }
  int dof() const { return robot_.dof(); } // plus external axes, once a cell has some
  Mount nozzleMount() const { return nozzleMount_; }

  // What a program needs to say where things are.
  const Eigen::Isometry3d& flange_T_moved() const; // work frame (plate on the flange) or tool frame
  const Eigen::Isometry3d& base_T_fixed() const;   // tool frame (fixed nozzle) or work frame

  // Forward: pose of the nozzle in the work frame.
  Eigen::Isometry3d work_T_tool(const JointVector& q) const;
  // The flange pose that brings the nozzle to work_T_tool.
  Eigen::Isometry3d base_T_flange(const Eigen::Isometry3d& work_T_tool) const;
  // The inverse of base_T_flange.
  Eigen::Isometry3d work_T_toolOfFlange(const Eigen::Isometry3d& base_T_flange) const;
  // All branches inside the joint limits, each joint as near to `near` as whole turns allow.
  // Replaces what `solutions` held; a vector used again allocates nothing.
  void inverse(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
               std::vector<JointVector>& solutions) const;

  const std::vector<JointLimits>& limits() const { return robot_.limits; }
  const JointVector& home() const { return home_; }

  // Bodies and their frames. Frame indices: 0 robot base (= world), 1..dof links, dof + 1 flange,
  // dof + 2 work frame, dof + 3 tool frame.
  const std::vector<Body>& bodies() const { return bodies_; }
  int workFrame() const { return dof() + 2; }
  int toolFrame() const { return dof() + 3; }
  void framePoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_frame) const;
  // Pairs of bodies that may collide and are to be checked: all but those fixed to each other,
  // neighbours along the arm, and pairs that the cell's file lists as never meeting.
  const std::vector<std::pair<int, int>>& checkedPairs() const { return checkedPairs_; }
  // Bodies to be checked against the growing part (work frame): all that move relative to it.
  const std::vector<int>& bodiesAgainstPart() const { return bodiesAgainstPart_; }

private:
  Cell() = default;

  std::string id_, label_, note_;
  RobotModel robot_;
  Mount nozzleMount_ = Mount::World;
  Eigen::Isometry3d flange_T_moved_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d base_T_fixed_ = Eigen::Isometry3d::Identity();
  JointVector home_;
  std::vector<Body> bodies_;
  std::vector<std::pair<int, int>> checkedPairs_;
  std::vector<int> bodiesAgainstPart_;
};

std::vector<std::string> cellIds();
// Throws Error{Usage} for an unknown id, naming the nearest.
Cell loadCell(const std::string& id, const process::Process& process,
              std::vector<Eigen::Vector2d> platformPolygon);

// The largest radius R such that for every point of a ball of radius R standing on the platform
// (centre at height R above it) the nozzle can be brought there, upright and tilted up to
// `tiltRad` to all sides. mm. Deterministic sampling; the pattern is stated in the source file.
double reachableBallRadius(const Cell& cell, double tiltRad);

} // namespace voluta::robot
