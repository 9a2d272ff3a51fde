#include "robot/cell.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/json_node.h"
#include "geometry/least_turn.h"
#include "robot/cell/robot_reader.h"
#include "robot/upright_axes.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace voluta::robot {

JointVector Cell::home() const {
  JointVector q = JointVector::Zero(dof());
  for (const Arm& arm : arms_)
    q.segment(arm.firstJoint, arm.jointCount()) = arm.home;
  return q;
}

const Eigen::Isometry3d& Cell::flange_T_moved() const {
  return flange_T_moved_;
}
const Eigen::Isometry3d& Cell::base_T_fixed() const {
  return base_T_fixed_;
}

Eigen::Isometry3d Cell::work_T_tool(const JointVector& q) const {
  return work_T_toolOfFlange(robot().kinematics->flange(q), q);
}

Eigen::Isometry3d Cell::work_T_unit() const {
  base::require(axesMovePlatform(), "a cell with an external axis that carries the platform");
  Eigen::Isometry3d axis_T_unit = Eigen::Isometry3d::Identity();
  axis_T_unit.linear() << Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(),
      Eigen::Vector3d::UnitX();
  return axis_T_work_.inverse(Eigen::Isometry) * axis_T_unit;
}

Eigen::Isometry3d Cell::base_T_axis(std::size_t count, const JointVector& q) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (std::size_t k = 0; k < count; ++k)
    pose = pose * externalAxes_[k].before_T_axis *
           movedBy(externalAxes_[k], q[armDof() + static_cast<Eigen::Index>(k)]);
  return pose;
}

Eigen::Isometry3d Cell::base_T_world(const JointVector& q) const {
  if (axesUnderRobot_ == 0)
    return Eigen::Isometry3d::Identity();
  return base_T_axis(axesUnderRobot_, q) * externalAxes_[axesUnderRobot_ - 1].axis_T_moved;
}

Eigen::Isometry3d Cell::base_T_work(const JointVector& q) const {
  if (nozzleMount_ == Mount::World)
    return robot().kinematics->flange(q) * flange_T_moved_;
  if (externalAxes_.empty())
    return base_T_fixed_;
  return base_T_axis(externalAxes_.size(), q) * axis_T_work_;
}

bool Cell::tilts() const {
  return robot().kinematics->tilts() ||
         std::any_of(externalAxes_.begin(), externalAxes_.end(), [](const ExternalAxis& axis) {
           return axis.limits.kind == JointKind::Turning;
         });
}

// RoboFDM eq. 2.3. With the plate on the flange: base_T_flange flange_T_work work_T_tool =
// base_T_tool; with the nozzle on it: base_T_work work_T_tool = base_T_flange flange_T_tool.
Eigen::Isometry3d Cell::base_T_flange(const Eigen::Isometry3d& work_T_tool,
                                      const JointVector& q) const {
  if (nozzleMount_ == Mount::World)
    return base_T_fixed_ * (flange_T_moved_ * work_T_tool).inverse();
  return base_T_work(q) * work_T_tool * flange_T_moved_.inverse();
}

Eigen::Isometry3d Cell::work_T_toolOfFlange(const Eigen::Isometry3d& base_T_flange,
                                            const JointVector& q) const {
  if (nozzleMount_ == Mount::World)
    return (base_T_flange * flange_T_moved_).inverse() * base_T_fixed_;
  return base_T_work(q).inverse() * base_T_flange * flange_T_moved_;
}

namespace {
// Returns the flange pose with the flange upright and the nozzle's tip in the same place, if the
// flange is tilted by no more than the positioner's angles are rounded; else the same pose.
Eigen::Isometry3d straightened(const Eigen::Isometry3d& base_T_flange,
                               const Eigen::Isometry3d& flange_T_tool) {
  const Eigen::Vector3d z = base_T_flange.linear().col(2);
  if (!(z.z() > 0.0 && std::hypot(z.x(), z.y()) < 1.5 * kAlongAxisRad))
    return base_T_flange;
  Eigen::Isometry3d upright = Eigen::Isometry3d::Identity();
  upright.linear() = geometry::shortestRotation(z, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                     base_T_flange.linear();
  upright.translation() =
      base_T_flange * flange_T_tool.translation() - upright.linear() * flange_T_tool.translation();
  return upright;
}
} // namespace

void Cell::inverse(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
                   std::vector<JointVector>& solutions) const {
  Eigen::Isometry3d flange = base_T_flange(work_T_tool, near);
  if (tiltsPart(*this))
    flange = straightened(flange, flange_T_moved_);
  inverseNear(robot(), flange, near, solutions);
  for (JointVector& q : solutions) {
    q.conservativeResize(dof());
    q.tail(dof() - armDof()) = near.tail(dof() - armDof());
  }
}

std::optional<JointVector> Cell::next(const Eigen::Isometry3d& work_T_tool, const JointVector& near,
                                      double maxRad) const {
  auto q = nextBranch(robot(), base_T_flange(work_T_tool, near), near, maxRad);
  if (q) {
    q->conservativeResize(dof());
    q->tail(dof() - armDof()) = near.tail(dof() - armDof());
  }
  return q;
}

void Cell::framePoses(const JointVector& q, std::vector<Eigen::Isometry3d>& base_T_frame) const {
  robot().kinematics->linkPoses(q, base_T_frame);
  const Eigen::Isometry3d moved = base_T_frame.back() * flange_T_moved_;
  const bool plateMoves = nozzleMount_ == Mount::World;
  base_T_frame.push_back(plateMoves ? moved : base_T_work(q));
  base_T_frame.push_back(plateMoves ? base_T_fixed_ : moved);
  Eigen::Isometry3d axis = Eigen::Isometry3d::Identity();
  for (std::size_t k = 0; k < externalAxes_.size(); ++k) {
    axis = axis * externalAxes_[k].before_T_axis *
           movedBy(externalAxes_[k], q[armDof() + static_cast<Eigen::Index>(k)]);
    base_T_frame.push_back(axis * externalAxes_[k].axis_T_moved);
  }
}

std::vector<std::string> cellIds() {
  return base::dataFileIds("cells");
}

Cell loadCell(const std::string& choice, const process::Process& process,
              platform::PlatformSolid platform) {
  const base::DataText data = base::dataText("cells", choice, "unknown cell '{id}'"_text);
  return Cell::readText(data.text, data.file, process, std::move(platform));
}

std::string selfContainedCell(const std::filesystem::path& file) {
  using Json = nlohmann::ordered_json;
  std::string text = base::readFile(file);
  const base::JsonNode robot = base::JsonNode::parse(text, file.string()).at("robot");
  if (holdsRobot(robot))
    return text;
  const std::filesystem::path robotFile =
      base::dataFile("robots", robot.text(), "unknown robot '{id}'"_text);
  if (robotFile.parent_path() == base::resourceFolder() / "robots")
    return text;
  base::JsonNode::readFile(robotFile); // throws if the file is invalid
  Json cell = Json::parse(text);
  cell["robot"] = Json::parse(base::readFile(robotFile));
  return cell.dump(1);
}

} // namespace voluta::robot
