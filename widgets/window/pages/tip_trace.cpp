#include "window/pages/tip_trace.h"

#include "base/run_context.h"
#include "robot/cell.h"
#include "timeline/clock.h"

#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr double kCurveStepS = 0.05; // between points of joint motions
constexpr int kMaxCurveSteps = 100;
constexpr double kDashMm = 3.0; // of travels, and the gap after each
constexpr double kMaxDashes = 50'000.0;
constexpr double kOverBeadMm = 0.3; // so that the bead does not hide its line

// Draws a polyline as dashes that continue from segment to segment.
class Dashes {
public:
  Dashes(std::vector<std::vector<Eigen::Vector3d>>& lines, double lengthMm)
      : lines_(lines), dashMm_(std::max(kDashMm, lengthMm / (2.0 * kMaxDashes))) {}

  void add(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const double length = (to - from).norm();
    for (double at = 0.0; at < length;) {
      const double end = std::min(length, at + dashMm_ - std::fmod(done_, dashMm_));
      if (std::fmod(done_, 2.0 * dashMm_) < dashMm_)
        lines_.push_back({from + at / length * (to - from), from + end / length * (to - from)});
      done_ += std::max(end - at, 1e-6);
      at = std::max(end, at + 1e-6);
    }
  }

private:
  std::vector<std::vector<Eigen::Vector3d>>& lines_;
  double dashMm_, done_ = 0.0;
};
} // namespace

TipTrace tipTrace(const timeline::Clock& clock, const robot::Cell& cell,
                  const base::RunContext& ctx) {
  TipTrace trace;
  const plan::Trajectory& t = *clock.trajectory();
  const auto add = [&](double timeS, bool prints) {
    const Eigen::Isometry3d work_T_tool = cell.work_T_tool(clock.jointsAt(timeS));
    trace.timeS.push_back(timeS);
    trace.tipMm.push_back(
        (work_T_tool.translation() - kOverBeadMm * work_T_tool.linear().col(2)).cast<float>());
    trace.prints.push_back(prints);
  };
  for (std::size_t i = 0; i < t.pointCount(); ++i) {
    if (i % 4096 == 0)
      ctx.checkpoint();
    const double to = clock.timeOfPoint(i);
    if (i > 0 && t.move[i] == plan::MoveKind::Joint) {
      const double from = trace.timeS.back();
      const int steps = std::clamp(static_cast<int>((to - from) / kCurveStepS), 1, kMaxCurveSteps);
      for (int k = 1; k < steps; ++k)
        add(from + k * (to - from) / steps, false);
    }
    add(to, t.move[i] == plan::MoveKind::Print);
  }
  return trace;
}

std::vector<scene::LineGroup> traceLines(const TipTrace& trace, double fromS, double toS,
                                         const scene::Theme& theme) {
  std::vector<scene::LineGroup> groups(2);
  groups[0].colour = theme.marker;
  groups[1].colour = theme.text;
  const auto begin = std::ranges::lower_bound(trace.timeS, fromS) - trace.timeS.begin();
  const auto end = std::ranges::upper_bound(trace.timeS, toS) - trace.timeS.begin();
  const auto last = static_cast<std::size_t>(end);
  const std::size_t first =
      std::max(static_cast<std::size_t>(begin), last - std::min(last, kMaxTracePoints));
  double travelMm = 0.0;
  for (std::size_t i = first + 1; i < last; ++i)
    if (!trace.prints[i])
      travelMm += static_cast<double>((trace.tipMm[i] - trace.tipMm[i - 1]).norm());
  Dashes travels(groups[1].lines, travelMm);
  for (std::size_t i = first + 1; i < last; ++i) {
    const Eigen::Vector3d from = trace.tipMm[i - 1].cast<double>(),
                          to = trace.tipMm[i].cast<double>();
    if (!trace.prints[i]) {
      travels.add(from, to);
      continue;
    }
    if (i == first + 1 || !trace.prints[i - 1])
      groups[0].lines.push_back({from});
    groups[0].lines.back().push_back(to);
  }
  return groups;
}

} // namespace voluta::window
