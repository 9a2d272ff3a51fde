// Turns about the nozzle along a printed stretch, leans of its directions within a cone, and ways
// of external axes within some room, that make the joints' jerk least: all of them at once. Tips
// stay where they are on the part.
#pragma once

#include "motion/jerk.h"
#include "motion/leaning.h"
#include "motion/run.h"
#include "motion/smoothing/banded_solver.h"
#include "robot/cell.h"
#include "robot/kinematics/arm_twists.h"

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// How an arm stands where its tool leans by `lean` from the point's own, and was turned by `turn`
// then, with external axes so far from where the point has them.
struct TurnedPoint {
  double turn = 0.0;                              // rad
  Eigen::Vector2d lean = Eigen::Vector2d::Zero(); // rad: leaning.h
  robot::JointVector aside = {}; // rad, mm of slides; empty: where the point has them
  robot::JointVector q;          // of the cell
  robot::JointRates rate;        // of the cell's joints, a column for each part of a Place

  Eigen::Quaterniond tool(const Eigen::Quaterniond& own) const;
};

// What is free of a point, one behind the other: its turn, its lean where it may lean, its external
// axes' asides where they may go.
using Place = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 5, 1>;

using PlaceSlope = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 5, 5>;

// What holds a point, times what turning or leaning that point alone costs in jerk.
struct TurnHold {
  double stay = 0.0;     // of the squares of its turn and asides; kHeld: it keeps them
  double together = 0.0; // of the square of its place's difference from that of the point before
  double upright = 0.0;  // of the square of its lean; kHeld: it keeps that
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
  // how far a direction may lean, less than half a turn; 0: not at all. axesRad: how far external
  // axes may go from where the points have them (slides by robot::fromTurn), never beyond their
  // limits; 0: they stay. Precondition: where they may go there are one or two, and no rod.
  TurnSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
               const std::vector<RunPoint>& points, std::vector<double> times, double coneRad = 0.0,
               double axesRad = 0.0);

  // The points as they are.
  std::vector<TurnedPoint> start(const base::RunContext& ctx) const;

  // Lowers cost() by damped steps of Gauss and Newton: the joints are taken for linear in places,
  // the equations are banded and are solved in time linear in the number of points, then the joints
  // follow exactly. No step is taken that raises it. Leans stay inside the cone: unknown is what
  // LeanCone makes them of; asides stay inside their room likewise. What a limit or a singular pose
  // keeps from following keeps its place. `holds`: one a point. The same for any number of threads.
  // Throws Cancelled.
  void smooth(std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
              const TurnSmoothing& options, const base::RunContext& ctx) const;

  // The sum of the squared jerks of all joints (jerkStencils(), sliding joints by asTurn; those of
  // external axes where they may go), of what comes near a joint's limit, and of what `holds` ask.
  double cost(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds) const;

private:
  // Sums the squares of all jerks, and tells them, one a stencil.
  template <typename JointsAt>
  double jerksOf(const JointsAt& jointsAt, std::vector<robot::JointVector>& jerks) const;
  double limitCost(const robot::JointVector& q) const;
  Place placeOf(const TurnedPoint& at) const;
  Place weightOf(const TurnHold& hold, std::size_t i) const;
  robot::JointRates ratesOf(const robot::ArmJacobian& jacobian,
                            const Eigen::Isometry3d& base_T_flange, const TurnedPoint& at) const;
  robot::JointRates scaled(robot::JointRates rates) const;
  bool follow(std::size_t i, const TurnedPoint& from, TurnedPoint& to,
              std::vector<Eigen::Isometry3d>& links) const;
  // The damped step of all unknowns of a point: its turn, and what its lean and its asides are made
  // of. False: the equations have no solution.
  using Step = std::vector<Place>;
  template <int kFree>
  bool stepOf(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
              double damping, Step& step) const;
  bool anyStepOf(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
                 double damping, Step& step) const;
  // Of the point's place by its unknowns.
  PlaceSlope slopeOf(std::size_t i, const TurnedPoint& at, const TurnHold& hold) const;
  // As a step takes it there; the joints are as they were.
  TurnedPoint stepped(std::size_t i, const TurnedPoint& from, const TurnHold& hold,
                      const Place& step) const;

  const robot::Cell& cell_;
  const robot::ArmTwists& twists_;
  const std::vector<RunPoint>& points_;
  LeanCone cone_;
  std::vector<robot::JointVector> room_; // of each point's external axes; none: they stay
  Eigen::Index leans_ = 0, axes_ = 0;    // how many of a place are these
  std::vector<JerkStencil> stencils_;
  BandedRows<4> bands_;          // what points share by the times alone
  std::vector<double> scale_;    // of joints whose jerk counts: robot::asTurn
  std::vector<Place> stiffness_; // what moving a point alone costs, by the square of its place
  double limitWeight_ = 0.0;
};

} // namespace voluta::motion
