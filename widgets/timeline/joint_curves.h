// Angles, speeds and jerks of a trajectory, prepared for drawing at any width.
#pragma once

#include "base/run_context.h"
#include "plan/trajectory.h"
#include "robot/kinematics/joint_kind.h"
#include "timeline/curve_pyramid.h"

#include <QList>
#include <QPointF>
#include <memory>
#include <vector>

namespace voluta::timeline {

// Immutable; times include waits, at which the joints rest. Degrees and degrees per second over
// seconds, mm and mm/s for sliding joints; jerks in rad/s³ and mm/s³. Construction takes O(dof N),
// on a worker thread.
class JointCurves {
public:
  // Joints beyond those of `kinds` are turning ones. Precondition (Error{Internal}): a trajectory
  // with points and non-decreasing times.
  JointCurves(std::shared_ptr<const plan::Trajectory> trajectory,
              const std::vector<robot::JointKind>& kinds, const base::RunContext& ctx);

  int dof() const { return trajectory_->dof; }
  double durationS() const { return timeS_.back(); }

  // Returns the curve over [fromS, toS] for the given number of pixel columns: at most four points
  // per column, whose minimum and maximum are those of the curve there. columns >= 1.
  QList<QPointF> angle(int joint, double fromS, double toS, int columns) const;
  // Constant between two points of the trajectory, drawn as steps.
  QList<QPointF> speed(int joint, double fromS, double toS, int columns) const;
  QList<QPointF> jerk(int joint, double fromS, double toS, int columns) const;
  ValueRange angleRange(int joint) const;
  ValueRange speedRange(int joint) const;
  ValueRange jerkRange(int joint) const;

private:
  std::vector<std::size_t> addTimes();
  QList<QPointF> reduced(const CurvePyramid& curve, double fromS, double toS, int columns,
                         bool steps) const;

  std::shared_ptr<const plan::Trajectory> trajectory_;
  std::vector<double> timeS_; // Of each point, and of the end of each wait
  // One per joint; a value per time, speeds up to the next
  std::vector<CurvePyramid> angle_, speed_, jerk_;
};

} // namespace voluta::timeline
