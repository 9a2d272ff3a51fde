#include "robot/kinematics/bent_wrist.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/golden_section.h"
#include "robot/angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::robot {

namespace {

using base::kPi;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// The circle is sampled at this many places. Two neighbouring places are subdivided, down to cells
// of kDepth halvings, if axis 4 rotates by more than kAngleBetween between them or a solution
// branch ends.
constexpr int kPlaces = 128, kDepth = 10;
constexpr double kAngleBetween = 0.08;
// Tolerance within which the equation counts as fulfilled if it touches zero from one side [rad].
constexpr double kTouches = 1e-10;
// From one place to the next the axes rotate so little that the equation falls by at most this from
// the lower of the two.
constexpr double kMayTouch = 0.05;
// Joints closer than this are the same branch.
constexpr double kSameRad = 1e-9;

double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from - from.dot(axis) * axis, b = to - to.dot(axis) * axis;
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

Matrix3d baseRotation(double c1, double s1, double theta23) {
  const double c = std::cos(theta23), s = std::sin(theta23);
  Matrix3d r;
  r << c1 * c, -s1, c1 * s, s1 * c, c1, s1 * s, -s, 0, c;
  return r;
}

// Minimum of `of` between lo and hi, by golden section; ends at once if `enough` is true.
template <typename Of, typename Enough>
double minimize(double lo, double hi, const Of& of, const Enough& enough) {
  geometry::GoldenSection search(of, lo, hi);
  for (int n = 0; n < 60 && search.high - search.low > 1e-10; ++n) {
    if (enough(search.atA))
      return search.a;
    if (enough(search.atB))
      return search.b;
    search.step();
  }
  return search.dropsUpper() ? search.a : search.b;
}

} // namespace

// Meeting point and axis 5 as functions of joint 6, in the arm's frame.
struct BentWrist::Circle {
  Vector3d centre, across, ahead, axis5, axis5Across, axis5Ahead;
  Matrix3d displaced; // Rotation of the last link, from zero

  Vector3d wrist(double c, double s) const { return centre + c * across - s * ahead; }
  Vector3d fifth(double c, double s) const { return axis5 + c * axis5Across - s * axis5Ahead; }
};

// One place on the circle. Its four ways: shoulder front, back; each with the elbow up, down.
struct BentWrist::Sample {
  double t;
  std::array<double, 2> reach{}; // Per shoulder: not negative if the point is in reach
  std::array<double, 4> miss{};  // Error of the equation
  std::array<Vector3d, 4> axis4;
  bool has(std::size_t branch) const { return reach[branch / 2] >= 0.0; }
};

class BentWrist::Search {
public:
  Search(const BentWrist& arm, const Circle& circle) : arm_(arm), circle_(circle) {}

  void run(std::vector<JointVector>& solutions) {
    look();
    for (std::size_t branch = 0; branch < 4; ++branch)
      rootsOf(branch);
    const std::size_t before = solutions.size();
    for (const auto& [branch, t] : roots_) {
      const JointVector q = jointsAt(branch, t);
      const bool known =
          std::any_of(solutions.begin() + static_cast<std::ptrdiff_t>(before), solutions.end(),
                      [&](const JointVector& other) { return sameJoints(q, other, kSameRad); });
      if (!known)
        solutions.push_back(q);
    }
  }

private:
  struct Elbow {
    double along, x, z, cosine;
  };
  // Computes the elbow triangle for the wrist's point; returns the reach as in Sample.
  double shoulderAt(const Vector3d& wrist, std::size_t shoulder, Elbow& elbow) const {
    const OrthoBase& g = arm_.base_;
    const double ahead = wrist.x() * wrist.x() + wrist.y() * wrist.y() - g.b * g.b;
    if (ahead < 0.0)
      return ahead / (g.c2 * g.c2) - 1.0;
    elbow.along = shoulder == 0 ? std::sqrt(ahead) : -std::sqrt(ahead);
    elbow.x = elbow.along - g.a1;
    elbow.z = wrist.z();
    elbow.cosine =
        (elbow.x * elbow.x + elbow.z * elbow.z - g.c2 * g.c2 - arm_.forearm_ * arm_.forearm_) /
        (2.0 * g.c2 * arm_.forearm_);
    return 1.0 - std::abs(elbow.cosine);
  }

  Sample at(double t) const {
    Sample sample;
    sample.t = t;
    const double c = std::cos(t), s = std::sin(t);
    const Vector3d wrist = circle_.wrist(c, s), fifth = circle_.fifth(c, s);
    const double square = wrist.x() * wrist.x() + wrist.y() * wrist.y();
    for (std::size_t shoulder = 0; shoulder < 2; ++shoulder) {
      Elbow e{};
      sample.reach[shoulder] = shoulderAt(wrist, shoulder, e);
      if (sample.reach[shoulder] < 0.0)
        continue;
      const OrthoBase& g = arm_.base_;
      const double turned = square > 0.0 ? 1.0 / square : 0.0;
      const double c1 = (e.along * wrist.x() + g.b * wrist.y()) * turned;
      const double s1 = (e.along * wrist.y() - g.b * wrist.x()) * turned;
      const double bend = std::sqrt(std::max(0.0, (1.0 - e.cosine) * (1.0 + e.cosine)));
      const double far = g.c2 + arm_.forearm_ * e.cosine;
      const double rho = 1.0 / std::max(1e-300, e.x * e.x + e.z * e.z);
      for (std::size_t elbow = 0; elbow < 2; ++elbow) {
        // cos and sin of theta2 + theta3, as a product of three rotations.
        const double s3 = elbow == 0 ? bend : -bend;
        const double side = arm_.forearm_ * s3;
        const double c2 = e.z * far + e.x * side, s2 = e.x * far - e.z * side;
        const double ce = e.cosine * arm_.cosBend_ + s3 * arm_.sinBend_;
        const double se = s3 * arm_.cosBend_ - e.cosine * arm_.sinBend_;
        const double c23 = (c2 * ce - s2 * se) * rho, s23 = (s2 * ce + c2 * se) * rho;
        const std::size_t branch = 2 * shoulder + elbow;
        sample.axis4[branch] = Vector3d(c1 * s23, s1 * s23, c23);
        sample.miss[branch] = arm_.base_.sign4 * sample.axis4[branch].dot(fifth) - arm_.cosine45_;
      }
    }
    return sample;
  }

  bool tooFar(const Sample& a, const Sample& b) const {
    for (std::size_t branch = 0; branch < 4; ++branch) {
      if (a.has(branch) != b.has(branch))
        return true;
      if (a.has(branch) && a.axis4[branch].dot(b.axis4[branch]) < cosBetween_)
        return true;
    }
    return false;
  }
  void between(const Sample& a, const Sample& b, int depth) {
    if (depth == 0 || !tooFar(a, b))
      return;
    const Sample middle = at(0.5 * (a.t + b.t));
    between(a, middle, depth - 1);
    samples_.push_back(middle);
    between(middle, b, depth - 1);
  }

  void look() {
    samples_.reserve(3 * kPlaces);
    Sample last = at(-kPi);
    const Sample first = last;
    samples_.push_back(first);
    for (int i = 1; i <= kPlaces; ++i) {
      Sample next = first;
      next.t = kPi;
      if (i < kPlaces)
        next = at(-kPi + base::kTwoPi * i / kPlaces);
      between(last, next, kDepth);
      samples_.push_back(next);
      last = next;
    }
    islands();
    ends();
  }

  // Finds intervals in reach between two places out of reach.
  void islands() {
    const std::size_t last = samples_.size() - 1; // The first place again, one turn later
    const std::vector<Sample> seen = samples_;
    for (std::size_t shoulder = 0; shoulder < 2; ++shoulder)
      for (std::size_t i = 0; i < last; ++i) {
        Sample before = seen[i == 0 ? last - 1 : i - 1];
        if (i == 0)
          before.t -= base::kTwoPi;
        const Sample &here = seen[i], &after = seen[i + 1];
        const double maximum = here.reach[shoulder];
        if (maximum >= 0.0 || before.reach[shoulder] >= 0.0 || after.reach[shoulder] >= 0.0 ||
            maximum < before.reach[shoulder] || maximum < after.reach[shoulder] || maximum < -0.2)
          continue;
        const double t = minimize(
            before.t, after.t, [&](double x) { return -at(x).reach[shoulder]; },
            [](double outside) { return outside <= 0.0; });
        const Sample island = at(t);
        if (island.reach[shoulder] < 0.0)
          continue;
        between(t < here.t ? before : here, island, kDepth);
        samples_.push_back(island);
        between(island, t < here.t ? here : after, kDepth);
      }
    inOrder();
  }

  // Samples the places where a way ends, together with that of the other elbow.
  void ends() {
    const std::vector<Sample> seen = samples_;
    for (std::size_t shoulder = 0; shoulder < 2; ++shoulder)
      for (std::size_t i = 0; i + 1 < seen.size(); ++i) {
        const bool first = seen[i].reach[shoulder] >= 0.0;
        if (first == (seen[i + 1].reach[shoulder] >= 0.0))
          continue;
        Sample inside = first ? seen[i] : seen[i + 1];
        double outside = first ? seen[i + 1].t : seen[i].t;
        for (int n = 0; n < 60 && std::abs(outside - inside.t) > 1e-15; ++n) {
          const Sample middle = at(0.5 * (inside.t + outside));
          if (middle.reach[shoulder] >= 0.0)
            inside = middle;
          else
            outside = middle.t;
        }
        samples_.push_back(inside);
      }
    inOrder();
  }

  void inOrder() {
    std::sort(samples_.begin(), samples_.end(),
              [](const Sample& a, const Sample& b) { return a.t < b.t; });
  }

  double missAt(std::size_t branch, double t) const { return at(t).miss[branch]; }

  void addRoot(std::size_t branch, double t) { roots_.emplace_back(branch, t); }

  // Regula falsi that halves the value at an end that stays (Illinois).
  void rootBetween(std::size_t branch, double a, double fa, double b, double fb) {
    if (fa == 0.0)
      return addRoot(branch, a);
    for (int n = 0; n < 100 && fb != 0.0 && std::abs(b - a) > 1e-16; ++n) {
      double t = (fa * b - fb * a) / (fa - fb);
      if (n > 20) // Slow convergence near a curved root
        t = 0.5 * (a + b);
      if (t == a || t == b)
        break;
      const Sample sample = at(t);
      if (!sample.has(branch))
        return;
      const double f = sample.miss[branch];
      if ((f < 0.0) == (fb < 0.0))
        fa *= 0.5;
      else {
        a = b;
        fa = fb;
      }
      b = t;
      fb = f;
    }
    addRoot(branch, b);
  }

  void rootsOf(std::size_t branch) {
    const std::size_t last = samples_.size() - 1; // The first place again, one turn later
    for (std::size_t i = 0; i < last; ++i) {
      const Sample &a = samples_[i], &b = samples_[i + 1];
      if (a.has(branch) && b.has(branch) && (a.miss[branch] < 0.0) != (b.miss[branch] < 0.0))
        rootBetween(branch, a.t, a.miss[branch], b.t, b.miss[branch]);
      touchAt(branch, samples_[i == 0 ? last - 1 : i - 1], a, b);
    }
  }

  // Between places on the same side of zero the equation may touch zero, or cross it twice. At the
  // end of a way the other elbow's way continues it, so that a root may be on either side of the
  // end.
  void touchAt(std::size_t branch, const Sample& before, const Sample& here, const Sample& after) {
    if (!here.has(branch) || std::abs(here.miss[branch]) > kMayTouch)
      return;
    const double sign = here.miss[branch] < 0.0 ? -1.0 : 1.0, f = sign * here.miss[branch];
    const auto lower = [&](const Sample& other) {
      return other.has(branch) && sign * other.miss[branch] < f;
    };
    if (lower(before) || lower(after))
      return;
    const double t0 = !before.has(branch) ? here.t
                      : before.t > here.t ? before.t - base::kTwoPi
                                          : before.t;
    const double t2 = after.has(branch) ? after.t : here.t;
    const double f0 = before.has(branch) ? before.miss[branch] : here.miss[branch];
    const double f2 = after.has(branch) ? after.miss[branch] : here.miss[branch];
    const double t = minimize(
        t0, t2, [&](double x) { return sign * missAt(branch, x); },
        [](double x) { return x < 0.0; });
    const Sample bottom = at(t);
    if (!bottom.has(branch))
      return;
    if (sign * bottom.miss[branch] < 0.0) {
      rootBetween(branch, t0, f0, t, bottom.miss[branch]);
      rootBetween(branch, t, bottom.miss[branch], t2, f2);
    } else if (std::abs(bottom.miss[branch]) < kTouches) {
      addRoot(branch, t);
    }
  }

  JointVector jointsAt(std::size_t branch, double t) const {
    const OrthoBase& g = arm_.base_;
    const double c = std::cos(t), s = std::sin(t);
    const Vector3d wrist = circle_.wrist(c, s), fifth = circle_.fifth(c, s);
    Elbow e{};
    shoulderAt(wrist, branch / 2, e);
    const double square = wrist.x() * wrist.x() + wrist.y() * wrist.y();
    const double theta1 = square > 0.0 ? std::atan2(e.along * wrist.y() - g.b * wrist.x(),
                                                    e.along * wrist.x() + g.b * wrist.y())
                                       : 0.0;
    const double cosine = std::clamp(e.cosine, -1.0, 1.0);
    const double bend = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    const double s3 = branch % 2 == 0 ? bend : -bend;
    const double theta3 = std::atan2(s3, cosine) - arm_.bend_;
    const double theta2 =
        std::atan2(e.x, e.z) - std::atan2(arm_.forearm_ * s3, g.c2 + arm_.forearm_ * cosine);

    const Matrix3d third = baseRotation(std::cos(theta1), std::sin(theta1), theta2 + theta3) *
                           baseRotation(1.0, 0.0, g.theta2AtZero + g.theta3AtZero).transpose();
    const Vector3d fourth = third * arm_.axis4_;
    const Matrix3d lastBut =
        circle_.displaced * Eigen::AngleAxisd(-t, arm_.axis6_).toRotationMatrix();
    JointVector q(6);
    q << theta1, theta2 - g.theta2AtZero, g.sign3 * (theta3 - g.theta3AtZero),
        angleAbout(fourth, third * arm_.axis5_, fifth),
        angleAbout(fifth, fourth, lastBut * arm_.axis4_), t;
    for (int i = 0; i < 6; ++i)
      q[i] = wrappedAngle(q[i]);
    return q;
  }

  const BentWrist& arm_;
  const Circle& circle_;
  const double cosBetween_ = std::cos(kAngleBetween);
  std::vector<Sample> samples_;
  std::vector<std::pair<std::size_t, double>> roots_;
};

std::optional<BentWrist> BentWrist::of(const SerialChain& chain) {
  const std::vector<AxisLine> axes = axesAtZero(chain);
  base::require(axes.size() == 6, "an arm of six axes");
  const std::optional<Vector3d> wrist = meetingPoint(axes[3], axes[4]);
  if (!wrist)
    return std::nullopt;
  const std::optional<OrthoBase> base = orthoBaseOf(axes, *wrist);
  if (!base)
    return std::nullopt;
  BentWrist arm;
  arm.base_ = *base;
  const Isometry3d arm_T_base = base->base_T_arm.inverse();
  arm.flange_T_arm_ = chainFlange(chain, JointVector::Zero(6)).inverse() * base->base_T_arm;
  arm.axis4_ = arm_T_base.linear() * axes[3].direction;
  arm.axis5_ = arm_T_base.linear() * axes[4].direction;
  arm.axis6_ = arm_T_base.linear() * axes[5].direction;
  arm.point6_ = arm_T_base * axes[5].point;
  arm.wrist_ = arm_T_base * *wrist;
  arm.forearm_ = std::hypot(base->a2, base->c3);
  arm.bend_ = std::atan2(base->a2, base->c3);
  arm.cosBend_ = std::cos(arm.bend_);
  arm.sinBend_ = std::sin(arm.bend_);
  arm.cosine45_ = arm.axis4_.dot(arm.axis5_);
  return arm;
}

void BentWrist::inverse(const Isometry3d& base_T_flange,
                        std::vector<JointVector>& solutions) const {
  const Isometry3d moved = base_.base_T_arm.inverse() * base_T_flange * flange_T_arm_;
  const auto circleOf = [&](const Vector3d& v, Vector3d& middle, Vector3d& across,
                            Vector3d& ahead) {
    const Vector3d along = v.dot(axis6_) * axis6_, beside = v - along;
    middle = moved.linear() * along;
    across = moved.linear() * beside;
    ahead = moved.linear() * axis6_.cross(beside);
  };
  Circle circle;
  circleOf(wrist_ - point6_, circle.centre, circle.across, circle.ahead);
  circle.centre += moved * point6_;
  circleOf(axis5_, circle.axis5, circle.axis5Across, circle.axis5Ahead);
  circle.displaced = moved.linear();
  Search(*this, circle).run(solutions);
}

} // namespace voluta::robot
