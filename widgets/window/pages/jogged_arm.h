// An arm that is moved by hand in the simulation, joint by joint or by its nozzle, with the checks
// of its poses. It changes nothing in the plan.
#pragma once

#include "base/text.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "pipeline/plan_result.h"
#include "robot/robot_model.h"

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace voluta::window {

// The nozzle on the platform: its tip [mm], and the angles [deg] by which it is rotated from
// upright about the fixed axes z, y and x, in this order.
struct NozzlePose {
  Eigen::Vector3d tipMm = Eigen::Vector3d::Zero(), anglesDeg = Eigen::Vector3d::Zero();
};
NozzlePose nozzlePose(const Eigen::Isometry3d& work_T_tool);
Eigen::Isometry3d work_T_toolOf(const NozzlePose& pose);

// Returns the beads of the plan for JoggedArm::setPart(), in coarser cells than the planner's.
// Throws Cancelled. Precondition: the plan has tool-paths.
std::shared_ptr<const collision::GrowingPart> joggingPart(const pipeline::PlanResult& plan,
                                                          const base::RunContext& ctx);

class JoggedArm {
public:
  // Precondition: the plan has a cell; `joints` as its dof().
  JoggedArm(std::shared_ptr<const pipeline::PlanResult> plan, robot::JointVector joints);

  const robot::Cell& cell() const { return *plan_->cell; }
  const robot::JointVector& joints() const { return joints_; }
  NozzlePose nozzle() const;

  // [rad], of a sliding joint [mm]; kept within the limits.
  void setJoint(Eigen::Index joint, double value);
  // Moves the nozzle; the external axes stay. Returns false if no joints within the limits reach
  // the pose, and changes nothing.
  bool setNozzle(const NozzlePose& pose);
  // Moves the tip by `amount` [mm] along the platform's axis 0 to 2, or rotates the nozzle by it
  // [deg] about the axis 3 to 5 through its tip. Returns as setNozzle().
  bool step(int coordinate, double amount);

  // The beads before waypoint `before` are checked too, once they are known.
  void setPart(std::shared_ptr<const collision::GrowingPart> part, std::size_t before);
  bool checksPart() const { return part_ != nullptr; }
  // Returns the bodies that collide, none, or the clearance [mm] of bodies up to kMaxClearanceMm.
  struct Check {
    std::optional<std::pair<base::Value, base::Value>> colliding;
    double clearanceMm = 0.0;
  };
  // Returns the check of the present pose, for another thread. It may outlive the arm; those of one
  // arm must not run at the same time.
  std::function<Check()> check() const;
  static constexpr double kMaxClearanceMm = 200.0;

private:
  bool moveTo(const Eigen::Isometry3d& work_T_tool);

  std::shared_ptr<const pipeline::PlanResult> plan_; // owns the cell
  robot::JointVector joints_;
  std::shared_ptr<collision::CellCollision> collision_;
  std::shared_ptr<const collision::GrowingPart> part_;
  std::size_t before_ = 0;
};

} // namespace voluta::window
