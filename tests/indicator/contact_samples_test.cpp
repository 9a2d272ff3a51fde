#include "indicator/contact_samples.h"

#include "base/run_context.h"
#include "indicator/joint_circle.h"
#include "indicator/planar_arm.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using indicator::JudgedJoints;
using robot::JointVector;

namespace {

constexpr std::size_t kFirst = 200;

std::vector<JudgedJoints> sampled(const test::PlanarArm& arm,
                                  const indicator::ContactSampling& sampling,
                                  const base::RunContext& ctx) {
  return indicator::contactSamples(
      arm.onTheLine(kFirst, 1), arm.limits(), [&](const JointVector& q) { return arm.collides(q); },
      [](const JointVector& q) { return test::PlanarArm::project(q); }, sampling, ctx);
}

double nearTheBorder(const test::PlanarArm& arm, const std::vector<JudgedJoints>& samples) {
  double near = 0;
  for (const JudgedJoints& s : samples)
    near += std::abs(arm.clearance(s.q)) < 0.05;
  return near / static_cast<double>(samples.size());
}

} // namespace

TEST(ContactSamples, AreTrueAndApart) {
  const test::PlanarArm arm;
  indicator::ContactSampling sampling;
  sampling.samples = 1200;
  const std::vector<JudgedJoints> samples = sampled(arm, sampling, {});
  ASSERT_GT(samples.size(), 2 * kFirst);
  ASSERT_LE(samples.size(), sampling.samples);
  std::size_t onLine = 0;
  std::vector<Eigen::VectorXd> points;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const JudgedJoints& s = samples[i];
    EXPECT_EQ(s.collides, arm.collides(s.q));
    const bool on = std::abs(test::PlanarArm::joints(s.q)[3].y() - 1.0) < 1e-6;
    EXPECT_TRUE(on || i >= kFirst);
    onLine += on && i >= kFirst;
    points.push_back(indicator::onCircle(s.q, arm.limits()));
    for (std::size_t o = 0; o < i && i >= kFirst; ++o)
      EXPECT_GE((points[i] - points[o]).norm(), 0.5 * sampling.borderRad - 1e-12) << i << " " << o;
  }
  // Half of them are projected, and some of the others are there by chance.
  const double share = static_cast<double>(onLine) / static_cast<double>(samples.size() - kFirst);
  EXPECT_GT(share, 0.4);
  EXPECT_LT(share, 0.6);
}

TEST(ContactSamples, CrowdAtTheBorder) {
  const test::PlanarArm arm;
  indicator::ContactSampling sampling;
  sampling.samples = 1200;
  std::vector<JudgedJoints> random;
  for (const JointVector& q : arm.onTheLine(5000, 2))
    random.push_back({q, false});
  EXPECT_GT(nearTheBorder(arm, sampled(arm, sampling, {})), 2.0 * nearTheBorder(arm, random));
}

TEST(ContactSamples, AreTheSameForAnyThreads) {
  const test::PlanarArm arm;
  indicator::ContactSampling sampling;
  sampling.samples = 600;
  const auto one = sampled(arm, sampling, {});
  const auto two = sampled(arm, sampling, base::RunContext(base::CancelToken(), 3));
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].q, two[i].q);
}

// Where nothing collides there is no border: sampling ends by itself once samples are even.
TEST(ContactSamples, SamplingEndsWhereThereIsNoContact) {
  test::PlanarArm arm;
  arm.disc = {100.0, 0.0};
  indicator::ContactSampling sampling;
  sampling.samples = 100000;
  sampling.borderRad = 0.3;
  const auto samples = sampled(arm, sampling, {});
  EXPECT_GT(samples.size(), kFirst - 1);
  EXPECT_LT(samples.size(), 5000u);
}
