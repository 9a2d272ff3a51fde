#include "program/merged_points.h"

#include "program/common/blend.h"
#include "program/common/motion_targets.h"
#include "program/motion_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace voluta::program {

namespace {

constexpr double kSlack = 1e-9; // for rounding errors

class Merger {
public:
  // Fills `pointOf`, one entry per point.
  Merger(const ProgramInput& input, const MergeLimits& limits, std::vector<std::size_t>& pointOf,
         const base::RunContext& ctx)
      : in_(input.trajectory), limits_(limits), targets_(motionTargets(input, ctx)),
        fit_(input, limits, targets_), pointOf_(pointOf) {}

  plan::Trajectory run() {
    out_.dof = in_.dof;
    out_.firstTool = in_.firstTool;
    keep(0, 0);
    for (std::size_t from = 0; from + 1 < in_.pointCount();) {
      std::size_t to = from + 1;
      while ((isShort(from, to) && canGoOn(to) && fit_.isLine(from, to + 1)) ||
             (turnsOn(to) && onJointLine(from, to + 1)))
        ++to;
      if (const std::optional<Eigen::Vector3d> via = arcInstead(from, to))
        arcs_.push_back({out_.pointCount(), *via});
      keep(from + 1, to);
      from = to;
    }
    for (plan::TrajectoryEvent event : in_.events) {
      event.point = event.point < pointOf_.size() ? pointOf_[event.point] : out_.pointCount();
      out_.events.push_back(event);
    }
    return std::move(out_);
  }
  std::vector<ArcVia> takeArcs() { return std::move(arcs_); }

private:
  // Replaces the motions to `first` ... `to` by one motion to `to`.
  void keep(std::size_t first, std::size_t to) {
    plan::Trajectory& t = out_;
    for (std::size_t i = first; i <= to; ++i)
      pointOf_[i] = t.pointCount();
    t.joints.insert(t.joints.end(), in_.at(to), in_.at(to) + in_.dof);
    t.timeS.push_back(in_.timeS[to]);
    t.move.push_back(in_.move[to]);
    t.waypoint.push_back(in_.waypoint[to]);
    t.extrudedMm3.push_back(in_.extrudedMm3[to]);
  }

  // An arc in Base takes no time of its own, so that the arm would brake between two of them at a
  // corner, and the flow would not.
  bool slowsAtCorner(std::size_t from) const {
    constexpr double kSharpRad = 0.35;
    return limits_.inBase && !arcs_.empty() && arcs_.back().point + 1 == out_.pointCount() &&
           from > 0 && from + 1 < in_.pointCount() &&
           angleRad(targets_[from].tipMm - targets_[from - 1].tipMm,
                    targets_[from + 1].tipMm - targets_[from].tipMm) > kSharpRad;
  }

  // Returns a point on an arc that replaces more motions than the line to `to`, and sets `to` to
  // its end.
  std::optional<Eigen::Vector3d> arcInstead(std::size_t from, std::size_t& to) const {
    constexpr std::size_t kMinMotions = 3;
    std::optional<Eigen::Vector3d> via;
    if (!(limits_.arcMm > 0.0) || slowsAtCorner(from))
      return via;
    for (std::size_t end = from + 1; end < in_.pointCount() && isPrint(in_, end); ++end) {
      if (end >= from + kMinMotions) {
        const std::optional<Eigen::Vector3d> next = fit_.arcVia(from, end);
        if (!next)
          break;
        if (end > to) {
          via = next;
          to = end;
        }
      }
      if (!canGoOn(end))
        break;
    }
    return via;
  }

  double lengthMm(std::size_t from, std::size_t to) const {
    return (targets_[to].tipMm - targets_[from].tipMm).norm();
  }
  bool isShort(std::size_t from, std::size_t to) const {
    return isPrint(in_, to) && (limits_.all || in_.timeS[to] - in_.timeS[from] < limits_.minS ||
                                lengthMm(from, to) < limits_.minMm);
  }
  // A bead's last point is kept, and so is the point before an event.
  bool canGoOn(std::size_t to) const {
    return to + 1 < in_.pointCount() && isPrint(in_, to + 1) && in_.eventsBefore(to + 1).empty();
  }

  bool turns(std::size_t i) const { return in_.move[i] == plan::MoveKind::Joint; }
  // Returns whether the motions to `to` and to the next point are joint motions.
  bool turnsOn(std::size_t to) const {
    return limits_.jointRad > 0.0 && to + 1 < in_.pointCount() && turns(to) && turns(to + 1) &&
           in_.eventsBefore(to + 1).empty();
  }
  Eigen::Map<const Eigen::VectorXd> joints(std::size_t i) const { return {in_.at(i), in_.dof}; }

  // Returns whether all points in between are on the line between both in joint space, each further
  // along it. Where the arm does not move, a print ends or is resumed; such points are kept.
  bool onJointLine(std::size_t from, std::size_t to) const {
    const Eigen::VectorXd a = joints(from), step = joints(to) - a;
    const double squared = step.squaredNorm();
    if (!(squared > 0.0))
      return false;
    double last = 0.0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double u = (joints(i) - a).dot(step) / squared;
      if (!(u > last && u < 1.0 - kSlack) ||
          (joints(i) - a - u * step).cwiseAbs().maxCoeff() > limits_.jointRad)
        return false;
      last = u;
    }
    return true;
  }

  const plan::Trajectory& in_;
  const MergeLimits& limits_;
  std::vector<MotionTarget> targets_;
  MotionFit fit_;
  std::vector<std::size_t>& pointOf_;
  plan::Trajectory out_;
  std::vector<ArcVia> arcs_;
};

// All later points are delayed accordingly.
void slowShortMotions(plan::Trajectory& trajectory, double minS) {
  double before = trajectory.timeS.empty() ? 0.0 : trajectory.timeS.front(), late = 0.0;
  for (std::size_t i = 1; i < trajectory.pointCount(); ++i) {
    const double takes = trajectory.timeS[i] - before;
    before = trajectory.timeS[i];
    // A motion without duration does not move.
    late += takes > 0.0 ? std::max(0.0, minS - takes) : 0.0;
    trajectory.timeS[i] += late;
  }
}

} // namespace

MergedPoints mergedPoints(const ProgramInput& input, const MergeLimits& limits,
                          const base::RunContext& ctx) {
  const plan::Trajectory& planned = input.trajectory;
  const bool joins = limits.minS > 0.0 || limits.minMm > 0.0 || limits.jointRad > 0.0 ||
                     limits.all || limits.arcMm > 0.0;
  std::vector<std::size_t> pointOf(planned.pointCount());
  std::iota(pointOf.begin(), pointOf.end(), std::size_t{0});
  if (!joins && limits.motionS <= 0.0)
    return {std::shared_ptr<const plan::Trajectory>(std::shared_ptr<void>(), &planned),
            std::move(pointOf),
            {}};
  std::vector<ArcVia> arcs;
  auto merged = std::make_shared<plan::Trajectory>();
  if (joins) {
    Merger merger(input, limits, pointOf, ctx);
    *merged = merger.run();
    arcs = merger.takeArcs();
  } else {
    *merged = planned;
  }
  slowShortMotions(*merged, limits.motionS);
  return {std::move(merged), std::move(pointOf), std::move(arcs)};
}

} // namespace voluta::program
