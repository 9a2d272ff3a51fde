#include "motion/smooth_turns.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "motion/banded_solver.h"
#include "motion/jerk.h"
#include "motion/nozzle_frame.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr std::size_t kChunk = 64;
constexpr double kReachMm = 300.0;   // what a turn counts beside mm
constexpr double kLongestStep = 0.5; // rad, of a joint between Newton's steps
constexpr double kSlack = 1e-9;      // a joint at its limit must not be lost to rounding
constexpr double kNearLimit = 0.9;   // of a joint's range
// Of the diagonal. The least is what rounding leaves of waves of a thousand points.
constexpr double kLeastDamping = 1e-13, kMostDamping = 1e3, kFirstDamping = 1e-9;

} // namespace

TurnSmoother::TurnSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
                           const std::vector<RunPoint>& points, std::vector<double> times)
    : cell_(cell), twists_(twists), points_(points) {
  base::require(points.size() == times.size(), "TurnSmoother: a time for each point");
  stencils_ = jerkStencils(times);
  for (const robot::JointLimits& limit : cell.robot().limits)
    scale_.push_back(robot::asTurn(limit.kind, 1.0));
  bands_.assign(points.size(), {});
  for (const JerkStencil& s : stencils_)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t m = k; m < 4; ++m)
        if (s.last + k >= 3 && s.last + m - 3 < points.size())
          bands_[s.last + k - 3][m - k] += s.weight[k] * s.weight[m];
  std::vector<JointVector> q;
  for (const RunPoint& p : points)
    q.push_back(p.at.q);
  std::vector<JointVector> jerks;
  const double sum = jerksOf([&](std::size_t i) -> const JointVector& { return q[i]; }, jerks);
  std::vector<Isometry3d> links;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Isometry3d base_T_flange;
    const robot::ArmJacobian jacobian = twists_.jacobian(q[i], base_T_flange, links);
    stiffness_.push_back(bands_[i][0] * scaled(rateOf(jacobian, base_T_flange)).squaredNorm());
  }
  limitWeight_ = points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

JointVector TurnSmoother::scaled(JointVector rate) const {
  for (std::size_t j = 0; j < scale_.size(); ++j)
    rate[static_cast<Eigen::Index>(j)] *= scale_[j];
  return rate;
}

template <typename JointsAt>
double TurnSmoother::jerksOf(const JointsAt& jointsAt, std::vector<JointVector>& jerks) const {
  const auto dof = static_cast<Eigen::Index>(scale_.size());
  jerks.assign(stencils_.size(), JointVector::Zero(dof));
  double sum = 0.0;
  for (std::size_t n = 0; n < stencils_.size(); ++n) {
    const JerkStencil& s = stencils_[n];
    for (std::size_t k = 0; k < 4; ++k)
      if (s.last + k >= 3 && s.last + k - 3 < points_.size())
        jerks[n] += s.weight[k] * jointsAt(s.last + k - 3).head(dof);
    for (Eigen::Index j = 0; j < dof; ++j)
      jerks[n][j] *= scale_[static_cast<std::size_t>(j)];
    sum += jerks[n].squaredNorm();
  }
  return sum;
}

double TurnSmoother::limitCost(const JointVector& q, JointVector* slope) const {
  double cost = 0.0;
  if (slope)
    slope->setZero(static_cast<Eigen::Index>(scale_.size()));
  for (std::size_t j = 0; j < scale_.size(); ++j) {
    const robot::JointLimits& l = cell_.robot().limits[j];
    const double half = 0.5 * (l.max - l.min), off = q[static_cast<Eigen::Index>(j)] - l.min - half;
    const double beyond = (std::abs(off) / half - kNearLimit) / (1.0 - kNearLimit);
    if (beyond <= 0.0)
      continue;
    cost += limitWeight_ * beyond * beyond;
    if (slope) // of the residual beyond * sqrt(weight), by the joint
      (*slope)[static_cast<Eigen::Index>(j)] =
          std::copysign(1.0 / (half * (1.0 - kNearLimit)), off);
  }
  return cost;
}

double TurnSmoother::cost(const std::vector<TurnedPoint>& at,
                          const std::vector<TurnHold>& holds) const {
  std::vector<JointVector> jerks;
  double sum = jerksOf([&](std::size_t i) -> const JointVector& { return at[i].q; }, jerks);
  for (std::size_t i = 0; i < at.size(); ++i) {
    sum += limitCost(at[i].q, nullptr);
    if (holds[i].stay != kHeld)
      sum += holds[i].stay * stiffness_[i] * at[i].turn * at[i].turn;
    if (i > 0 && holds[i].together > 0.0) {
      const double step = at[i].turn - at[i - 1].turn;
      sum += holds[i].together * stiffness_[i] * step * step;
    }
  }
  return sum;
}

// Twist of the flange by the turn about the nozzle: about the tool's axis where the nozzle moves,
// the other way about it where the plate does.
JointVector TurnSmoother::rateOf(const robot::ArmJacobian& jacobian,
                                 const Isometry3d& base_T_flange) const {
  Isometry3d base_T_tool = cell_.base_T_fixed();
  double way = -1.0;
  if (cell_.nozzleMount() == robot::Mount::Flange) {
    base_T_tool = base_T_flange * cell_.flange_T_moved();
    way = 1.0;
  }
  const Vector3d turn = way * base_T_tool.linear().col(2);
  Eigen::Matrix<double, 6, 1> twist;
  twist << turn.cross(base_T_flange.translation() - base_T_tool.translation()), turn;
  return robot::jointsFor(jacobian, twist, kReachMm);
}

bool TurnSmoother::follow(std::size_t i, double turn, const TurnedPoint& from, TurnedPoint& to,
                          std::vector<Isometry3d>& links) const {
  const RobotState& state = points_[i].at;
  const Isometry3d wanted =
      cell_.base_T_flange(toolPose(state.tip, turned(state.tool, turn)), state.q);
  const Eigen::Index dof = cell_.armDof();
  to.turn = turn;
  to.q = from.q;
  to.q.head(dof) += (turn - from.turn) * from.rate;
  robot::ArmJacobian jacobian;
  if (!twists_.follow(wanted, kLongestStep, to.q, jacobian, links))
    return false;
  for (Eigen::Index j = 0; j < dof; ++j) {
    const robot::JointLimits& l = cell_.robot().limits[static_cast<std::size_t>(j)];
    if (to.q[j] < l.min - kSlack || to.q[j] > l.max + kSlack)
      return false;
    to.q[j] = std::clamp(to.q[j], l.min, l.max);
  }
  to.rate = rateOf(jacobian, wanted);
  return to.rate.allFinite();
}

std::vector<TurnedPoint> TurnSmoother::start(const base::RunContext& ctx) const {
  std::vector<TurnedPoint> at(points_.size());
  base::parallelChunks(ctx, points_.size(), kChunk, [&](std::size_t b, std::size_t e) {
    std::vector<Isometry3d> links;
    for (std::size_t i = b; i < e; ++i) {
      Isometry3d base_T_flange;
      at[i].q = points_[i].at.q;
      const robot::ArmJacobian jacobian = twists_.jacobian(at[i].q, base_T_flange, links);
      at[i].rate = rateOf(jacobian, base_T_flange);
    }
  });
  return at;
}

bool TurnSmoother::stepOf(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
                          double damping, std::vector<double>& step) const {
  const std::size_t n = points_.size();
  const auto dof = static_cast<Eigen::Index>(scale_.size());
  std::vector<JointVector> jerks, rates(n);
  jerksOf([&](std::size_t i) -> const JointVector& { return at[i].q; }, jerks);
  for (std::size_t i = 0; i < n; ++i)
    rates[i] = scaled(at[i].rate);
  std::vector<double> right(n, 0.0);
  for (std::size_t s = 0; s < stencils_.size(); ++s)
    for (std::size_t k = 0; k < 4; ++k)
      if (stencils_[s].last + k >= 3 && stencils_[s].last + k - 3 < n) {
        const std::size_t i = stencils_[s].last + k - 3;
        right[i] -= stencils_[s].weight[k] * jerks[s].dot(rates[i]);
      }
  BandedRows rows(n);
  JointVector slope;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t m = 0; m < 4; ++m)
      rows[i][m] = i + m < n && holds[i].stay != kHeld && holds[i + m].stay != kHeld
                       ? bands_[i][m] * rates[i].dot(rates[i + m])
                       : 0.0;
    if (holds[i].stay == kHeld) {
      rows[i][0] = 1.0;
      right[i] = 0.0;
      continue;
    }
    limitCost(at[i].q, &slope);
    for (Eigen::Index j = 0; j < dof; ++j)
      if (slope[j] != 0.0) {
        const robot::JointLimits& l = cell_.robot().limits[static_cast<std::size_t>(j)];
        const double half = 0.5 * (l.max - l.min);
        const double beyond =
            (std::abs(at[i].q[j] - l.min - half) / half - kNearLimit) / (1.0 - kNearLimit);
        const double by = slope[j] * at[i].rate[j];
        rows[i][0] += limitWeight_ * by * by;
        right[i] -= limitWeight_ * beyond * by;
      }
    rows[i][0] += holds[i].stay * stiffness_[i];
    right[i] -= holds[i].stay * stiffness_[i] * at[i].turn;
    for (const std::size_t other : {i - 1, i + 1}) { // wraps round: then it is no point
      const std::size_t later = std::max(i, other);
      if (other >= n || holds[later].together <= 0.0)
        continue;
      const double weight = holds[later].together * stiffness_[later];
      rows[i][0] += weight;
      right[i] -= weight * (at[i].turn - at[other].turn);
      if (other == i + 1 && holds[other].stay != kHeld)
        rows[i][1] -= weight;
    }
    rows[i][0] *= 1.0 + damping;
    if (!(rows[i][0] > 0.0))
      return false;
  }
  return solveBanded(rows, right, step);
}

void TurnSmoother::smooth(std::vector<TurnedPoint>& at, const std::vector<TurnHold>& wanted,
                          const TurnSmoothing& options, const base::RunContext& ctx) const {
  const std::size_t n = points_.size();
  base::require(at.size() == n && wanted.size() == n, "TurnSmoother: as many turns as points");
  if (n < 4)
    return;
  std::vector<TurnHold> holds = wanted;
  double now = cost(at, holds), damping = kFirstDamping;
  std::vector<double> step;
  std::vector<TurnedPoint> next(n);
  std::vector<char> lost(n);
  for (int round = 0; round < options.rounds; ++round) {
    double longest = 0.0;
    const auto solved = [&] {
      if (!stepOf(at, holds, damping, step))
        return false;
      longest = 0.0;
      for (const double s : step)
        longest = std::max(longest, std::abs(s));
      return longest <= options.longestTurn;
    };
    while (!solved() && damping < kMostDamping)
      damping *= 10.0;
    if (damping >= kMostDamping)
      return;
    base::parallelChunks(ctx, n, kChunk, [&](std::size_t b, std::size_t e) {
      std::vector<Isometry3d> links;
      for (std::size_t i = b; i < e; ++i) {
        lost[i] = 0;
        if (holds[i].stay == kHeld || step[i] == 0.0)
          next[i] = at[i];
        else
          lost[i] = !follow(i, at[i].turn + step[i], at[i], next[i], links);
      }
    });
    bool followed = true;
    for (std::size_t i = 0; i < n; ++i)
      if (lost[i]) {
        holds[i].stay = kHeld;
        followed = false;
      }
    if (!followed) {
      now = cost(at, holds);
      continue;
    }
    const double then = cost(next, holds);
    if (then < now) {
      const double gain = 1.0 - then / now;
      std::swap(at, next);
      now = then;
      damping = std::max(kLeastDamping, 0.1 * damping);
      if (gain < options.enough)
        return;
    } else {
      damping *= 100.0;
    }
  }
}

} // namespace voluta::motion
