#include "timeline/curve_pyramid.h"
#include "timeline/joint_curves.h"
#include "timeline/sample_program.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace voluta::timeline {
namespace {

TEST(CurvePyramid, IsTheMinimumAndMaximumOfEveryStretch) {
  std::mt19937 random(7);
  for (const std::size_t count : {1u, 15u, 16u, 17u, 255u, 257u, 5000u}) {
    std::vector<float> values(count);
    for (float& v : values)
      v = std::uniform_real_distribution<float>(-5.0f, 5.0f)(random);
    const CurvePyramid pyramid(values);
    for (int i = 0; i < 300; ++i) {
      const std::size_t a = random() % count, b = a + 1 + random() % (count - a);
      const auto [low, high] = std::minmax_element(values.begin() + a, values.begin() + b);
      const ValueRange range = pyramid.over(a, b);
      ASSERT_EQ(range.low, *low) << count << " [" << a << ", " << b << ")";
      ASSERT_EQ(range.high, *high) << count << " [" << a << ", " << b << ")";
    }
  }
  EXPECT_THROW(CurvePyramid({1.0f}).over(0, 0), base::Error);
}

TEST(JointCurves, AFewPointsAreShownAsTheyAre) {
  const test::SampleProgram p = test::sampleProgram(1, 4);
  const JointCurves curves(p.trajectory, {}, {});
  const QList<QPointF> angle = curves.angle(2, 0.0, 4.0, 100);
  ASSERT_EQ(angle.size(), 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(angle[i].x(), i);
    EXPECT_NEAR(angle[i].y(), base::radiansToDegrees(std::sin(0.1 * i + 2)), 1e-4);
  }
}

TEST(JointCurves, JointsRestDuringAWait) {
  const test::SampleProgram p = test::sampleProgram(1, 4);
  p.trajectory->events.push_back({.point = 3, .kind = plan::EventKind::Wait, .seconds = 10.0});
  const JointCurves curves(p.trajectory, {}, {});
  EXPECT_DOUBLE_EQ(curves.durationS(), 14.0);
  const QList<QPointF> angle = curves.angle(2, 0.0, 14.0, 100);
  ASSERT_EQ(angle.size(), 6);
  EXPECT_DOUBLE_EQ(angle[2].x(), 2.0);
  EXPECT_DOUBLE_EQ(angle[3].x(), 12.0);
  EXPECT_EQ(angle[2].y(), angle[3].y());
  EXPECT_DOUBLE_EQ(angle[4].x(), 13.0);
  const QList<QPointF> speed = curves.speed(2, 2.0, 12.0, 100);
  for (const QPointF& point : speed)
    if (point.x() > 2.0 && point.x() < 12.0) {
      EXPECT_EQ(point.y(), 0.0);
    }
}

TEST(JointCurves, SpeedIsThatOfTheMoveAndDrawnAsSteps) {
  const test::SampleProgram p = test::sampleProgram(1, 4, 0.5);
  const JointCurves curves(p.trajectory, {}, {});
  const QList<QPointF> speed = curves.speed(0, 0.0, 2.0, 100);
  const double first = base::radiansToDegrees(std::sin(0.05) / 0.5);
  EXPECT_NEAR(speed[0].y(), first, 1e-3);
  EXPECT_DOUBLE_EQ(speed[1].x(), 0.5); // holds till the next point ...
  EXPECT_NEAR(speed[1].y(), first, 1e-3);
  EXPECT_DOUBLE_EQ(speed[2].x(), 0.5); // ... and changes there
  EXPECT_NE(speed[2].y(), speed[1].y());
}

TEST(JointCurves, SlidingJointIsDrawnInMillimetres) {
  const test::SampleProgram p = test::sampleProgram(1, 4, 0.5, 4);
  using enum robot::JointKind;
  const JointCurves curves(p.trajectory, {Turning, Turning, Sliding, Turning}, {});
  EXPECT_NEAR(curves.angle(2, 0.0, 2.0, 100)[1].y(), std::sin(0.05 + 2), 1e-4);
  EXPECT_NEAR(curves.speed(2, 0.0, 2.0, 100)[0].y(), (std::sin(0.05 + 2) - std::sin(2)) / 0.5,
              1e-4);
  EXPECT_NEAR(curves.angle(3, 0.0, 2.0, 100)[1].y(), base::radiansToDegrees(std::sin(0.05 + 3)),
              1e-4);
}

// Curves of a million points have every extreme in the column it belongs to.
TEST(JointCurves, ReducedCurvesKeepEveryExtreme) {
  const test::SampleProgram p = test::sampleProgram(100, 3450, 0.01);
  plan::Trajectory& t = *p.trajectory;
  const std::size_t spike = 123456;
  t.joints[spike * 6 + 1] = 3.0;
  const JointCurves curves(p.trajectory, {}, {});
  const double end = curves.durationS();
  for (const int columns : {1, 300, 1280}) {
    const QList<QPointF> drawn = curves.angle(1, 0.0, end, columns);
    EXPECT_LE(drawn.size(), 4 * columns + 4);
    EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end(),
                               [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); }));
    const auto top =
        std::max_element(drawn.begin(), drawn.end(),
                         [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
    EXPECT_NEAR(top->y(), base::radiansToDegrees(3.0), 1e-3);
    EXPECT_NEAR(top->x(), t.timeS[spike], end / columns);
  }
  // Seen from near, the points themselves.
  const double at = t.timeS[spike];
  const QList<QPointF> near = curves.angle(1, at - 0.05, at + 0.05, 500);
  EXPECT_LE(near.size(), 14);
  EXPECT_NEAR(curves.angleRange(1).high, base::radiansToDegrees(3.0), 1e-3);
  EXPECT_GT(curves.speedRange(1).high, 5000.0f);
}

TEST(JointCurves, TwoPointsAtOneMomentHaveNoSpeedOfTheirOwn) {
  const test::SampleProgram p = test::sampleProgram(1, 4);
  p.trajectory->timeS[2] = p.trajectory->timeS[1];
  const JointCurves curves(p.trajectory, {}, {});
  for (int j = 0; j < 6; ++j)
    EXPECT_TRUE(std::isfinite(curves.speedRange(j).high) &&
                std::isfinite(curves.speedRange(j).low));
}

} // namespace
} // namespace voluta::timeline
