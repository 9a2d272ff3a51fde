// Joint optimization of the turns about the nozzle, the leans of its directions within a cone, and
// the offsets of external axes within some room along a printed stretch, such that the joints' jerk
// is minimal. Tips keep their positions on the part.
#pragma once

#include "motion/bead_run.h"
#include "motion/jerk.h"
#include "motion/leaning.h"
#include "motion/smoothing/banded_solver.h"
#include "robot/cell.h"
#include "robot/kinematics/arm_twists.h"

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

// The arm's state at a point whose tool leans by `lean` from the point's own orientation and is
// then turned by `rotation`, with external axes offset from the point's.
struct TurnedPoint {
  double rotation = 0.0;                          // rad
  Eigen::Vector2d lean = Eigen::Vector2d::Zero(); // rad: leaning.h
  robot::JointVector offset = {}; // offset of external axes: rad, mm for sliding axes; empty: none
  robot::JointVector q;           // of the cell
  robot::JointRates rate;         // of the cell's joints, one column per component of a Place

  Eigen::Quaterniond tool(const Eigen::Quaterniond& own) const;
};

// The degrees of freedom of a point, in this order: its turn, its lean if it may lean, the offsets
// of its external axes if they may move.
using Place = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 5, 1>;

using PlaceSlope = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 5, 5>;

// Weights that hold a point in place, in multiples of the jerk cost of turning or leaning that
// point alone.
struct RotationHold {
  double stay = 0.0; // weight of the squares of its turn and offsets; kHeld: these are fixed
  // weight of the squared difference of its place from that of the preceding point
  double together = 0.0;
  double upright = 0.0; // weight of its squared lean; kHeld: the lean is fixed
};
inline constexpr double kHeld = std::numeric_limits<double>::infinity();

struct RotationSmoothing {
  int rounds = 6;           // maximum number of Gauss-Newton steps
  double enough = 1e-3;     // stops if a step lowers the sum by a smaller share
  double maxRotation = 0.3; // [rad] maximum turn of any point in one step
};

// An estimate of how near joints are to a collision, which a smoother lowers: from 0 on, more is
// worse. `slope`: its derivative with respect to the joints. Both are called from several threads.
struct Nearness {
  std::function<double(const robot::JointVector&)> value;
  std::function<robot::JointVector(const robot::JointVector&)> slope;
};

class RotationSmoother {
public:
  // `times`: times of the points [s], increasing. References are kept. coneRad: largest lean of a
  // direction, less than pi; 0: none. axesRad: largest offset of external axes from the points' own
  // (sliding axes by robot::fromAngle), never beyond their limits; 0: fixed. Precondition: if
  // external axes may move, there are one or two and no rod.
  RotationSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
                   const std::vector<RunPoint>& points, std::vector<double> times,
                   double coneRad = 0.0, double axesRad = 0.0);

  // Adds the squares of `nearness`, weighted by the mean jerk cost of a point, to the cost
  // (Dai 2020, eq. 4.12: the collision constraint). The reference is kept.
  void avoid(const Nearness& nearness) { nearness_ = &nearness; }

  // Returns the points unchanged.
  std::vector<TurnedPoint> start(const base::RunContext& ctx) const;

  // Lowers cost() by damped Gauss-Newton steps: joints are linearized in the places, the banded
  // equations are solved in time linear in the number of points, then the joints are recomputed
  // exactly. Steps that raise the cost are rejected. Leans stay inside the cone, and offsets inside
  // their room, since the unknowns are mapped to them by LeanCone and likewise. Points that cannot
  // follow, because of a limit or a singular pose, keep their place. `holds`: one per point. The
  // result does not depend on the number of threads. Throws Cancelled.
  void smooth(std::vector<TurnedPoint>& at, const std::vector<RotationHold>& holds,
              const RotationSmoothing& options, const base::RunContext& ctx) const;

  // Returns the sum of the squared jerks of all joints (jerkStencils(), sliding joints by asAngle;
  // external axes only if they may move), of the penalties near joint limits, and of the costs of
  // `holds`.
  double cost(const std::vector<TurnedPoint>& at, const std::vector<RotationHold>& holds) const;

private:
  // Returns the sum of the squares of all jerks, and the jerks, one per stencil.
  template <typename JointsAt>
  double jerksOf(const JointsAt& jointsAt, std::vector<robot::JointVector>& jerks) const;
  double limitCost(const robot::JointVector& q) const;
  Place placeOf(const TurnedPoint& at) const;
  Place weightOf(const RotationHold& hold, std::size_t i) const;
  robot::JointRates ratesOf(const robot::ArmJacobian& jacobian,
                            const Eigen::Isometry3d& base_T_flange, const TurnedPoint& at) const;
  robot::JointRates scaled(robot::JointRates rates) const;
  bool follow(std::size_t i, const TurnedPoint& from, TurnedPoint& to,
              std::vector<Eigen::Isometry3d>& links) const;
  // The damped step of all unknowns of a point: its turn, and the unknowns of its lean and its
  // offsets. Returns false if the equations have no solution.
  using Step = std::vector<Place>;
  template <int kFree>
  bool stepOf(const std::vector<TurnedPoint>& at, const std::vector<RotationHold>& holds,
              double damping, Step& step) const;
  bool anyStepOf(const std::vector<TurnedPoint>& at, const std::vector<RotationHold>& holds,
                 double damping, Step& step) const;
  // Returns the derivative of the point's place with respect to its unknowns.
  PlaceSlope slopeOf(std::size_t i, const TurnedPoint& at, const RotationHold& hold) const;
  // Returns the point after a step; the joints are unchanged.
  TurnedPoint stepped(std::size_t i, const TurnedPoint& from, const RotationHold& hold,
                      const Place& step) const;

  const robot::Cell& cell_;
  const robot::ArmTwists& twists_;
  const std::vector<RunPoint>& points_;
  LeanCone cone_;
  std::vector<robot::JointVector> room_; // of each point's external axes; empty: they are fixed
  // number of components of a Place for leans and for external axes
  Eigen::Index leans_ = 0, axes_ = 0;
  std::vector<JerkStencil> stencils_;
  BandedRows<4> bands_;       // the part of the equations that depends on the times alone
  std::vector<double> scale_; // of joints whose jerk counts: robot::asAngle
  // jerk cost of moving a point alone, relative to the square of its place
  std::vector<Place> stiffness_;
  double limitWeight_ = 0.0;
  const Nearness* nearness_ = nullptr;
};

} // namespace voluta::motion
