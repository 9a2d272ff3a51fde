#include "pipeline/slow_spans.h"
#include "plan/trajectory.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {
// A point a second.
plan::Trajectory seconds(std::size_t points) {
  plan::Trajectory t;
  t.dof = 1;
  for (std::size_t i = 0; i < points; ++i) {
    t.joints.push_back(0.0);
    t.timeS.push_back(static_cast<double>(i));
    t.extrudedMm3.push_back(0.0);
    t.move.push_back(plan::MoveKind::Print);
    t.waypoint.push_back(plan::kNoWaypoint);
  }
  return t;
}
} // namespace

TEST(SlowSpans, AreWhereTheControllerTakesLonger) {
  const plan::Trajectory t = seconds(10);
  const std::size_t none = static_cast<std::size_t>(-1);
  // Motions 3 and 4 take half as long again, 7 a little more, one has no point, one is faster.
  const std::vector<std::size_t> pointOf = {0, 1, 2, 3, 4, none, 5, 6, 7, 8};
  const std::vector<double> motionS = {0, 1, 1, 1.5, 1.5, 9, 1, 1.04, 2, 0.5};
  const auto spans = pipeline::slowSpans(t, pointOf, motionS);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_DOUBLE_EQ(spans[0].fromS, 2.0);
  EXPECT_DOUBLE_EQ(spans[0].toS, 4.0);
  EXPECT_DOUBLE_EQ(spans[0].moreS, 1.0);
  EXPECT_DOUBLE_EQ(spans[1].fromS, 6.0);
  EXPECT_DOUBLE_EQ(spans[1].moreS, 1.0);
  EXPECT_TRUE(pipeline::slowSpans(t, pointOf, std::vector<double>(10, 1.0)).empty());
  EXPECT_TRUE(pipeline::slowSpans({}, {}, {}).empty());
}

TEST(SlowSpans, AreNeverMoreThanCanBeSeen) {
  const std::size_t n = 100000;
  const plan::Trajectory t = seconds(n);
  std::vector<std::size_t> pointOf;
  std::vector<double> motionS;
  for (std::size_t i = 0; i < n; ++i) {
    pointOf.push_back(i);
    motionS.push_back(i % 2 == 0 ? 2.0 : 1.0);
  }
  EXPECT_LE(pipeline::slowSpans(t, pointOf, motionS).size(), 1000u);
}
