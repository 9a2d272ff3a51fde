// Executes a program as a controller would: poses, joints and times, and the nozzle's path in the
// work frame.
//
// Assumed interpolation:
// - straight motions move the TCP linearly in Base and rotate it along the shortest rotation, both
//   in proportion. If external axes turn the work frame, and in programs of joint values, they do
//   so with the nozzle in the work frame while the external axes turn in proportion. ToolPoint
//   motions move the tip linearly in the work frame and rotate its direction along the great
//   circle. Motions with a way lead from point to point of it, and rotate the TCP as straight ones;
// - a blend of radius r at a target starts r before it and ends r after it (lengths of the TCP's
//   path). It is the parabola whose control point is the target (quadratic Bezier), which cuts the
//   corner by r/2 sin(turn/2). Rotations follow the same (de Casteljau) construction;
// - joint motions turn all joints in proportion and stop at their target (no blends);
// - a Cartesian target is reached with the joint solution nearest to the arm's present joints,
//   among those with the elbow that the target requires; external axes keep their values unless the
//   target states others;
// - durations are length / speed without ramps, as programmed (controller_time.h models the
//   controller's own timing); for joint motions max |dq| / joint speed. Where joints are compared
//   with each other, sliding ones count as robot::asAngle converts them;
// - an axis that is programmed at multiples of a step turns evenly between them; its speed limit is
//   checked against its motion less one step.
#pragma once

#include "plan/program.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

// A limit that the arm or the head cannot keep, found during execution.
enum class LimitKind { OutOfReach, JointRange, JointSpeed, BranchJump, BlendOverlap, Flow };
struct LimitViolation {
  LimitKind kind;
  std::size_t motion = 0;
  int joint = -1;                  // -1 if it concerns no single joint
  double value = 0.0, limit = 0.0; // rad, rad/s (mm, mm/s); BlendOverlap: mm; Flow: mm³/s
};

struct ExecutedPath {
  bool arm = false; // true: the joints are known

  // Per motion: its end at the target, before rounding by a blend.
  std::vector<Eigen::Vector3d> targetTip, targetDirection; // work frame, mm; unit, -tool z
  // length to which the speed refers: the TCP's in Base, or the tip's
  std::vector<double> commandedMm;
  std::vector<double> angleRad;  // rotation of the same frame during the motion; 0 for ToolPoint
  std::vector<double> cornerRad; // between this motion and the next; 0 at the end
  std::vector<double> durationS, startS;
  int dof = 0, armDof = 0;             // all axes; those before the external ones
  std::vector<robot::JointKind> kinds; // one per axis (dof)
  std::vector<double> joints;          // dof x motions, at each motion's end; empty without an arm

  // Nozzle samples along motion m: [firstSample[m], firstSample[m + 1]), without the start, with
  // the end; at most 0.5 mm apart while extruding, else 1 mm.
  std::vector<std::size_t> firstSample; // motions + 1
  std::vector<Eigen::Vector3d> tip, direction;

  // Arm configurations at most 2 mm, 2 degrees of the TCP and 0.03 rad of a joint (joint motions)
  // apart. With external axes, in straight motions: 2 mm, 2 degrees of the flange and 0.1 rad of
  // those axes.
  std::vector<double> armJoints; // dof x samples
  std::vector<std::uint32_t> armMotion;
  std::vector<float> armFraction; // of its motion

  std::vector<LimitViolation> violations; // in motion order

  std::size_t motionCount() const { return startS.size(); }
  // Returns a step of axis k as a rotation [rad].
  double angleOf(int k, double step) const {
    return robot::asAngle(kinds[static_cast<std::size_t>(k)], step);
  }
  // Precondition: arm.
  const double* jointsAt(std::size_t motion) const {
    return joints.data() + motion * static_cast<std::size_t>(dof);
  }
  double totalS() const { return startS.empty() ? 0.0 : startS.back() + durationS.back(); }
};

// Distance of samples along the printed beads, of up to 1.2 mm width [mm].
inline constexpr double kPrintSampleMm = 0.5;

// Throws Cancelled. Targets with another number of joints or external axes than the cell has are
// out of reach.
ExecutedPath executeProgram(const plan::ReadProgram& program, const robot::Cell& cell,
                            const base::RunContext& ctx, double printSampleMm = kPrintSampleMm);

// Executes a program of ToolPoint motions only, without a cell; for tests of motions.
ExecutedPath executeToolPoints(const plan::ReadProgram& program, const base::RunContext& ctx);

} // namespace voluta::replay
