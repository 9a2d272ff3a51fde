#include "motion/smoothing/local_filter.h"

#include "base/run_context.h"
#include "motion/jerk.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/smooth_turns.h"
#include "motion/timed_points.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

namespace {

constexpr std::size_t kMargin = 3; // held points on both sides, on which the jerks inside depend
constexpr double kFallen = 1.0 - 1e-3; // A smaller fall of the sum is a local minimum
constexpr double kBendSlack = 1.05;

class Filter {
public:
  Filter(const RunSmoothing& by, std::vector<RunPoint> points, const Meets& meets,
         const base::RunContext& ctx)
      : by_(by), points_(std::move(points)), meets_(meets), ctx_(ctx),
        times_(timesOf(timedPoints(by.scene.cell, points_), by.limits)),
        stencils_(jerkStencils(times_)), jerk_(stencils_.size(), 0.0), locked_(points_.size(), 0) {
    measure(0, stencils_.size());
  }

  std::vector<RunPoint> run(double maxJerk, const LocalFilter& options) {
    for (int round = 0; round < options.rounds; ++round) {
      ctx_.checkpoint();
      double maximum = maxJerk;
      std::size_t centre = points_.size();
      for (std::size_t s = 0; s < jerk_.size(); ++s)
        if (const std::size_t at = middleOf(s); !locked_[at] && jerk_[s] > maximum) {
          maximum = jerk_[s];
          centre = at;
        }
      if (centre == points_.size())
        break;
      bool fell = false;
      for (std::size_t d = options.window; d <= options.widest && !fell; d += options.wider) {
        const std::size_t first = centre < d ? 0 : centre - d,
                          end = std::min(points_.size(), centre + d + 1);
        fell = filter(first, end);
        if (fell || d + options.wider > options.widest)
          std::fill(locked_.begin() + static_cast<std::ptrdiff_t>(first),
                    locked_.begin() + static_cast<std::ptrdiff_t>(end), !fell);
      }
    }
    return std::move(points_);
  }

private:
  // Returns the point in the middle of a jerk.
  std::size_t middleOf(std::size_t stencil) const {
    return std::clamp<std::size_t>(stencils_[stencil].last, 2, points_.size()) - 2;
  }

  void measure(std::size_t first, std::size_t end) {
    const auto& limits = by_.limits.joints;
    for (std::size_t s = first; s < std::min(end, stencils_.size()); ++s) {
      robot::JointVector jerk = robot::JointVector::Zero(points_.front().at.q.size());
      for (std::size_t k = 0; k < 4; ++k)
        if (stencils_[s].last + k >= 3 && stencils_[s].last + k - 3 < points_.size())
          jerk += stencils_[s].weight[k] * points_[stencils_[s].last + k - 3].at.q;
      jerk_[s] = robot::largestRotation(jerk, limits);
    }
  }

  // Smooths the points [first, end). Returns false, with the points unchanged, if that is not
  // possible or does not help.
  bool filter(std::size_t first, std::size_t end) {
    const std::size_t begin = first < kMargin ? 0 : first - kMargin,
                      last = std::min(points_.size(), end + kMargin);
    const auto at = [](auto& all, std::size_t i) {
      return all.begin() + static_cast<std::ptrdiff_t>(i);
    };
    const std::vector<RunPoint> piece(at(points_, begin), at(points_, last));
    const RotationSmoother smoother(by_.scene.cell, by_.twists, piece,
                                    {at(times_, begin), at(times_, last)});
    std::vector<TurnedPoint> turned = smoother.start(ctx_);
    std::vector<RotationHold> holds(piece.size(), {kHeld, 0.0, kHeld});
    for (std::size_t i = std::max<std::size_t>(first, 1); i < end && i + 1 < points_.size(); ++i)
      holds[i - begin] = {};
    const double before = smoother.cost(turned, holds);
    smoother.smooth(turned, holds, {}, ctx_);
    if (smoother.cost(turned, holds) >= kFallen * before)
      return false;
    std::vector<RunPoint> smoothed = piece;
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (turned[i].rotation != 0.0) {
        smoothed[i].at.tool = turned[i].tool(piece[i].at.tool);
        smoothed[i].at.q = turned[i].q;
      }
    if (!isSound(piece, smoothed))
      return false;
    std::copy(smoothed.begin(), smoothed.end(), at(points_, begin));
    measure(begin, last + kMargin + 1);
    return true;
  }

  bool isSound(const std::vector<RunPoint>& own, const std::vector<RunPoint>& smoothed) const {
    const MotionScene& scene = by_.scene;
    for (std::size_t i = 1; i < own.size(); ++i) {
      const RobotState &from = smoothed[i - 1].at, &to = smoothed[i].at;
      if (from.q == own[i - 1].at.q && to.q == own[i].at.q)
        continue;
      const double angle = angleBetween(from.tool, to.tool);
      const bool bends =
          scene.bend(from.tip, to.tip, angle) > kBendSlack * scene.options.deviationMm &&
          angle > angleBetween(own[i - 1].at.tool, own[i].at.tool);
      if (bends || scene.span(from.q, to.q) > scene.options.maxStepRad ||
          meets_(to.q, smoothed[i].next) || !scene.movesStraight(from, to))
        return false;
    }
    return true;
  }

  const RunSmoothing& by_;
  std::vector<RunPoint> points_;
  const Meets& meets_;
  const base::RunContext& ctx_;
  std::vector<double> times_;
  std::vector<JerkStencil> stencils_;
  std::vector<double> jerk_; // of each stencil, the greatest of a joint [rad/s3]
  std::vector<char> locked_;
};

} // namespace

std::vector<RunPoint> filteredRun(const RunSmoothing& by, std::vector<RunPoint> points,
                                  const Meets& meets, double maxJerk, const LocalFilter& options,
                                  const base::RunContext& ctx) {
  if (points.size() < 4)
    return points;
  return Filter(by, std::move(points), meets, ctx).run(maxJerk, options);
}

} // namespace voluta::motion
