#include "motion/jerk_limit.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::motion {

using robot::JointVector;

namespace {

constexpr int kRounds = 80;         // of lowering the speed where the jerk is too large
constexpr int kStretchRounds = 200; // of stretching what is left
constexpr double kRamp = 0.7;       // share of the limit that changes of speed may use
constexpr double kMinFactor = 0.7;  // smallest factor of a speed in one round
constexpr double kMinRate = 1e-6;   // [rad/s]
constexpr double kPower = 0.36;     // slightly more than the cubic law requires
constexpr int kNewtonSteps = 6;
constexpr double kMaxPerRound = 1.5, kBeyond = 1.002;     // stretch of a step in one round
constexpr std::size_t kFirstWindow = 2, kLastWindow = 40; // steps on both sides of a place
constexpr int kRoundsPerWindow = 2; // rounds after which the windows grow by a step
// Of shortening again what was slowed too far: steps on both sides, shares of a step, passes
constexpr std::array<std::size_t, 5> kShortenHalves{32, 16, 8, 4, 2};
constexpr double kMaxShortened = 0.2, kMinShortened = 0.01, kShortenEnough = 1e-3;
constexpr int kShortenPasses = 4;

class Slower {
public:
  Slower(const std::vector<JointVector>& q, const std::vector<double>& times,
         const std::vector<robot::JointLimits>& limits, double maxJerk)
      : q_(q), maxJerk_(maxJerk), count_(q.size()), step_(count_ + 1, 0.0) {
    const Eigen::Index dof = q.front().size();
    scale_ = JointVector::Ones(dof);
    for (Eigen::Index j = 0; j < dof && j < static_cast<Eigen::Index>(limits.size()); ++j)
      scale_[j] = robot::asAngle(limits[static_cast<std::size_t>(j)].kind, 1.0);
    for (std::size_t i = 1; i < count_; ++i)
      step_[i] = times[i] - times[i - 1];
    own_ = step_;
    speed_.assign(count_, 1.0);
    rate_.assign(count_ + 1, 0.0);
    for (std::size_t k = 1; k < count_; ++k)
      rate_[k] = (q[k] - q[k - 1]).cwiseProduct(scale_).cwiseAbs().maxCoeff() / own_[k];
  }

  std::vector<double> times() {
    if (count_ > 3)
      lowerSpeeds();
    stretchSteps();
    shortenSteps();
    std::vector<double> times(count_, 0.0);
    for (std::size_t i = 1; i < count_; ++i)
      times[i] = times[i - 1] + step_[i];
    return times;
  }

private:
  // Lowers the speed at places of too much jerk, and ramps up and down about them.
  void lowerSpeeds() {
    std::vector<std::size_t> places;
    for (int round = 0; round < kRounds; ++round) {
      places.clear();
      std::vector<double> factor(count_, 1.0);
      bool first = false, last = false;
      for (std::size_t i = 1; i <= count_; ++i) {
        const double share = jerkAt(i) / maxJerk_;
        if (share <= 1.0)
          continue;
        const double by = std::max(kMinFactor, std::pow(share, -kPower));
        for (std::size_t c = i >= 2 ? i - 2 : 0; c <= std::min(i - 1, count_ - 1); ++c)
          factor[c] = std::min(factor[c], by);
        first = first || i <= 2;
        last = last || i + 1 >= count_;
      }
      for (std::size_t c = 1; c + 1 < count_; ++c)
        if (factor[c] < 1.0 && speed_[c] > 1.0 / kMaxSlowdown) {
          speed_[c] *= factor[c];
          places.push_back(c);
        }
      if (first && speed_.front() > 0.0) {
        speed_.front() = 0.0;
        places.push_back(0);
      }
      if (last && speed_.back() > 0.0) {
        speed_.back() = 0.0;
        places.push_back(count_ - 1);
      }
      if (places.empty())
        return;
      for (const std::size_t c : places) {
        ramp(c, 1);
        ramp(c, -1);
      }
      setSteps();
    }
  }

  // Limits the speeds on one side of a place to those that a ramp of limited jerk reaches.
  void ramp(std::size_t from, int direction) {
    double speed = speed_[from], gain = 0.0; // gain of speed per second
    for (std::size_t i = from; speed < 1.0; i += static_cast<std::size_t>(direction)) {
      if ((direction < 0 && i == 0) || (direction > 0 && i + 1 >= count_))
        return;
      const std::size_t k = direction > 0 ? i + 1 : i, next = direction > 0 ? i + 1 : i - 1;
      const double rate = std::max({rate_[k], rate_[k - 1], rate_[k + 1], kMinRate});
      double jerk = kRamp * maxJerk_ / rate;
      const bool eases = gain * gain >= 2.0 * jerk * (1.0 - speed);
      if (eases)
        jerk = -gain * gain / (2.0 * (1.0 - speed));
      const double t = timeOver(own_[k], speed, gain, jerk);
      if (eases && t >= 2.0 * (1.0 - speed) / gain)
        return; // at full speed
      speed = std::min(1.0, speed + gain * t + 0.5 * jerk * t * t);
      gain += jerk * t;
      if (speed >= speed_[next] && i != from)
        return; // another place has the lower ramp
      speed_[next] = std::min(speed_[next], speed);
    }
  }

  // Returns the time in which the integral of the speed reaches `distance`; speed and gain >= 0.
  static double timeOver(double distance, double speed, double gain, double jerk) {
    double maximum = jerk > 0.0 ? std::cbrt(6.0 * distance / jerk) : distance / speed;
    if (speed * maximum > distance)
      maximum = distance / speed;
    double t = maximum;
    for (int k = 0; k < kNewtonSteps; ++k) {
      const double over = t * (speed + t * (0.5 * gain + t * jerk / 6.0)) - distance;
      const double rate = speed + t * (gain + 0.5 * t * jerk);
      if (!(rate > 0.0))
        break;
      t = std::clamp(t - over / rate, 0.0, maximum);
    }
    return t;
  }

  void setSteps() {
    for (std::size_t k = 1; k < count_; ++k) {
      const double a = speed_[k - 1], b = speed_[k];
      // From rest the speed rises with the square of the time.
      const double mean = a == 0.0 || b == 0.0 ? std::max(a, b) / 3.0 : 0.5 * (a + b);
      step_[k] = own_[k] * std::max(1.0, 1.0 / std::max(mean, 1e-3));
    }
  }

  void stretchSteps() {
    std::vector<char> changed(count_ + 1, 1);
    std::vector<double> share(count_ + 1, 0.0), longer(count_ + 1, 1.0);
    for (int round = 0; round < kStretchRounds; ++round) {
      bool over = false;
      for (std::size_t i = 1; i <= count_; ++i) {
        if (changed[i] || changed[i - 1] || (i > 1 && changed[i - 2]))
          share[i] = jerkAt(i) / maxJerk_;
        over = over || share[i] > 1.0;
      }
      if (!over)
        return;
      const std::size_t window =
          std::min(kLastWindow, kFirstWindow + static_cast<std::size_t>(round / kRoundsPerWindow));
      for (std::size_t i = 1; i <= count_; ++i)
        if (share[i] > 1.0)
          stretch(i, std::min(kMaxPerRound, kBeyond * std::cbrt(share[i])), window, longer);
      bool any = false;
      for (std::size_t k = 1; k < count_; ++k) {
        const double step =
            std::min(std::max(kMaxSlowdown * own_[k], step_[k]), step_[k] * longer[k]);
        changed[k] = step > step_[k];
        any = any || changed[k];
        step_[k] = step;
        longer[k] = 1.0;
      }
      changed[0] = changed[count_] = 0;
      if (!any)
        return;
    }
  }

  // Shortens steps that are longer than the own ones, in windows of several widths, as far as the
  // limit allows: lowerSpeeds() and stretchSteps() slow more than they must.
  void shortenSteps() {
    std::vector<double> jerk(count_ + 1, 0.0), steps;
    for (std::size_t i = 1; i <= count_; ++i)
      jerk[i] = std::max(jerkAt(i), maxJerk_);
    for (int pass = 0; pass < kShortenPasses; ++pass) {
      double before = 0.0, gained = 0.0;
      for (std::size_t k = 1; k < count_; ++k)
        before += step_[k];
      for (const std::size_t half : kShortenHalves)
        for (std::size_t centre = 1; centre < count_; centre += std::max<std::size_t>(1, half / 2))
          gained += shorten(centre, half, jerk, steps);
      if (gained < kShortenEnough * before)
        return;
    }
  }

  // Shortens the steps about one, the less the further they are away. Returns by how much [s].
  // `jerk`: what each stencil may have.
  double shorten(std::size_t centre, std::size_t half, const std::vector<double>& jerk,
                 std::vector<double>& steps) {
    const std::size_t first = centre > half ? centre - half : 1;
    const std::size_t last = std::min(count_ - 1, centre + half);
    const auto isLonger = [&](std::size_t k) { return step_[k] > own_[k] * kBeyond; };
    bool any = false;
    for (std::size_t k = first; k <= last && !any; ++k)
      any = isLonger(k);
    if (!any)
      return 0.0;
    const auto at = [](std::vector<double>& of, std::size_t k) {
      return of.begin() + static_cast<std::ptrdiff_t>(k);
    };
    double gained = 0.0;
    for (double share = kMaxShortened; share >= kMinShortened;) {
      steps.assign(at(step_, first), at(step_, last + 1));
      double gain = 0.0;
      for (std::size_t k = first; k <= last; ++k) {
        const double shorter = std::max(own_[k], step_[k] * (1.0 - share * bump(k, centre, half)));
        gain += std::max(0.0, step_[k] - shorter);
        step_[k] = std::min(step_[k], shorter);
      }
      bool keeps = gain > 0.0;
      for (std::size_t i = first; i <= std::min(count_, last + 2) && keeps; ++i)
        keeps = jerkAt(i) <= jerk[i];
      if (keeps) {
        gained += gain;
      } else {
        std::copy(steps.begin(), steps.end(), at(step_, first));
        share *= 0.5;
      }
    }
    return gained;
  }

  // Returns a weight that falls from 1 at the centre to 0 beyond the window.
  static double bump(std::size_t k, std::size_t centre, std::size_t half) {
    const double away =
        k > centre ? static_cast<double>(k - centre) : static_cast<double>(centre - k);
    return 0.5 * (1.0 + std::cos(base::kPi * away / static_cast<double>(half + 1)));
  }

  // Velocities are those of the steps 1 .. count_ - 1, at their middles; 0 at both ends.
  double velocity(std::size_t i, Eigen::Index j) const {
    return i == 0 || i >= count_ ? 0.0 : (q_[i][j] - q_[i - 1][j]) / step_[i];
  }

  // Returns the greatest absolute jerk of a joint between the accelerations before and after the
  // middle of step i - 1.
  double jerkAt(std::size_t i) const {
    // Times from the middle of step i - 1.
    const double after = 0.5 * (step_[i - 1] + step_[i]);
    const double before = i >= 2 ? 0.5 * (step_[i - 1] + step_[i - 2]) : 0.0;
    const double apart = 0.5 * (before + after);
    if (!(after > 0.0) || !(apart > 0.0))
      return 0.0;
    double maximum = 0.0;
    for (Eigen::Index j = 0; j < scale_.size(); ++j) {
      const double middle = velocity(i - 1, j);
      const double out = (velocity(i, j) - middle) / after;
      const double in = before > 0.0 ? (middle - velocity(i - 2, j)) / before : 0.0;
      maximum = std::max(maximum, std::abs(scale_[j] * (out - in) / apart));
    }
    return maximum;
  }

  // Stretches the steps about stencil i, the less the further they are away.
  void stretch(std::size_t i, double by, std::size_t window, std::vector<double>& longer) const {
    const std::size_t centre = std::min(std::max<std::size_t>(i, 2) - 1, count_ - 1);
    const std::size_t first = centre > window ? centre - window : 1;
    const std::size_t last = std::min(count_ - 1, centre + window);
    for (std::size_t k = first; k <= last; ++k)
      longer[k] = std::max(longer[k], 1.0 + (by - 1.0) * bump(k, centre, window));
  }

  const std::vector<JointVector>& q_;
  double maxJerk_;
  std::size_t count_;
  JointVector scale_;
  std::vector<double> step_, own_; // [s] of the steps to points 1 .. count_ - 1; 0 beyond
  std::vector<double> speed_;      // at each point, relative to the own one
  std::vector<double> rate_;       // own speed of the fastest joint in each step [rad/s]
};

} // namespace

std::vector<double> timesWithinJerk(const std::vector<JointVector>& q,
                                    const std::vector<double>& times,
                                    const std::vector<robot::JointLimits>& limits, double maxJerk) {
  base::require(q.size() == times.size() && maxJerk > 0.0, "timesWithinJerk: a time per point");
  if (q.size() < 2)
    return times;
  return Slower(q, times, limits, maxJerk).times();
}

} // namespace voluta::motion
