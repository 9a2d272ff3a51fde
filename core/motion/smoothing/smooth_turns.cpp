#include "motion/smoothing/smooth_turns.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "motion/external_axes.h"
#include "motion/jerk.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/banded_solver.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::JointRates;
using robot::JointVector;

namespace {

constexpr std::size_t kChunk = 64;
// converts rotations [rad] to lengths [mm] where both are compared
constexpr double kReachMm = 300.0;
constexpr double kLongestStep = 0.5; // [rad] largest change of a joint between Newton steps
constexpr double kLongestFree = 1.0; // largest change of the unknowns of a lean in one step
constexpr double kSlack = 1e-9;      // margin for rounding errors of a joint at its limit
constexpr double kNearLimit = 0.9;   // relative to a joint's range
constexpr double kMinRoom = 1e-6;    // [rad or mm] minimum room of an external axis that may move
constexpr Eigen::Index kMaxAxes = 2;
// Damping relative to the diagonal. The minimum matches the rounding errors of waves over a
// thousand points.
constexpr double kMinDamping = 1e-13, kMaxDamping = 1e3, kFirstDamping = 1e-9;

// Returns how far a joint is inside the part of its range next to a limit, as a share of that part;
// `slope`: the derivative of this share with respect to the joint.
double nearLimit(const robot::JointLimits& l, double q, double& slope) {
  const double half = 0.5 * (l.max - l.min), off = q - l.min - half;
  slope = std::copysign(1.0 / (half * (1.0 - kNearLimit)), off);
  return std::max(0.0, (std::abs(off) / half - kNearLimit) / (1.0 - kNearLimit));
}

// Maps an unbounded number to an offset shorter than `room`, and back.
double offsetAt(double free, double room) {
  return room * free / std::sqrt(1.0 + free * free);
}
double freeOfOffset(double offset, double room) {
  return offset / std::sqrt(room * room - offset * offset);
}

} // namespace

Eigen::Quaterniond TurnedPoint::tool(const Eigen::Quaterniond& own) const {
  return turned(leant(own, lean), rotation);
}

RotationSmoother::RotationSmoother(const robot::Cell& cell, const robot::ArmTwists& twists,
                                   const std::vector<RunPoint>& points, std::vector<double> times,
                                   double coneRad, double axesRad)
    : cell_(cell), twists_(twists), points_(points), cone_{coneRad} {
  base::require(points.size() == times.size(), "RotationSmoother: a time for each point");
  leans_ = coneRad > 0.0 ? 2 : 0;
  axes_ = axesRad > 0.0 ? static_cast<Eigen::Index>(cell.externalAxes().size()) : 0;
  base::require(axes_ <= kMaxAxes && (axes_ == 0 || !cell.rod()),
                "RotationSmoother: one or two external axes that carry the platform");
  stencils_ = jerkStencils(times);
  for (Eigen::Index j = 0; j < cell.armDof() + axes_; ++j)
    scale_.push_back(robot::asAngle(cell.limits()[static_cast<std::size_t>(j)].kind, 1.0));
  for (std::size_t i = 0; axes_ > 0 && i < points.size(); ++i) {
    room_.push_back(JointVector::Zero(axes_));
    for (Eigen::Index k = 0; k < axes_; ++k) {
      const auto& l = cell.externalAxes()[static_cast<std::size_t>(k)].limits;
      const double own = points[i].at.axes[k];
      room_[i][k] =
          std::max(0.0, std::min({robot::fromAngle(l.kind, axesRad), own - l.min, l.max - own}));
    }
  }
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
    TurnedPoint own;
    own.q = q[i];
    const JointRates rates = scaled(ratesOf(jacobian, base_T_flange, own));
    Place stiffness = rates.colwise().squaredNorm().transpose();
    if (leans_ > 0) // the same in all directions
      stiffness.segment<2>(1).setConstant(0.5 * stiffness.segment<2>(1).sum());
    stiffness_.emplace_back(bands_[i][0] * stiffness);
  }
  limitWeight_ = points.empty() ? 0.0 : sum / static_cast<double>(points.size());
}

Place RotationSmoother::placeOf(const TurnedPoint& at) const {
  Place place = Place::Zero(1 + leans_ + axes_);
  place[0] = at.rotation;
  place.segment(1, leans_) = at.lean.head(leans_);
  if (at.offset.size() > 0)
    place.tail(axes_) = at.offset;
  return place;
}

// Fixed values do not change and therefore cost nothing.
Place RotationSmoother::weightOf(const RotationHold& hold, std::size_t i) const {
  Place weight = Place::Constant(1 + leans_ + axes_, hold.stay == kHeld ? 0.0 : hold.stay);
  weight.segment(1, leans_).setConstant(hold.upright == kHeld ? 0.0 : hold.upright);
  return stiffness_[i].cwiseProduct(weight);
}

JointRates RotationSmoother::scaled(JointRates rates) const {
  for (std::size_t j = 0; j < scale_.size(); ++j)
    rates.row(static_cast<Eigen::Index>(j)) *= scale_[j];
  return rates;
}

template <typename JointsAt>
double RotationSmoother::jerksOf(const JointsAt& jointsAt, std::vector<JointVector>& jerks) const {
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

double RotationSmoother::limitCost(const JointVector& q) const {
  double cost = 0.0, slope = 0.0;
  for (Eigen::Index j = 0; j < cell_.armDof(); ++j) {
    const double beyond = nearLimit(cell_.robot().limits[static_cast<std::size_t>(j)], q[j], slope);
    cost += limitWeight_ * beyond * beyond;
  }
  if (nearness_) {
    const double near = std::max(0.0, nearness_->value(q));
    cost += limitWeight_ * near * near;
  }
  return cost;
}

double RotationSmoother::cost(const std::vector<TurnedPoint>& at,
                              const std::vector<RotationHold>& holds) const {
  std::vector<JointVector> jerks;
  double sum = jerksOf([&](std::size_t i) -> const JointVector& { return at[i].q; }, jerks);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Place place = placeOf(at[i]);
    sum += limitCost(at[i].q);
    sum += weightOf(holds[i], i).dot(place.cwiseAbs2());
    if (i > 0 && holds[i].together > 0.0)
      sum += holds[i].together * stiffness_[i].dot((place - placeOf(at[i - 1])).cwiseAbs2());
  }
  return sum;
}

// Twists of the flange as the tool turns about its axis and leans: in the same direction if the
// nozzle moves, inverted if the plate does. External axes carry the tool along with the platform.
JointRates RotationSmoother::ratesOf(const robot::ArmJacobian& jacobian,
                                     const Isometry3d& base_T_flange, const TurnedPoint& at) const {
  Isometry3d base_T_tool = cell_.base_T_fixed();
  double sign = -1.0;
  if (cell_.nozzleMount() == robot::Mount::Flange) {
    base_T_tool = base_T_flange * cell_.flange_T_moved();
    sign = 1.0;
  }
  Eigen::Matrix3d turns; // one column each, in the tool's axes
  turns.col(0) = Vector3d::UnitZ();
  turns.rightCols<2>() =
      Eigen::AngleAxisd(-at.rotation, Vector3d::UnitZ()).toRotationMatrix() * leanRates(at.lean);
  robot::ArmTwistSet twists(6, 1 + leans_ + axes_);
  for (Eigen::Index k = 0; k < 1 + leans_; ++k) {
    const Vector3d rotation = sign * (base_T_tool.linear() * turns.col(k));
    twists.col(k) << rotation.cross(base_T_flange.translation() - base_T_tool.translation()),
        rotation;
  }
  if (axes_ > 0)
    twists.rightCols(axes_) = axisTwists(cell_, axesOf(cell_, at.q), base_T_flange.translation());
  const Eigen::Index arm = cell_.armDof();
  JointRates rates = JointRates::Zero(arm + axes_, twists.cols());
  rates.topRows(arm) = robot::jointsFor(jacobian, twists, kReachMm);
  rates.bottomRightCorner(axes_, axes_).setIdentity();
  return rates;
}

bool RotationSmoother::follow(std::size_t i, const TurnedPoint& from, TurnedPoint& to,
                              std::vector<Isometry3d>& links) const {
  const RobotState& state = points_[i].at;
  const Eigen::Index dof = cell_.armDof();
  to.q = from.q;
  to.q.head(dof) += from.rate.topRows(dof) * (placeOf(to) - placeOf(from));
  if (axes_ > 0)
    to.q.tail(axes_) = state.axes + to.offset;
  const Isometry3d wanted = cell_.base_T_flange(toolPose(state.tip, to.tool(state.tool)), to.q);
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

std::vector<TurnedPoint> RotationSmoother::start(const base::RunContext& ctx) const {
  std::vector<TurnedPoint> at(points_.size());
  base::parallelChunks(ctx, points_.size(), kChunk, [&](std::size_t b, std::size_t e) {
    std::vector<Isometry3d> links;
    for (std::size_t i = b; i < e; ++i) {
      Isometry3d base_T_flange;
      at[i].q = points_[i].at.q;
      at[i].offset = JointVector::Zero(axes_);
      const robot::ArmJacobian jacobian = twists_.jacobian(at[i].q, base_T_flange, links);
      at[i].rate = ratesOf(jacobian, base_T_flange, at[i]);
    }
  });
  return at;
}

template <int kFree>
bool RotationSmoother::stepOf(const std::vector<TurnedPoint>& at,
                              const std::vector<RotationHold>& holds, double damping,
                              Step& step) const {
  using Block = Eigen::Matrix<double, kFree, kFree>;
  using Part = Eigen::Matrix<double, kFree, 1>;
  const std::size_t n = points_.size();
  std::vector<JointVector> jerks;
  jerksOf([&](std::size_t i) -> const JointVector& { return at[i].q; }, jerks);
  // Derivatives of places and of joints with respect to the unknowns; zero for fixed ones.
  std::vector<Block> slopes(n);
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, kFree, Eigen::ColMajor, 8, kFree>> rates(n);
  for (std::size_t i = 0; i < n; ++i) {
    slopes[i] = slopeOf(i, at[i], holds[i]);
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
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t m = 0; m < 4; ++m)
      if (i + m < n)
        blocks[i][m] = bands_[i][m] * rates[i].transpose().lazyProduct(rates[i + m]);
    for (Eigen::Index j = 0; j < cell_.armDof(); ++j) {
      const auto at_ = static_cast<std::size_t>(j);
      double slope = 0.0;
      const double beyond = nearLimit(cell_.robot().limits[at_], at[i].q[j], slope);
      if (beyond <= 0.0)
        continue;
      const Part by = slope / scale_[at_] * rates[i].row(j).transpose();
      blocks[i][0] += limitWeight_ * by * by.transpose();
      right[i] -= limitWeight_ * beyond * by;
    }
    if (const double near = nearness_ ? nearness_->value(at[i].q) : 0.0; near > 0.0) {
      const JointVector slope = nearness_->slope(at[i].q);
      Part by = Part::Zero();
      for (Eigen::Index j = 0; j < cell_.armDof(); ++j)
        by += slope[j] / scale_[static_cast<std::size_t>(j)] * rates[i].row(j).transpose();
      blocks[i][0] += limitWeight_ * by * by.transpose();
      right[i] -= limitWeight_ * near * by;
    }
    const Part place = placeOf(at[i]);
    // The sum of a hold is weight * (difference of the places of a and b)^2, or the weighted square
    // of a's place alone.
    const Part weight = weightOf(holds[i], i), pull = weight.cwiseProduct(place);
    blocks[i][0] += slopes[i].transpose() * weight.asDiagonal() * slopes[i];
    right[i] -= slopes[i].transpose() * pull;
    if (i > 0 && holds[i].together > 0.0) {
      const std::size_t before = i - 1;
      const Part joint = holds[i].together * stiffness_[i];
      const Part draw = joint.cwiseProduct(place - Part(placeOf(at[before])));
      blocks[i][0] += slopes[i].transpose() * joint.asDiagonal() * slopes[i];
      right[i] -= slopes[i].transpose() * draw;
      blocks[before][0] += slopes[before].transpose() * joint.asDiagonal() * slopes[before];
      right[before] += slopes[before].transpose() * draw;
      blocks[before][1] -= slopes[before].transpose() * joint.asDiagonal() * slopes[i];
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
  step.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    step[i] = Eigen::Map<const Part>(solution.data() + i * kPart);
  return true;
}

bool RotationSmoother::anyStepOf(const std::vector<TurnedPoint>& at,
                                 const std::vector<RotationHold>& holds, double damping,
                                 Step& step) const {
  switch (1 + leans_ + axes_) {
  case 1:
    return stepOf<1>(at, holds, damping, step);
  case 2:
    return stepOf<2>(at, holds, damping, step);
  case 3:
    return stepOf<3>(at, holds, damping, step);
  case 4:
    return stepOf<4>(at, holds, damping, step);
  default:
    return stepOf<5>(at, holds, damping, step);
  }
}

PlaceSlope RotationSmoother::slopeOf(std::size_t i, const TurnedPoint& at,
                                     const RotationHold& hold) const {
  PlaceSlope slope = PlaceSlope::Identity(1 + leans_ + axes_, 1 + leans_ + axes_);
  if (leans_ > 0)
    slope.block<2, 2>(1, 1) = cone_.slope(cone_.freeOf(at.lean));
  for (Eigen::Index k = 0; k < axes_; ++k) {
    const double room = room_[i][k];
    double& own = slope(1 + leans_ + k, 1 + leans_ + k);
    own = 0.0;
    if (room > kMinRoom) {
      const double share = at.offset[k] / room; // sine of the angle whose tangent is the unknown
      own = room * std::pow(1.0 - share * share, 1.5);
    }
  }
  if (hold.stay == kHeld) {
    slope(0, 0) = 0.0;
    slope.rightCols(axes_).setZero();
  }
  if (hold.upright == kHeld)
    slope.middleCols(1, leans_).setZero();
  return slope;
}

TurnedPoint RotationSmoother::stepped(std::size_t i, const TurnedPoint& from,
                                      const RotationHold& hold, const Place& step) const {
  TurnedPoint to = from;
  to.rotation += step[0];
  if (leans_ > 0 && hold.upright != kHeld)
    to.lean = cone_.at(cone_.freeOf(from.lean) + step.segment<2>(1));
  for (Eigen::Index k = 0; k < axes_; ++k)
    if (const double by = step[1 + leans_ + k]; by != 0.0)
      to.offset[k] = offsetAt(freeOfOffset(from.offset[k], room_[i][k]) + by, room_[i][k]);
  return to;
}

void RotationSmoother::smooth(std::vector<TurnedPoint>& at, const std::vector<RotationHold>& wanted,
                              const RotationSmoothing& options, const base::RunContext& ctx) const {
  const std::size_t n = points_.size();
  base::require(at.size() == n && wanted.size() == n, "RotationSmoother: as many turns as points");
  if (n < 4)
    return;
  std::vector<RotationHold> holds = wanted;
  double now = cost(at, holds), damping = kFirstDamping;
  Step step;
  std::vector<TurnedPoint> next(n);
  std::vector<char> lost(n);
  for (int round = 0; round < options.rounds; ++round) {
    double longest = 0.0;
    const auto solved = [&] {
      if (!anyStepOf(at, holds, damping, step))
        return false;
      longest = 0.0;
      for (const Place& s : step)
        longest = std::max({longest, std::abs(s[0]) / options.maxRotation,
                            s.segment(1, leans_).norm() / kLongestFree,
                            s.tail(axes_).norm() / kLongestFree});
      return longest <= 1.0;
    };
    while (!solved() && damping < kMaxDamping)
      damping *= 10.0;
    if (damping >= kMaxDamping)
      return;
    base::parallelChunks(ctx, n, kChunk, [&](std::size_t b, std::size_t e) {
      std::vector<Isometry3d> links;
      for (std::size_t i = b; i < e; ++i) {
        lost[i] = 0;
        next[i] = at[i];
        if (step[i].isZero(0.0))
          continue;
        next[i] = stepped(i, at[i], holds[i], step[i]);
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
      damping = std::max(kMinDamping, 0.1 * damping);
      if (gain < options.enough)
        return;
    } else {
      damping *= 100.0;
    }
  }
}

} // namespace voluta::motion
