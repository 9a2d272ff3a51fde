// Angles and speeds of a trajectory, ready to be drawn at any width.
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

// Immutable; degrees and degrees per second over seconds, mm and mm/s of joints that slide. Made in
// O(dof N), on a worker.
class JointCurves {
public:
  // Joints behind those of `kinds` turn. Precondition (Error{Internal}): a trajectory with points,
  // times that do not decrease.
  JointCurves(std::shared_ptr<const plan::Trajectory> trajectory,
              const std::vector<robot::JointKind>& kinds, const base::RunContext& ctx);

  int dof() const { return trajectory_->dof; }
  double durationS() const { return trajectory_->timeS.back(); }

  // The curve over [fromS, toS] for so many pixel columns: at most four points a column, whose
  // least and greatest values are those of the curve there. columns >= 1.
  QList<QPointF> angle(int joint, double fromS, double toS, int columns) const;
  // Constant between two points of the trajectory, drawn as steps.
  QList<QPointF> speed(int joint, double fromS, double toS, int columns) const;
  ValueRange angleRange(int joint) const;
  ValueRange speedRange(int joint) const;

private:
  QList<QPointF> reduced(const CurvePyramid& curve, double fromS, double toS, int columns,
                         bool steps) const;

  std::shared_ptr<const plan::Trajectory> trajectory_;
  std::vector<CurvePyramid> angle_, speed_; // a joint each; a value per point, speeds till the next
};

} // namespace voluta::timeline
