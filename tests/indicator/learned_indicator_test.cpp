#include "indicator/learned_indicator.h"

#include "base/run_context.h"
#include "base/units.h"
#include "indicator/contact_samples.h"
#include "indicator/joint_circle.h"
#include "indicator/planar_arm.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using indicator::JudgedJoints;
using indicator::LearnedIndicator;
using robot::JointVector;

namespace {

constexpr robot::JointLimits kTurning{-base::kTwoPi, base::kTwoPi, 1.0, 1.0};
constexpr robot::JointLimits kSliding{-500.0, 500.0, 1.0, 1.0, robot::JointKind::Sliding};

JointVector joints(double a, double b) {
  JointVector q(2);
  q << a, b;
  return q;
}

std::vector<JudgedJoints> taught(const test::PlanarArm& arm, const std::vector<JointVector>& all) {
  std::vector<JudgedJoints> samples;
  for (const JointVector& q : all)
    samples.push_back({q, arm.collides(q)});
  return samples;
}

struct Rates {
  double freeFound = 0.0, missed = 0.0; // shares of the free and of the colliding samples
};

Rates rates(const LearnedIndicator& learned, const test::PlanarArm& arm,
            const std::vector<JointVector>& all) {
  double free = 0, found = 0, colliding = 0, missed = 0;
  for (const JointVector& q : all) {
    const bool says = learned.saysFree(q), collides = arm.collides(q);
    free += !collides;
    found += !collides && says;
    colliding += collides;
    missed += collides && says;
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(colliding, 1000);
  return {found / free, missed / colliding};
}

} // namespace

TEST(JointCircle, HasTheLengthOfSmallSteps) {
  const std::vector<robot::JointLimits> limits{kTurning, kSliding};
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> at(-10.0, 10.0), step(-1e-3, 1e-3);
  for (int n = 0; n < 100; ++n) {
    const JointVector a = joints(at(engine), 50.0 * at(engine));
    const JointVector b = a + joints(step(engine), 100.0 * step(engine));
    const double apart = (indicator::onCircle(a, limits) - indicator::onCircle(b, limits)).norm();
    EXPECT_NEAR(apart, std::hypot(b[0] - a[0], (b[1] - a[1]) / 100.0), 1e-9);
  }
}

TEST(JointCircle, HalfWayIsTheShorterWayRound) {
  const std::vector<robot::JointLimits> limits{kTurning, kSliding};
  const JointVector q = indicator::jointMidpoint(joints(3.0, -20.0), joints(-3.0, 60.0), limits);
  EXPECT_NEAR(std::abs(q[0]), base::kPi, 1e-12);
  EXPECT_NEAR(q[1], 20.0, 1e-12);
  EXPECT_NEAR(
      indicator::jointMidpoint(joints(0.2, 0), joints(0.5 + 2 * base::kTwoPi, 0), limits)[0], 0.35,
      1e-12);
}

// Two samples a chord d apart: kernels of weights 1 / (1 - exp(-gamma d^2)) and its negative.
TEST(LearnedIndicator, OfTwoSamplesIsKnown) {
  const std::vector<robot::JointLimits> limits{kTurning, kSliding};
  const JointVector bad = joints(0.3, 40.0), good = joints(-0.4, -30.0);
  indicator::LearningOptions options;
  options.penalty = 1e4;
  options.bias = 0.25;
  for (const bool badFirst : {true, false}) {
    std::vector<JudgedJoints> samples{{bad, true}, {good, false}};
    if (!badFirst)
      std::swap(samples[0], samples[1]);
    const LearnedIndicator learned(samples, limits, options);
    const auto kernel = [&](const JointVector& a, const JointVector& b) {
      const double chord = 2.0 * std::sin(0.5 * (a[0] - b[0])), slide = (a[1] - b[1]) / 100.0;
      return std::exp(-0.7 * (chord * chord + slide * slide));
    };
    EXPECT_EQ(learned.kernels(), 2u);
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> at(-3.0, 3.0);
    for (int n = 0; n < 100; ++n) {
      const JointVector q = joints(at(engine), 50.0 * at(engine));
      const double expected = 0.25 + (kernel(q, bad) - kernel(q, good)) / (1.0 - kernel(bad, good));
      EXPECT_NEAR(learned.value(q), expected, 2e-3);
      EXPECT_EQ(learned.saysFree(q), learned.value(q) < 0.0);
    }
  }
}

TEST(LearnedIndicator, SamplesOfOneKindGiveAConstantIndicator) {
  const std::vector<robot::JointLimits> limits{kTurning, kTurning};
  std::vector<JudgedJoints> samples{{joints(0, 0), false}, {joints(1, 1), false}};
  EXPECT_TRUE(LearnedIndicator(samples, limits, {}).saysFree(joints(3, -2)));
  EXPECT_TRUE(LearnedIndicator(samples, limits, {}).gradient(joints(3, -2)).isZero());
  for (JudgedJoints& s : samples)
    s.collides = true;
  EXPECT_FALSE(LearnedIndicator(samples, limits, {}).saysFree(joints(3, -2)));
}

TEST(LearnedIndicator, WholeTurnsChangeNothing) {
  const test::PlanarArm arm;
  const LearnedIndicator learned(taught(arm, arm.onTheLine(400, 1)), arm.limits(), {});
  for (const JointVector& q : arm.onTheLine(100, 2)) {
    JointVector turned = q;
    turned[0] += base::kTwoPi;
    turned[2] -= 2.0 * base::kTwoPi;
    EXPECT_NEAR(learned.value(turned), learned.value(q), 1e-6);
  }
}

TEST(LearnedIndicator, GradientIsThatOfDifferences) {
  const std::vector<robot::JointLimits> limits{kTurning, kSliding};
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> at(-3.0, 3.0);
  std::vector<JudgedJoints> samples;
  for (int n = 0; n < 200; ++n) {
    const JointVector q = joints(at(engine), 50.0 * at(engine));
    samples.push_back({q, std::cos(q[0]) + q[1] / 100.0 > 0.3});
  }
  const LearnedIndicator learned(samples, limits, {});
  for (int n = 0; n < 50; ++n) {
    const JointVector q = joints(at(engine), 50.0 * at(engine));
    const JointVector gradient = learned.gradient(q);
    for (Eigen::Index j = 0; j < 2; ++j) {
      const double h = j == 0 ? 1e-5 : 1e-3;
      JointVector more = q, less = q;
      more[j] += h;
      less[j] -= h;
      EXPECT_NEAR(gradient[j], (learned.value(more) - learned.value(less)) / (2.0 * h), 1e-4);
    }
  }
}

// Trained on a disc, it finds most of the free samples, and samples it calls free are free, on the
// line and beside it.
TEST(LearnedIndicator, LearnsADisc) {
  const test::PlanarArm arm;
  indicator::ContactSampling sampling;
  sampling.samples = 1500;
  const std::vector<JudgedJoints> samples = indicator::contactSamples(
      arm.onTheLine(250, 1), arm.limits(), [&](const JointVector& q) { return arm.collides(q); },
      [](const JointVector& q) { return test::PlanarArm::project(q); }, sampling, {});
  const LearnedIndicator learned(samples, arm.limits(), {});
  EXPECT_LT(learned.kernels(), samples.size());
  const std::vector<JointVector> line = arm.onTheLine(20000, 9);
  for (const auto& all : {line, test::shaken(line, 0.1, 10)}) {
    const Rates r = rates(learned, arm, all);
    EXPECT_GT(r.freeFound, 0.8);
    EXPECT_LT(r.missed, 0.02);
  }
}

// The bias makes it careful: fewer colliding samples are missed, fewer free ones found.
TEST(LearnedIndicator, MoreBiasIsMoreCareful) {
  const test::PlanarArm arm;
  const std::vector<JudgedJoints> samples = taught(arm, arm.onTheLine(500, 1));
  const std::vector<JointVector> line = arm.onTheLine(20000, 9);
  Rates last{1.0, 1.0};
  std::vector<Rates> all;
  for (const double bias : {0.0, 0.5, 1.0, 2.0}) {
    indicator::LearningOptions options;
    options.bias = bias;
    const Rates r = rates(LearnedIndicator(samples, arm.limits(), options), arm, line);
    EXPECT_LE(r.missed, last.missed);
    EXPECT_LE(r.freeFound, last.freeFound);
    last = r;
    all.push_back(r);
  }
  EXPECT_LT(all.back().missed, all.front().missed);
  EXPECT_LT(all.back().freeFound, all.front().freeFound);
}

// A bias fitted to a share of missed collisions on unseen samples keeps to it on others.
TEST(LearnedIndicator, CarefulBiasKeepsItsShare) {
  const test::PlanarArm arm;
  const LearnedIndicator learned(taught(arm, arm.onTheLine(500, 1)), arm.limits(), {});
  const std::vector<JudgedJoints> heldOut =
      taught(arm, test::shaken(arm.onTheLine(20000, 5), 0.1, 6));
  double last = 1e9;
  for (const double share : {0.0, 0.01, 0.05, 0.2}) {
    const double more = carefulBias(learned, heldOut, share);
    EXPECT_LT(more, last);
    last = more;
    const LearnedIndicator careful = learned.withBias(more);
    EXPECT_NEAR(careful.value(heldOut[0].q), learned.value(heldOut[0].q) + more, 1e-9);
    const double others = rates(careful, arm, test::shaken(arm.onTheLine(20000, 7), 0.1, 8)).missed;
    EXPECT_NEAR(others, share, 0.003 + 0.05 * share);
  }
  EXPECT_EQ(carefulBias(learned, {{heldOut[0].q, false}}, 0.01), 0.0);
}
