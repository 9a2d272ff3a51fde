// Turns about the nozzle along a printed stretch that make the joints' jerk least: all of them at
// once. Tips and directions stay where they are, and so do external axes.
#pragma once

#include "motion/banded_solver.h"
#include "motion/jerk.h"
#include "motion/run.h"
#include "robot/arm_twists.h"
#include "robot/cell.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// How an arm stands where its tool was turned by `turn` more than the point's own.
struct TurnedPoint {
  double turn = 0.0;       // rad
  robot::JointVector q;    // of the cell
  robot::JointVector rate; // of the arm's joints with the turn
};

// What holds a point's turn, times what turning that point alone costs in jerk.
struct TurnHold {
  double stay = 0.0;     // of the square of its turn; kHeld: it keeps its turn
  double together = 0.0; // of the square of its turn's difference from the point's before
};
inline constexpr double kHeld = std::numeric_limits<double>::infinity();

struct TurnSmoothing {
  int rounds = 6;          // of Gauss-Newton's steps at most
  double enough = 1e-3;     // ends where a step lowers the sum by a smaller share
  double longestTurn = 0.3; // rad, of any point in a step
};

class TurnSmoother {
public:
  // Over points that are reached at `times` (s, rising). What is referenced outlives it.
  TurnSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
               const std::vector<RunPoint>& points, std::vector<double> times);

  // The points as they are.
  std::vector<TurnedPoint> start(const base::RunContext& ctx) const;

  // Lowers cost() by damped steps of Gauss and Newton: the joints are taken for linear in the
  // turns, the equations are banded and are solved in time linear in the number of points, then the
  // joints follow exactly. No step is taken that raises it. What a limit or a singular pose keeps
  // from following keeps its turn. `holds`: one a point. The same for any number of threads. Throws
  // Cancelled.
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
  robot::JointVector rateOf(const robot::ArmJacobian& jacobian,
                            const Eigen::Isometry3d& base_T_flange) const;
  robot::JointVector scaled(robot::JointVector rate) const;
  bool follow(std::size_t i, double turn, const TurnedPoint& from, TurnedPoint& to,
              std::vector<Eigen::Isometry3d>& links) const;
  // The damped step of all turns. False: the equations have no solution.
  bool stepOf(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
              double damping, std::vector<double>& step) const;

  const robot::Cell& cell_;
  const robot::ArmTwists& twists_;
  const std::vector<RunPoint>& points_;
  std::vector<JerkStencil> stencils_;
  BandedRows bands_;              // what points share by the times alone
  std::vector<double> scale_;     // of the arm's joints: robot::asTurn
  std::vector<double> stiffness_; // what turning a point alone costs, by the turn's square
  double limitWeight_ = 0.0;
};

} // namespace voluta::motion
