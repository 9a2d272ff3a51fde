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
using robot::JointRates;
using robot::JointVector;

namespace {

constexpr std::size_t kChunk = 64;
constexpr double kReachMm = 300.0;   // what a turn counts beside mm
constexpr double kLongestStep = 0.5; // rad, of a joint between Newton's steps
constexpr double kLongestFree = 1.0; // of what a lean is made of, in a step
constexpr double kSlack = 1e-9;      // a joint at its limit must not be lost to rounding
constexpr double kNearLimit = 0.9;   // of a joint's range
// Of the diagonal. The least is what rounding leaves of waves of a thousand points.
constexpr double kLeastDamping = 1e-13, kMostDamping = 1e3, kFirstDamping = 1e-9;

// What holds work on.
Vector3d placeOf(const TurnedPoint& at) {
  return {at.turn, at.lean.x(), at.lean.y()};
}

// What is held fast does not change, and costs nothing.
Vector3d weightOf(const TurnHold& hold, const Vector3d& stiffness) {
  const double turn = hold.stay == kHeld ? 0.0 : hold.stay;
  const double lean = hold.upright == kHeld ? 0.0 : hold.upright;
  return stiffness.cwiseProduct(Vector3d(turn, lean, lean));
}

} // namespace

Eigen::Quaterniond TurnedPoint::tool(const Eigen::Quaterniond& own) const {
  return turned(leant(own, lean), turn);
}

TurnSmoother::TurnSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
                           const std::vector<RunPoint>& points, std::vector<double> times,
                           double coneRad)
    : cell_(cell), twists_(twists), points_(points), cone_{coneRad} {
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
    const JointRates rates = scaled(ratesOf(jacobian, base_T_flange, {}));
    const double lean = rates.rightCols(rates.cols() - 1).squaredNorm() / 2.0;
    stiffness_.push_back(bands_[i][0] * Vector3d(rates.col(0).squaredNorm(), lean, lean));
  }
  limitWeight_ = points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

JointRates TurnSmoother::scaled(JointRates rates) const {
  for (std::size_t j = 0; j < scale_.size(); ++j)
    rates.row(static_cast<Eigen::Index>(j)) *= scale_[j];
  return rates;
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
    sum += weightOf(holds[i], stiffness_[i]).dot(placeOf(at[i]).cwiseAbs2());
    if (i > 0 && holds[i].together > 0.0)
      sum +=
          holds[i].together * stiffness_[i].dot((placeOf(at[i]) - placeOf(at[i - 1])).cwiseAbs2());
  }
  return sum;
}

// Twists of the flange as the tool turns about its axis and leans: with it where the nozzle moves,
// the other way about where the plate does.
JointRates TurnSmoother::ratesOf(const robot::ArmJacobian& jacobian,
                                 const Isometry3d& base_T_flange, const TurnedPoint& at) const {
  Isometry3d base_T_tool = cell_.base_T_fixed();
  double way = -1.0;
  if (cell_.nozzleMount() == robot::Mount::Flange) {
    base_T_tool = base_T_flange * cell_.flange_T_moved();
    way = 1.0;
  }
  Eigen::Matrix3d turns; // a column each, in the tool's axes
  turns.col(0) = Vector3d::UnitZ();
  turns.rightCols<2>() =
      Eigen::AngleAxisd(-at.turn, Vector3d::UnitZ()).toRotationMatrix() * leanRates(at.lean);
  robot::ArmTwistSet twists(6, cone_.rad > 0.0 ? 3 : 1);
  for (Eigen::Index k = 0; k < twists.cols(); ++k) {
    const Vector3d turn = way * (base_T_tool.linear() * turns.col(k));
    twists.col(k) << turn.cross(base_T_flange.translation() - base_T_tool.translation()), turn;
  }
  return robot::jointsFor(jacobian, twists, kReachMm);
}

bool TurnSmoother::follow(std::size_t i, const TurnedPoint& from, TurnedPoint& to,
                          std::vector<Isometry3d>& links) const {
  const RobotState& state = points_[i].at;
  const Isometry3d wanted = cell_.base_T_flange(toolPose(state.tip, to.tool(state.tool)), state.q);
  const Eigen::Index dof = cell_.armDof();
  to.q = from.q;
  to.q.head(dof) += from.rate * (placeOf(to) - placeOf(from)).head(from.rate.cols());
  robot::ArmJacobian jacobian;
  if (!twists_.follow(wanted, kLongestStep, to.q, jacobian, links))
    return false;
  for (Eigen::Index j = 0; j < dof; ++j) {
    const robot::JointLimits& l = cell_.robot().limits[static_cast<std::size_t>(j)];
    if (to.q[j] < l.min - kSlack || to.q[j] > l.max + kSlack)
      return false;
    to.q[j] = std::clamp(to.q[j], l.min, l.max);
  }
  to.rate = ratesOf(jacobian, wanted, to);
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
      at[i].rate = ratesOf(jacobian, base_T_flange, at[i]);
    }
  });
  return at;
}

template <int kFree>
bool TurnSmoother::stepOf(const std::vector<TurnedPoint>& at, const std::vector<TurnHold>& holds,
                          double damping, std::vector<Vector3d>& step) const {
  using Block = Eigen::Matrix<double, kFree, kFree>;
  using Part = Eigen::Matrix<double, kFree, 1>;
  const std::size_t n = points_.size();
  const auto dof = static_cast<Eigen::Index>(scale_.size());
  std::vector<JointVector> jerks;
  jerksOf([&](std::size_t i) -> const JointVector& { return at[i].q; }, jerks);
  // Of turn and lean, and of the joints, by the unknowns; nothing goes with what is held fast.
  std::vector<Block> slopes(n, Block::Identity());
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, kFree, Eigen::ColMajor, 8, kFree>> rates(n);
  for (std::size_t i = 0; i < n; ++i) {
    if constexpr (kFree == 3)
      slopes[i].template bottomRightCorner<2, 2>() = cone_.slope(cone_.freeOf(at[i].lean));
    if (holds[i].stay == kHeld)
      slopes[i](0, 0) = 0.0;
    if (kFree > 1 && holds[i].upright == kHeld)
      slopes[i].rightCols(kFree - 1).setZero();
    rates[i] = scaled(at[i].rate) * slopes[i];
  }
  std::vector<Part> right(n, Part::Zero());
  for (std::size_t s = 0; s < stencils_.size(); ++s)
    for (std::size_t k = 0; k < 4; ++k)
      if (stencils_[s].last + k >= 3 && stencils_[s].last + k - 3 < n) {
        const std::size_t i = stencils_[s].last + k - 3;
        right[i] -= stencils_[s].weight[k] * (rates[i].transpose() * jerks[s]);
      }
  std::vector<std::array<Block, 4>> blocks(n);
  JointVector slope;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t m = 0; m < 4; ++m)
      if (i + m < n)
        blocks[i][m] = bands_[i][m] * rates[i].transpose().lazyProduct(rates[i + m]);
    limitCost(at[i].q, &slope);
    for (Eigen::Index j = 0; j < dof; ++j)
      if (slope[j] != 0.0) {
        const auto at_ = static_cast<std::size_t>(j);
        const robot::JointLimits& l = cell_.robot().limits[at_];
        const double half = 0.5 * (l.max - l.min);
        const double beyond =
            (std::abs(at[i].q[j] - l.min - half) / half - kNearLimit) / (1.0 - kNearLimit);
        const Part by = slope[j] / scale_[at_] * rates[i].row(j).transpose();
        blocks[i][0] += limitWeight_ * by * by.transpose();
        right[i] -= limitWeight_ * beyond * by;
      }
    // A hold's sum is that of weight * (a's place - b's)^2, or of a's alone.
    const auto hold = [&](const Part& weight, std::size_t a, const std::size_t* b) {
      Vector3d off = placeOf(at[a]);
      if (b)
        off -= placeOf(at[*b]);
      const Part pull = weight.cwiseProduct(off.template head<kFree>());
      blocks[a][0] += slopes[a].transpose() * weight.asDiagonal() * slopes[a];
      right[a] -= slopes[a].transpose() * pull;
      if (!b)
        return;
      blocks[*b][0] += slopes[*b].transpose() * weight.asDiagonal() * slopes[*b];
      right[*b] += slopes[*b].transpose() * pull;
      blocks[*b][1] -= slopes[*b].transpose() * weight.asDiagonal() * slopes[a];
    };
    hold(weightOf(holds[i], stiffness_[i]).template head<kFree>(), i, nullptr);
    if (i > 0 && holds[i].together > 0.0) {
      const std::size_t before = i - 1;
      hold(holds[i].together * stiffness_[i].template head<kFree>(), i, &before);
    }
  }
  constexpr auto kPart = static_cast<std::size_t>(kFree);
  BandedRows<4 * kPart> rows(n * kPart);
  std::vector<double> asked(n * kPart), solution;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t a = 0; a < kPart; ++a) {
      auto& row = rows[i * kPart + a];
      row.fill(0.0);
      const auto r = static_cast<Eigen::Index>(a);
      for (std::size_t m = 0; m < 4 && i + m < n; ++m)
        for (std::size_t b = m == 0 ? a : 0; b < kPart; ++b)
          row[m * kPart + b - a] = blocks[i][m](r, static_cast<Eigen::Index>(b));
      asked[i * kPart + a] = right[i][r];
      if (slopes[i](r, r) == 0.0)
        row[0] = 1.0;
      row[0] *= 1.0 + damping;
      if (!(row[0] > 0.0))
        return false;
    }
  if (!solveBanded(rows, asked, solution))
    return false;
  step.assign(n, Vector3d::Zero());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t a = 0; a < kPart; ++a)
      step[i][static_cast<Eigen::Index>(a)] = solution[i * kPart + a];
  return true;
}

void TurnSmoother::smooth(std::vector<TurnedPoint>& at, const std::vector<TurnHold>& wanted,
                          const TurnSmoothing& options, const base::RunContext& ctx) const {
  const std::size_t n = points_.size();
  base::require(at.size() == n && wanted.size() == n, "TurnSmoother: as many turns as points");
  if (n < 4)
    return;
  std::vector<TurnHold> holds = wanted;
  double now = cost(at, holds), damping = kFirstDamping;
  std::vector<Vector3d> step;
  std::vector<TurnedPoint> next(n);
  std::vector<char> lost(n);
  for (int round = 0; round < options.rounds; ++round) {
    double longest = 0.0;
    const auto solved = [&] {
      if (!(cone_.rad > 0.0 ? stepOf<3>(at, holds, damping, step)
                            : stepOf<1>(at, holds, damping, step)))
        return false;
      longest = 0.0;
      for (const Vector3d& s : step)
        longest = std::max(
            {longest, std::abs(s[0]) / options.longestTurn, s.tail<2>().norm() / kLongestFree});
      return longest <= 1.0;
    };
    while (!solved() && damping < kMostDamping)
      damping *= 10.0;
    if (damping >= kMostDamping)
      return;
    base::parallelChunks(ctx, n, kChunk, [&](std::size_t b, std::size_t e) {
      std::vector<Isometry3d> links;
      for (std::size_t i = b; i < e; ++i) {
        lost[i] = 0;
        next[i] = at[i];
        if (step[i].isZero(0.0))
          continue;
        next[i].turn += step[i][0];
        if (cone_.rad > 0.0 && holds[i].upright != kHeld)
          next[i].lean = cone_.at(cone_.freeOf(at[i].lean) + step[i].tail<2>());
        lost[i] = !follow(i, at[i], next[i], links);
      }
    });
    bool followed = true;
    for (std::size_t i = 0; i < n; ++i)
      if (lost[i]) {
        holds[i].stay = holds[i].upright = kHeld;
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
