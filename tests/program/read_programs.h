// Programs that are read back, held against the trajectory that they were written from.
#pragma once

#include "program_fixture.h"

#include "base/error.h"
#include "program/dialect.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace voluta::test {

class ReadPrograms : public Programs {
protected:
  robot::JointVector jointsAt(std::size_t i) const {
    return Eigen::Map<const Eigen::VectorXd>(trajectory_.at(i), trajectory_.dof);
  }
  Eigen::Isometry3d tcpAt(std::size_t i) const {
    return cell_->robot().kinematics->flange(jointsAt(i)) * cell_->flange_T_moved();
  }

  // Texts do not distinguish mm from degrees.
  robot::JointVector withExternals(robot::JointVector q, const plan::ProgramMotion& m) const {
    for (std::size_t k = 0; k < m.externals.size(); ++k) {
      const bool slides = cell_->externalAxes()[k].limits.kind == robot::JointKind::Sliding;
      q[cell_->armDof() + static_cast<Eigen::Index>(k)] =
          slides ? base::radiansToDegrees(m.externals[k]) : m.externals[k];
    }
    return q;
  }

  void expectTarget(const plan::ReadProgram& program, std::size_t i) const {
    const plan::ProgramMotion& m = program.motions[i];
    const Eigen::Isometry3d planned = cell_->work_T_tool(jointsAt(i));
    Eigen::Vector3d tip, direction;
    if (m.target == plan::TargetKind::ToolPoint) {
      tip = m.position;
      direction = m.direction;
    } else {
      Eigen::Isometry3d tool;
      if (m.target == plan::TargetKind::Joints)
        tool = cell_->work_T_tool(
            withExternals(Eigen::Map<const Eigen::VectorXd>(m.joints.data(), trajectory_.dof), m));
      else if (m.target == plan::TargetKind::WorkPose)
        tool = program.base_T_nozzle
                   ? Eigen::Isometry3d(cell_->flange_T_moved().inverse() * program.flange_T_tcp *
                                       m.frame_T_tcp * program.base_T_nozzle->inverse() *
                                       cell_->base_T_fixed())
                   : m.frame_T_tcp * program.flange_T_tcp.inverse() * cell_->flange_T_moved();
      else if (m.target == plan::TargetKind::UnitPose)
        tool = cell_->work_T_unit() * m.frame_T_tcp * program.flange_T_tcp.inverse() *
               cell_->flange_T_moved();
      else { // where axes carry the robot, poses are in the world
        const robot::JointVector q = withExternals(cell_->home(), m);
        tool = cell_->work_T_toolOfFlange(
            cell_->base_T_world(q) * m.frame_T_tcp * program.flange_T_tcp.inverse(), q);
      }
      tip = tool.translation();
      direction = -tool.linear().col(2);
      EXPECT_LE(Eigen::AngleAxisd(planned.linear().transpose() * tool.linear()).angle(), 1e-5);
    }
    EXPECT_LE((tip - planned.translation()).norm(), 1e-3) << "point " << i;
    if (program.tellsDirections) {
      EXPECT_LE((direction + planned.linear().col(2)).norm(), 1e-5) << "point " << i;
    }
  }

  // The time that a controller takes for motion i, by the text.
  double seconds(const plan::ReadProgram& program, std::size_t i) const {
    const plan::ProgramMotion& m = program.motions[i];
    if (m.durationS > 0.0)
      return m.durationS;
    if (m.target == plan::TargetKind::ToolPoint)
      return (m.position - program.motions[i - 1].position).norm() / m.speedMmPerS;
    const plan::ProgramMotion& before = program.motions[i - 1];
    const Eigen::Isometry3d from =
        before.target != plan::TargetKind::Joints ? before.frame_T_tcp
        : m.target == plan::TargetKind::UnitPose
            ? cell_->work_T_unit().inverse() * cell_->work_T_tool(jointsAt(i - 1))
        : m.target == plan::TargetKind::WorkPose ? cell_->work_T_tool(jointsAt(i - 1))
                                                 : tcpAt(i - 1);
    return (m.frame_T_tcp.translation() - from.translation()).norm() / m.speedMmPerS;
  }

  // Points on the way of a joint motion, or of one on a table, are merged with its end.
  void dropPieces(plan::ReadProgram& program) const {
    std::vector<plan::ProgramMotion> whole;
    double seconds = 0.0, volume = 0.0;
    for (const plan::ProgramMotion& m : program.motions) {
      const std::size_t point = whole.size();
      const bool byJoints = point > 0 && point < trajectory_.pointCount() &&
                            trajectory_.move[point] == plan::MoveKind::Joint;
      const bool mayBePiece = point > 0 && point < trajectory_.pointCount() &&
                              (program.beadsByJoints ? !byJoints
                                                     : m.target == plan::TargetKind::ToolPoint &&
                                                           (!m.viaPoints.empty() || byJoints));
      if (mayBePiece) {
        const Eigen::Isometry3d end = cell_->work_T_tool(jointsAt(point));
        Eigen::Vector3d tip = m.position, direction = m.direction;
        if (program.beadsByJoints) {
          const Eigen::Isometry3d tool = cell_->work_T_tool(
              Eigen::Map<const Eigen::VectorXd>(m.joints.data(), trajectory_.dof));
          tip = tool.translation();
          direction = -tool.linear().col(2);
        }
        if ((tip - end.translation()).norm() > 1e-3 ||
            (program.tellsDirections && (direction + end.linear().col(2)).norm() > 1e-4)) {
          seconds += m.durationS;
          volume += m.extruding ? m.volumeMm3 : 0.0;
          continue;
        }
      }
      whole.push_back(m);
      if (m.durationS > 0.0)
        whole.back().durationS += seconds;
      if (m.volumeMm3 >= 0.0)
        whole.back().volumeMm3 += volume;
      seconds = volume = 0.0;
    }
    program.motions = std::move(whole);
  }
};

} // namespace voluta::test
