// Turns about the nozzle along a printed stretch, and leans of its directions within a cone, that
// make the joints' jerk least: all of them at once. Tips stay where they are, and so do external
// axes.
#pragma once

#include "motion/banded_solver.h"
#include "motion/jerk.h"
#include "motion/leaning.h"
#include "motion/run.h"
#include "robot/arm_twists.h"
#include "robot/cell.h"

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// How an arm stands where its tool leans by `lean` from the point's own, and was turned by `turn`
// then.
struct TurnedPoint {
  double turn = 0.0;                              // rad
  Eigen::Vector2d lean = Eigen::Vector2d::Zero(); // rad: leaning.h
  robot::JointVector q;                           // of the cell
  robot::JointRates rate; // of the arm's joints: with the turn and, where they may lean, the lean

  Eigen::Quaterniond tool(const Eigen::Quaterniond& own) const;
};

// What holds a point, times what turning or leaning that point alone costs in jerk.
struct TurnHold {
  double stay = 0.0; // of the square of its turn; kHeld: it keeps its turn
  double together =
      0.0;              // of the square of its turn's and lean's difference from the point's before
  double upright = 0.0; // of the square of its lean; kHeld: it keeps that
};
inline constexpr double kHeld = std::numeric_limits<double>::infinity();

struct TurnSmoothing {
  int rounds = 6;           // of Gauss-Newton's steps at most
  double enough = 1e-3;     // ends where a step lowers the sum by a smaller share
  double longestTurn = 0.3; // rad, of any point in a step
};

class TurnSmoother {
public:
  // Over points that are reached at `times` (s, rising). What is referenced outlives it. coneRad:
  // how far a direction may lean, less than half a turn; 0: not at all.
  TurnSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
               const std::vector<RunPoint>& points, std::vector<double> times,
               double coneRad = 0.0);

  // The points as they are.
  std::vector<TurnedPoint> start(const base::RunContext& ctx) const;

  // Lowers cost() by damped steps of Gauss and Newton: the joints are taken for linear in turns and
  // leans, the equations are banded and are solved in time linear in the number of points, then the
  // joints follow exactly. No step is taken that raises it. Leans stay inside the cone: unknown is
  // what LeanCone makes them of. What a limit or a singular pose keeps from following keeps its
  // turn. `holds`: one a point. The same for any number of threads. Throws Cancelled.
  void smooth(std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
              const TurnSmoothing& options, const base::RunContext& ctx) const;

  // The sum of the squared jerks of all joints (jerkStencils(), sliding joints by asTurn), of what
  // comes near a joint's limit, and of what `holds` ask.
  double cost(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds) const;

private:
  // Sums the squares of all jerks, and tells them, one a stencil.
  template <typename JointsAt>
  double jerksOf(const JointsAt& jointsAt, std::vector<robot::JointVector>& jerks) const;
  double limitCost(const robot::JointVector& q, robot::JointVector* slope) const;
  robot::JointRates ratesOf(const robot::ArmJacobian& jacobian,
                            const Eigen::Isometry3d& base_T_flange, const TurnedPoint& at) const;
  robot::JointRates scaled(robot::JointRates rates) const;
  bool follow(std::size_t i, const TurnedPoint& from, TurnedPoint& to,
              std::vector<Eigen::Isometry3d>& links) const;
  // The damped step of all unknowns of a point: its turn, and what its lean is made of. False: the
  // equations have no solution.
  template <int kFree>
  bool stepOf(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
              double damping, std::vector<Eigen::Vector3d>& step) const;

  const robot::Cell& cell_;
  const robot::ArmTwists& twists_;
  const std::vector<RunPoint>& points_;
  LeanCone cone_;
  std::vector<JerkStencil> stencils_;
  BandedRows<4> bands_;       // what points share by the times alone
  std::vector<double> scale_; // of the arm's joints: robot::asTurn
  // What moving a point alone costs, by the square of its turn, and of its lean.
  std::vector<Eigen::Vector3d> stiffness_;
  double limitWeight_ = 0.0;
};

} // namespace voluta::motion
