#include "motion/timing.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

namespace {

// Converts motion of the arm to path length, so that rotations on the spot take time as well.
// Rotation of a rod is excluded: it carries the surface that the nozzle moves over.
constexpr double kMmPerRad = 50.0;
constexpr double kMinSeconds = 1e-4;
constexpr double kTravelJointSpeed = 0.5; // relative to the limit, for joint moves
// Tolerances for collinear joint moves: as small as that for joining joint motions in programs
// (program/dialect.cpp); and a little more than a step of a rod's motor.
constexpr double kSameLineRad = 1e-5, kSameStepsRad = 0.0025;
constexpr int kRounds = 200;

// Returns the time of one segment with ramps from v0 to v1 (peak at most cap) at the given
// acceleration.
double rampTime(double length, double v0, double v1, double cap, double acceleration) {
  const double peak = std::max(
      {v0, v1, std::min(cap, std::sqrt(acceleration * length + 0.5 * (v0 * v0 + v1 * v1)))});
  const double ramps = (2.0 * peak * peak - v0 * v0 - v1 * v1) / (2.0 * acceleration);
  return (2.0 * peak - v0 - v1) / acceleration + std::max(0.0, length - ramps) / peak;
}

// Returns the speed through a corner on a circle that stays within `cut` of it.
double cornerSpeed(const Eigen::Vector3d& in, const Eigen::Vector3d& out, double cut,
                   double acceleration) {
  const double a = in.norm(), b = out.norm();
  if (a < 1e-9 || b < 1e-9)
    return 1e9;
  const double cosine = std::clamp(-in.dot(out) / (a * b), -1.0, 1.0); // 1: straight back
  const double sine = std::sqrt(0.5 * (1.0 - cosine));                 // of half the angle between
  if (sine > 0.9999)
    return 1e9;
  return std::sqrt(acceleration * cut * sine / (1.0 - sine));
}

// The segments between points: path length of arm and nozzle combined, and speed and acceleration
// limits.
struct Segments {
  std::vector<double> length, cap, ramp; // mm, mm/s, mm/s2
};

Segments segmentsOf(const std::vector<TimedPoint>& points, const TimingLimits& limits) {
  const std::size_t n = points.size() - 1;
  const Eigen::Index dof = points.front().q.size(), arm = limits.arm > 0 ? limits.arm : dof;
  Segments s{std::vector<double>(n), std::vector<double>(n),
             std::vector<double>(n, limits.accelerationMmPerS2)};
  for (std::size_t i = 0; i < n; ++i) {
    const TimedPoint &from = points[i], &to = points[i + 1];
    const double distance = (to.tip - from.tip).norm();
    robot::JointVector dq = (to.q - from.q).cwiseAbs();
    const auto armAngle = [&] { return robot::asAngles(dq, limits.joints).head(arm).maxCoeff(); };
    // The path of a joint move is that of its joints alone, so that its pieces form one ramped
    // motion.
    const double arms = kMmPerRad * armAngle();
    s.length[i] = std::max(1e-6, to.jointMove && arm == dof ? arms : std::hypot(distance, arms));
    if (to.peakDisplacement.size() > 0)
      dq = dq.cwiseMax(to.peakDisplacement);
    double minimum = kMinSeconds; // seconds
    for (Eigen::Index j = 0; j < dof; ++j) {
      const double fraction = limits.jointFraction * (to.jointMove ? kTravelJointSpeed : 1.0);
      minimum = std::max(minimum,
                         dq[j] / (fraction * limits.joints[static_cast<std::size_t>(j)].velocity));
    }
    if (!to.jointMove && to.speedMmPerS > 0.0)
      minimum = std::max(minimum, distance / to.speedMmPerS);
    s.cap[i] = s.length[i] / minimum;
    const double angle = armAngle();
    if (to.jointMove && limits.travelRadPerS2 > 0.0 && angle > 0.0)
      s.ramp[i] = std::min(s.ramp[i], limits.travelRadPerS2 * s.length[i] / angle);
    // A rod turns with the path; therefore its acceleration limits that of the path.
    for (Eigen::Index j = arm; j < dof; ++j)
      if (dq[j] > 0.0)
        s.ramp[i] =
            std::min(s.ramp[i], limits.jointFraction *
                                    limits.joints[static_cast<std::size_t>(j)].acceleration *
                                    s.length[i] / dq[j]);
  }
  return s;
}

// Returns whether a joint motion continues the preceding one, so that both form one motion.
bool continues(const robot::JointVector& a, const robot::JointVector& b,
               const robot::JointVector& c, double sameRad) {
  const robot::JointVector in = b - a, span = c - a;
  const double squared = span.squaredNorm();
  if (!(squared > 0.0))
    return false;
  const double at = in.dot(span) / squared;
  return at >= 0.0 && at <= 1.0 && (in - at * span).cwiseAbs().maxCoeff() <= sameRad;
}

// Returns the speed limit at each point [mm/s].
std::vector<double> cornerSpeeds(const std::vector<TimedPoint>& points,
                                 const std::vector<double>& length, const TimingLimits& limits) {
  const std::size_t n = length.size();
  const std::vector<char> rests = restsAt(points, limits);
  std::vector<double> corner(n + 1, 1e9);
  for (std::size_t i = 0; i <= n; ++i) {
    if (rests[i])
      corner[i] = 0.0;
    else if (!points[i].jointMove && !points[i + 1].jointMove) {
      // Converts the tip's speed to that of the profile, which runs on the longer, combined path.
      const double tip =
          cornerSpeed(points[i].tip - points[i - 1].tip, points[i + 1].tip - points[i].tip,
                      limits.cornerMm, limits.accelerationMmPerS2);
      const double lengthIn = (points[i].tip - points[i - 1].tip).norm();
      corner[i] = lengthIn > 1e-9 ? tip * length[i - 1] / lengthIn : 1e9;
    }
  }
  return corner;
}

// Computes the duration [s] of each segment, with ramps from a forward and a backward pass.
void setDurations(const Segments& s, const std::vector<double>& corner, std::vector<double>& dt) {
  const std::size_t n = s.length.size();
  std::vector<double> v(n + 1);
  v[0] = v[n] = 0.0;
  for (std::size_t i = 1; i < n; ++i)
    v[i] = std::min({corner[i], s.cap[i - 1], s.cap[i]});
  for (std::size_t i = 1; i <= n; ++i)
    v[i] = std::min(v[i], std::sqrt(v[i - 1] * v[i - 1] + 2.0 * s.ramp[i - 1] * s.length[i - 1]));
  for (std::size_t i = n; i-- > 0;)
    v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + 2.0 * s.ramp[i] * s.length[i]));
  for (std::size_t i = 0; i < n; ++i)
    dt[i] = rampTime(s.length[i], v[i], v[i + 1], s.cap[i], s.ramp[i]);
}

// Lowers caps where joint accelerations exceed their limits; returns false if there are none.
bool lowerCaps(const std::vector<TimedPoint>& points, const TimingLimits& limits,
               const std::vector<double>& dt, Segments& segments) {
  const std::size_t n = dt.size();
  const Eigen::Index dof = points.front().q.size();
  bool lowered = false;
  std::vector<double> scale(n, 1.0);
  for (std::size_t i = 0; i <= n; ++i) {
    const double between = i == 0   ? 0.5 * dt[0]
                           : i == n ? 0.5 * dt[n - 1]
                                    : 0.5 * (dt[i - 1] + dt[i]);
    double worst = 0.0;
    for (Eigen::Index j = 0; j < dof; ++j) {
      const double in = i == 0 ? 0.0 : (points[i].q[j] - points[i - 1].q[j]) / dt[i - 1];
      const double out = i == n ? 0.0 : (points[i + 1].q[j] - points[i].q[j]) / dt[i];
      worst = std::max(worst, std::abs(out - in) / between /
                                  limits.joints[static_cast<std::size_t>(j)].acceleration);
    }
    worst /= limits.jointFraction;
    if (worst <= 1.0)
      continue;
    lowered = true;
    const double s = std::clamp(0.98 / std::sqrt(worst), 0.5, 0.98);
    if (i > 0)
      scale[i - 1] = std::min(scale[i - 1], s);
    if (i < n)
      scale[i] = std::min(scale[i], s);
  }
  for (std::size_t i = 0; lowered && i < n; ++i)
    if (scale[i] < 1.0)
      segments.cap[i] = scale[i] * std::min(segments.cap[i], segments.length[i] / dt[i] * 1.0);
  return lowered;
}

} // namespace

std::vector<char> restsAt(const std::vector<TimedPoint>& points, const TimingLimits& limits) {
  std::vector<char> rests(points.size(), 0);
  if (points.empty())
    return rests;
  rests.front() = rests.back() = 1;
  const bool steps = limits.arm > 0 && limits.arm < points.front().q.size();
  const double sameRad = steps ? kSameStepsRad : kSameLineRad;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const bool turns = points[i].jointMove && points[i + 1].jointMove;
    // Without blending, controllers stop between joint motions.
    rests[i] = points[i].stop ||
               (turns && !continues(points[i - 1].q, points[i].q, points[i + 1].q, sameRad));
  }
  return rests;
}

std::vector<double> timesOf(const std::vector<TimedPoint>& points, const TimingLimits& limits) {
  std::vector<double> times(points.size(), 0.0);
  if (points.size() < 2)
    return times;
  base::require(static_cast<std::size_t>(points.front().q.size()) <= limits.joints.size(),
                "limits for every joint");
  Segments segments = segmentsOf(points, limits);
  const std::vector<double> corner = cornerSpeeds(points, segments.length, limits);
  std::vector<double> dt(segments.length.size());
  for (int round = 0; round < kRounds; ++round) {
    setDurations(segments, corner, dt);
    if (!lowerCaps(points, limits, dt, segments))
      break;
  }
  for (std::size_t i = 0; i < dt.size(); ++i)
    times[i + 1] = times[i] + dt[i];
  return times;
}

} // namespace voluta::motion
