#include "replay/controller_time.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

constexpr double kMinMm = 1e-9;

// Returns the time of a trapezoidal speed profile over `distance` from speed v0 to v1, with at most
// v and acceleration a. Precondition: v1 is reachable from v0 and vice versa.
double trapezoidS(double distance, double v0, double v, double v1, double a) {
  const double up = (v * v - v0 * v0) / (2.0 * a), down = (v * v - v1 * v1) / (2.0 * a);
  if (up + down <= distance)
    return (v - v0) / a + (v - v1) / a + (distance - up - down) / v;
  const double top = std::sqrt(std::max(a * distance + 0.5 * (v0 * v0 + v1 * v1), 0.0));
  return (std::max(top - v0, 0.0) + std::max(top - v1, 0.0)) / a;
}

class Controller {
public:
  Controller(const plan::ReadProgram& program, const ExecutedPath& path, RotationLaw law)
      : motions_(program.motions), model_(program.time), path_(path), law_(law) {}

  std::vector<double> times() {
    plan();
    carryBackAndForth();
    std::vector<double> seconds(motions_.size(), 0.0);
    for (std::size_t m = 1; m < motions_.size(); ++m)
      seconds[m] = secondsOf(m);
    return seconds;
  }

private:
  struct Leg {
    bool straight = false, timed = false;
    double distance = 0.0;     // path length that the speed refers to [mm]
    double speed = 0.0;        // maximum speed
    double acceleration = 0.0; // 0: instantaneous
    double end = 0.0;          // speed at its end
  };

  bool ramps(const Leg& leg) const {
    return leg.straight && !leg.timed && leg.acceleration > 0.0 && leg.speed > 0.0 &&
           leg.distance > kMinMm;
  }

  void plan() {
    legs_.resize(motions_.size());
    for (std::size_t m = 1; m < motions_.size(); ++m) {
      const plan::ProgramMotion& motion = motions_[m];
      Leg& leg = legs_[m];
      leg.straight = !motion.jointInterpolated || !path_.arm;
      leg.timed = motion.durationS > 0.0;
      if (!leg.straight)
        continue;
      leg.distance = path_.commandedMm[m];
      double seconds = path_.durationS[m];
      if (!leg.timed && law_ == RotationLaw::PathSpeed && motion.speedMmPerS > 0.0) {
        leg.distance = std::max(leg.distance, model_.rotationMmPerRad * path_.angleRad[m]);
        seconds = std::max(seconds, leg.distance / motion.speedMmPerS);
      }
      leg.speed = seconds > 0.0 ? leg.distance / seconds : 0.0;
      leg.acceleration = motion.accelerationMmPerS2 > 0.0 ? motion.accelerationMmPerS2
                                                          : model_.accelerationMmPerS2;
    }
    for (std::size_t m = 1; m + 1 < motions_.size(); ++m)
      legs_[m].end = cornerSpeed(m);
  }

  // Returns the TCP's speed through the corner at the end of motion m.
  double cornerSpeed(std::size_t m) const {
    const Leg &in = legs_[m], &out = legs_[m + 1];
    if (!in.straight || !out.straight || in.distance < kMinMm || out.distance < kMinMm)
      return 0.0;
    const double speed = std::min(in.speed, out.speed);
    const bool stands = motions_[m].blendMm <= 0.0 && model_.junctionMm <= 0.0;
    if (stands && std::max(in.acceleration, out.acceleration) > 0.0)
      return 0.0;
    // A given time takes precedence: the corner is passed at the speed it requires.
    if (in.timed || out.timed)
      return speed;
    const double a = std::min(in.acceleration, out.acceleration), angle = path_.cornerRad[m];
    if (a <= 0.0)
      return speed;
    const double radius =
        std::min({motions_[m].blendMm, 0.5 * path_.commandedMm[m], 0.5 * path_.commandedMm[m + 1]});
    double corner = INFINITY;
    if (radius > 0.0) {
      const double bend = std::sin(0.5 * angle);
      if (bend > 1e-9)
        corner = std::sqrt(a * radius / bend);
    } else {
      const double c = std::cos(0.5 * angle);
      if (c < 1.0 - 1e-12)
        corner = std::sqrt(a * model_.junctionMm * std::max(c, 0.0) / (1.0 - c));
    }
    return std::min(speed, corner);
  }

  void carryBackAndForth() {
    for (std::size_t m = motions_.size(); m-- > 1;)
      if (ramps(legs_[m]))
        legs_[m - 1].end = std::min(legs_[m - 1].end, reach(legs_[m].end, legs_[m]));
    if (model_.lookAhead > 0)
      lookAheadOnly();
    for (std::size_t m = 1; m < motions_.size(); ++m)
      if (ramps(legs_[m]))
        legs_[m].end = std::min(legs_[m].end, reach(legs_[m - 1].end, legs_[m]));
  }
  static double reach(double speed, const Leg& leg) {
    return std::sqrt(speed * speed + 2.0 * leg.acceleration * leg.distance);
  }
  // The controller assumes a stop behind the last motion of its look-ahead.
  void lookAheadOnly() {
    for (std::size_t m = 1; m < motions_.size(); ++m) {
      double distance = 0.0, a = 0.0;
      const std::size_t last =
          std::min(motions_.size() - 1, m + static_cast<std::size_t>(model_.lookAhead));
      for (std::size_t k = m + 1; k <= last && ramps(legs_[k]); ++k) {
        distance += legs_[k].distance;
        a = a > 0.0 ? std::min(a, legs_[k].acceleration) : legs_[k].acceleration;
      }
      if (a > 0.0)
        legs_[m].end = std::min(legs_[m].end, std::sqrt(2.0 * a * distance));
    }
  }

  double secondsOf(std::size_t m) const {
    const Leg& leg = legs_[m];
    double seconds = path_.durationS[m];
    if (ramps(leg)) {
      const double from = std::min(legs_[m - 1].end, leg.speed), to = std::min(leg.end, leg.speed);
      seconds = trapezoidS(leg.distance, from, leg.speed, to, leg.acceleration);
    } else if (!leg.straight && !leg.timed) {
      seconds = jointMotionS(path_, m,
                             motions_[m].jointAccelerationRadPerS2 > 0.0
                                 ? motions_[m].jointAccelerationRadPerS2
                                 : model_.jointAccelerationRadPerS2);
    }
    return seconds > 0.0 ? std::max(seconds, model_.cycleS) : 0.0;
  }

  const std::vector<plan::ProgramMotion>& motions_;
  const plan::TimeModel& model_;
  const ExecutedPath& path_;
  RotationLaw law_;
  std::vector<Leg> legs_;
};

} // namespace

double jointMotionS(const ExecutedPath& path, std::size_t m, double radPerS2) {
  double angle = 0.0;
  for (int k = 0; k < path.dof; ++k)
    angle =
        std::max(angle, std::abs(path.angleOf(k, path.jointsAt(m)[k] - path.jointsAt(m - 1)[k])));
  const double seconds = path.durationS[m];
  if (radPerS2 <= 0.0 || seconds <= 0.0 || angle < kMinMm)
    return seconds;
  return trapezoidS(angle, 0.0, angle / seconds, 0.0, radPerS2);
}

std::vector<double> controllerTimes(const plan::ReadProgram& program, const ExecutedPath& path,
                                    RotationLaw law) {
  return Controller(program, path, law).times();
}

} // namespace voluta::replay
