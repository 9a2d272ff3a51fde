#include "timeline/joint_curves.h"

#include "base/error.h"
#include "plan/arrival_times.h"
#include "plan/trajectory_jerk.h"

#include <algorithm>

namespace voluta::timeline {

JointCurves::JointCurves(std::shared_ptr<const plan::Trajectory> trajectory,
                         const std::vector<robot::JointKind>& kinds, const base::RunContext& ctx)
    : trajectory_(std::move(trajectory)) {
  base::require(trajectory_ && trajectory_->pointCount() > 0, "JointCurves: points to draw");
  const plan::Trajectory& t = *trajectory_;
  base::require(std::is_sorted(t.timeS.begin(), t.timeS.end()),
                "JointCurves: times do not decrease");
  const std::vector<std::size_t> pointOf = addTimes();
  const std::vector<std::vector<float>> jerks = plan::jerkAlong(t);
  const std::size_t count = timeS_.size(), dof = static_cast<std::size_t>(t.dof);
  for (std::size_t joint = 0; joint < dof; ++joint) {
    ctx.checkpoint();
    std::vector<float> angles(count), speeds(count, 0.0f), jerk(count);
    const robot::JointKind kind = joint < kinds.size() ? kinds[joint] : robot::JointKind::Turning;
    const auto value = [&](std::size_t i) { return t.joints[pointOf[i] * dof + joint]; };
    for (std::size_t i = 0; i < count; ++i) {
      angles[i] = static_cast<float>(robot::shownValue(kind, value(i)));
      jerk[i] = jerks[joint][pointOf[i]];
      if (i + 1 == count)
        break;
      const double step = value(i + 1) - value(i);
      const double seconds = timeS_[i + 1] - timeS_[i];
      // Two points at the same time have no duration, so the previous speed continues.
      speeds[i] = seconds > 0.0 ? static_cast<float>(robot::shownValue(kind, step / seconds))
                                : (i > 0 ? speeds[i - 1] : 0.0f);
    }
    angle_.emplace_back(std::move(angles));
    speed_.emplace_back(std::move(speeds));
    jerk_.emplace_back(std::move(jerk));
  }
}

// Returns the point at each of the times.
std::vector<std::size_t> JointCurves::addTimes() {
  const plan::Trajectory& t = *trajectory_;
  const std::vector<double> arrival = plan::arrivalTimes(t);
  std::vector<std::size_t> pointOf;
  for (std::size_t i = 0; i < arrival.size(); ++i) {
    const double departure = i == 0 ? 0.0 : arrival[i] - (t.timeS[i] - t.timeS[i - 1]);
    if (i > 0 && t.waitBefore(i) > 0.0) {
      timeS_.push_back(departure);
      pointOf.push_back(i - 1);
    }
    timeS_.push_back(arrival[i]);
    pointOf.push_back(i);
  }
  return pointOf;
}

QList<QPointF> JointCurves::angle(int joint, double fromS, double toS, int columns) const {
  return reduced(angle_.at(static_cast<std::size_t>(joint)), fromS, toS, columns, false);
}

QList<QPointF> JointCurves::speed(int joint, double fromS, double toS, int columns) const {
  return reduced(speed_.at(static_cast<std::size_t>(joint)), fromS, toS, columns, true);
}

QList<QPointF> JointCurves::jerk(int joint, double fromS, double toS, int columns) const {
  return reduced(jerk_.at(static_cast<std::size_t>(joint)), fromS, toS, columns, false);
}

ValueRange JointCurves::angleRange(int joint) const {
  const CurvePyramid& curve = angle_.at(static_cast<std::size_t>(joint));
  return curve.over(0, curve.size());
}

ValueRange JointCurves::speedRange(int joint) const {
  const CurvePyramid& curve = speed_.at(static_cast<std::size_t>(joint));
  return curve.over(0, curve.size());
}

ValueRange JointCurves::jerkRange(int joint) const {
  const CurvePyramid& curve = jerk_.at(static_cast<std::size_t>(joint));
  return curve.over(0, curve.size());
}

QList<QPointF> JointCurves::reduced(const CurvePyramid& curve, double fromS, double toS,
                                    int columns, bool steps) const {
  const std::vector<double>& times = timeS_;
  const auto indexOf = [&](auto at) { return static_cast<std::size_t>(at - times.begin()); };
  // One point beyond each end, so that the curve continues to the edge of the picture.
  std::size_t begin = indexOf(std::lower_bound(times.begin(), times.end(), fromS));
  begin = begin > 0 ? begin - 1 : 0;
  std::size_t end = indexOf(std::upper_bound(times.begin(), times.end(), toS));
  end = std::min(end + 1, times.size());

  QList<QPointF> points;
  const auto add = [&](std::size_t i) {
    if (steps && i > 0)
      points.append({times[i], curve[i - 1]});
    points.append({times[i], curve[i]});
  };
  if (end - begin <= 2 * static_cast<std::size_t>(columns)) {
    points.reserve(static_cast<qsizetype>(2 * (end - begin)));
    for (std::size_t i = begin; i < end; ++i)
      add(i);
    return points;
  }
  points.reserve(4 * columns);
  const double width = (toS - fromS) / columns;
  for (std::size_t i = begin; i < end;) {
    const int column = static_cast<int>((times[i] - fromS) / width);
    const double edge = fromS + (column + 1) * width;
    const std::size_t next = std::max(
        i + 1,
        std::min(end, indexOf(std::lower_bound(times.begin() + static_cast<std::ptrdiff_t>(i),
                                               times.end(), edge))));
    if (next - i <= 2) {
      for (; i < next; ++i)
        add(i);
      continue;
    }
    const ValueRange range = curve.over(i, next);
    const double middle = 0.5 * (times[i] + times[next - 1]);
    // The nearer end first, so that the line between two columns is short.
    const double before = points.isEmpty() ? range.low : points.last().y();
    const bool lowFirst = before - range.low < range.high - before;
    points.append({middle, lowFirst ? range.low : range.high});
    points.append({middle, lowFirst ? range.high : range.low});
    i = next;
  }
  return points;
}

} // namespace voluta::timeline
