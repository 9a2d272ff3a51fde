#include "toolpath/coverage/strand_room.h"

#include <cmath>
#include <gtest/gtest.h>

namespace {
using namespace voluta;

toolpath::SurfaceCurve line(double y, double length) {
  toolpath::SurfaceCurve c;
  for (double x = 0.0; x <= length; x += 0.5)
    c.points.push_back({{x, y, 0.0}, 0});
  return c;
}

TEST(StrandRoom, IsTheDistanceOfNeighboursUpToTheReach) {
  const auto room = toolpath::strandRoom({line(0.0, 10.0), line(0.7, 4.0)}, 1.0);
  ASSERT_EQ(room.size(), 2U);
  EXPECT_DOUBLE_EQ(room[0].front(), 0.7);
  EXPECT_DOUBLE_EQ(room[0].at(9), std::hypot(0.5, 0.7));
  EXPECT_DOUBLE_EQ(room[0].back(), 1.0);
  for (const double mm : room[1])
    EXPECT_DOUBLE_EQ(mm, 0.7);
}

// There and back along a narrow rectangle: the two sides are parts of one closed curve.
TEST(StrandRoom, PartsOfOneCurveAreNeighboursButNotAroundItsEnds) {
  toolpath::SurfaceCurve c = line(0.0, 10.0), back = line(0.6, 10.0);
  c.points.insert(c.points.end(), back.points.rbegin(), back.points.rend());
  c.closed = true;
  const auto room = toolpath::strandRoom({c}, 1.0);
  EXPECT_DOUBLE_EQ(room[0].at(10), 0.6);
  EXPECT_GT(room[0].front(), 0.6);
  EXPECT_GT(room[0].at(20), 0.6);
  c.closed = false;
  EXPECT_DOUBLE_EQ(toolpath::strandRoom({c}, 1.0)[0].front(), 0.6);
}

} // namespace
