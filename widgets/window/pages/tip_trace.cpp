#include "window/pages/tip_trace.h"

#include "base/run_context.h"
#include "robot/cell.h"
#include "timeline/clock.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voluta::window {

namespace {
constexpr double kCurveStepS = 0.05; // between points of joint motions
constexpr int kMaxCurveSteps = 100;
constexpr double kDashMm = 3.0; // of travels, and the gap after each
constexpr double kMaxDashes = 50'000.0;
constexpr double kOverBeadMm = 0.3; // so that the bead does not hide its line
constexpr double kFinestMm = 0.01;

using Line = std::vector<Eigen::Vector3d>;

// Returns the line without points that are closer than the tolerance to the straight line from the
// last point kept.
Line thinned(const Line& line, double toleranceMm) {
  Line kept{line.front()};
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < line.size(); ++i) {
    Eigen::Vector3d from = line[i] - kept.back();
    if (!along.isZero() &&
        (from.dot(along) < 0.0 || from.cross(along).squaredNorm() > toleranceMm * toleranceMm)) {
      kept.push_back(line[i - 1]);
      from = line[i] - kept.back();
      along.setZero();
    }
    if (along.isZero())
      along = from.norm() > toleranceMm ? from.normalized() : Eigen::Vector3d::Zero();
  }
  kept.push_back(line.back());
  return kept;
}

// Leaves out points until about kMaxTracePoints are left, the straightest places first.
void thin(std::vector<Line>& lines) {
  const auto points = [&] {
    return std::accumulate(lines.begin(), lines.end(), std::size_t{0},
                           [](std::size_t sum, const Line& line) { return sum + line.size(); });
  };
  // Lines of two points cannot be thinned.
  const std::size_t enough = std::max(kMaxTracePoints, 2 * lines.size());
  for (double toleranceMm = kFinestMm; points() > enough; toleranceMm *= 2.0)
    for (Line& line : lines)
      line = thinned(line, toleranceMm);
}

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
  colourTrace(groups, theme);
  const auto begin = std::ranges::lower_bound(trace.timeS, fromS) - trace.timeS.begin();
  const auto end = std::ranges::upper_bound(trace.timeS, toS) - trace.timeS.begin();
  const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
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
  thin(groups[0].lines);
  return groups;
}

void colourTrace(std::vector<scene::LineGroup>& lines, const scene::Theme& theme) {
  lines[0].colour = theme.marker;
  lines[1].colour = theme.text;
}

} // namespace voluta::window
