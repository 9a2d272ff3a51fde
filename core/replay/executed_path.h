// What a controller does with a program: poses, joints and times, and the nozzle's path in the
// work frame.
//
// Interpolation assumed:
// - straight motions move the TCP linearly in Base and turn it along the shortest rotation, both in
//   proportion; where external axes turn the work frame, and in programs of joint values, they move
//   the nozzle so in the work frame while the external axes turn in proportion; ToolPoint motions
//   move the tip linearly in the work frame and turn its direction along the great circle, between
//   the points of their way where they have one;
// - a blend of radius r at a target starts r before it and ends r after it (lengths of the TCP's
//   path) and is the parabola whose control point is the target (quadratic Bezier): the corner is
//   cut by r/2 sin(turn/2). Rotations follow by the same (de Casteljau) construction;
// - joint motions turn all joints in proportion and stop at their target (no blends);
// - a Cartesian target is reached with the joint solution nearest to where the arm is, of those
// with
//   the elbow that it asks for; external
//   axes stay where they are unless the target says otherwise;
// - durations are length / speed without ramps, as the text says them (controller_time.h tells what
//   a controller makes of them): joint motions max |dq| / joint speed; wherever joints are held
//   against each other, sliding ones count as robot::asTurn has them;
// - an axis that stands at multiples of a step turns evenly between them: held against its limit is
//   what it turns less one step.
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

// What the arm can't do, found while running.
enum class LimitKind { OutOfReach, JointRange, JointSpeed, BranchJump, BlendOverlap, Flow };
struct LimitViolation {
  LimitKind kind;
  std::size_t motion = 0;
  int joint = -1;                  // where it concerns one
  double value = 0.0, limit = 0.0; // rad, rad/s (mm, mm/s); BlendOverlap: mm; Flow: mm3/s
};

struct ExecutedPath {
  bool arm = false; // joints are known

  // Per motion: where it ends by its target, not rounded by a blend.
  std::vector<Eigen::Vector3d> targetTip, targetDirection; // work frame, mm; unit, -tool z
  std::vector<double> commandedMm; // length the speed refers to: the TCP's in Base, or the tip's
  std::vector<double> turnRad;     // of what the target describes, to there; 0 for ToolPoint
  std::vector<double> cornerRad;   // between its way and the next motion's; 0 at the end
  std::vector<double> durationS, startS;
  int dof = 0, armDof = 0;             // all axes; those before the external ones
  std::vector<robot::JointKind> kinds; // dof of them
  std::vector<double> joints;          // dof x motions at each motion's end; empty without an arm

  // The nozzle along motion m: samples [firstSample[m], firstSample[m + 1]), the start excluded,
  // the end included; at most 0.5 mm apart where extruding, 1 mm elsewhere.
  std::vector<std::size_t> firstSample; // motions + 1
  std::vector<Eigen::Vector3d> tip, direction;

  // Arm configurations at most 2 mm, 2 degrees of the TCP and 0.03 rad of a joint (joint motions)
  // apart. With external axes, straight motions: 2 mm, 2 degrees of the flange and 0.1 rad of those
  // axes.
  std::vector<double> armJoints; // dof x samples
  std::vector<std::uint32_t> armMotion;
  std::vector<float> armFraction; // of its motion

  std::vector<LimitViolation> violations; // in motion order

  std::size_t motionCount() const { return startS.size(); }
  // A step of axis k as a turn, rad.
  double turnOf(int k, double step) const {
    return robot::asTurn(kinds[static_cast<std::size_t>(k)], step);
  }
  // Precondition: arm.
  const double* jointsAt(std::size_t motion) const {
    return joints.data() + motion * static_cast<std::size_t>(dof);
  }
  double totalS() const { return startS.empty() ? 0.0 : startS.back() + durationS.back(); }
};

// Throws Cancelled. Targets with another number of joints or external axes than the cell has are
// out of reach.
ExecutedPath executeProgram(const plan::ReadProgram& program, const robot::Cell& cell,
                            const base::RunContext& ctx);

// A program of ToolPoint motions only, without a cell: for tests of how motions run.
ExecutedPath executeToolPoints(const plan::ReadProgram& program, const base::RunContext& ctx);

} // namespace voluta::replay
