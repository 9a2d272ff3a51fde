// Lines and contours of plane layers: closed forms, and random contours against slow answers.
#include "base/run_context.h"
#include "base/units.h"
#include "toolpath/plane/connected_parts.h"
#include "toolpath/plane/contours.h"
#include "toolpath/plane/field_lines.h"
#include "toolpath/plane/joined_lines.h"
#include "toolpath/plane/spaced_points.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::toolpath {
namespace {

using Eigen::Vector2d;

ClipperLib::Path loop(const std::vector<Vector2d>& points) {
  ClipperLib::Path path;
  for (const Vector2d& p : points)
    path.push_back(geometry::pathPoint(p));
  return path;
}

ClipperLib::Path rectangle(double width, double height, Vector2d centre = {0, 0}) {
  const double x = 0.5 * width, y = 0.5 * height;
  return loop({centre + Vector2d(-x, -y), centre + Vector2d(x, -y), centre + Vector2d(x, y),
               centre + Vector2d(-x, y)});
}

// A star-shaped loop with random radii.
ClipperLib::Path blob(std::mt19937_64& random, double radius, Vector2d centre = {0, 0}) {
  std::uniform_real_distribution<double> share(0.4, 1.0);
  std::vector<Vector2d> points;
  for (int i = 0; i < 40; ++i) {
    const double angle = base::kPi * i / 20.0;
    points.push_back(centre + share(random) * radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return loop(points);
}

double lengthOf(const PlaneLine& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    length += (line.points[i] - line.points[i - 1]).norm();
  return length + (line.isClosed ? (line.points.front() - line.points.back()).norm() : 0.0);
}

double distanceTo(const PlaneLine& line, const Vector2d& p) {
  double nearest = INFINITY;
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i + (line.isClosed ? 0 : 1) < n; ++i) {
    const Vector2d &a = line.points[i], &b = line.points[(i + 1) % n];
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * (b - a)).norm());
  }
  return nearest;
}

TEST(Contours, ContainWhatClipperSays) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> place(-12.0, 12.0);
  for (int trial = 0; trial < 20; ++trial) {
    const ClipperLib::Path outline = blob(random, 10.0), hole = blob(random, 3.0);
    const Contours contours({outline, hole});
    for (int i = 0; i < 500; ++i) {
      const Vector2d p(place(random), place(random));
      const int in = ClipperLib::PointInPolygon(geometry::pathPoint(p), outline),
                inHole = ClipperLib::PointInPolygon(geometry::pathPoint(p), hole);
      if (in >= 0 && inHole >= 0) {
        EXPECT_EQ(contours.contains(p), in == 1 && inHole == 0);
      }
    }
  }
}

// Between two crossings a segment is wholly inside or wholly outside.
TEST(Contours, CrossingsSeparateInsideFromOutside) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-12.0, 12.0);
  for (int trial = 0; trial < 200; ++trial) {
    const Contours contours({blob(random, 10.0)});
    const Vector2d a(place(random), place(random)), b(place(random), place(random));
    bool isInside = contours.contains(a);
    double last = 0.0;
    for (const Contours::Crossing& crossing : contours.crossings(a, b)) {
      EXPECT_EQ(contours.contains(a + 0.5 * (last + crossing.share) * (b - a)), isInside);
      const Vector2d there = a + crossing.share * (b - a);
      EXPECT_LT(
          (contours.between(0, crossing.place.arcMm, crossing.place.arcMm).front() - there).norm(),
          1e-9);
      isInside = !isInside;
      last = crossing.share;
    }
    EXPECT_EQ(contours.contains(b), isInside);
  }
}

TEST(Contours, BetweenRunsAroundTheFirstPoint) {
  const Contours contours({rectangle(10, 10)}); // begins at (-5, -5), counter-clockwise
  EXPECT_DOUBLE_EQ(contours.lengthMm(0), 40.0);
  const std::vector<Vector2d> around = contours.between(0, 38.0, 3.0);
  ASSERT_EQ(around.size(), 3U);
  EXPECT_LT((around[0] - Vector2d(-5, -3)).norm(), 1e-9);
  EXPECT_LT((around[1] - Vector2d(-5, -5)).norm(), 1e-9);
  EXPECT_LT((around[2] - Vector2d(-2, -5)).norm(), 1e-9);
}

TEST(ConnectedParts, KeepTheirHoles) {
  ClipperLib::Path hole = rectangle(4, 4);
  ClipperLib::ReversePath(hole);
  const auto parts =
      connectedParts({rectangle(10, 10), hole, rectangle(2, 2), rectangle(3, 3, {20, 0})});
  ASSERT_EQ(parts.size(), 3U);
  std::vector<double> areas;
  for (const ClipperLib::Paths& part : parts)
    areas.push_back(geometry::areaMm2(part));
  std::ranges::sort(areas);
  EXPECT_NEAR(areas[0], 4.0, 1e-6);
  EXPECT_NEAR(areas[1], 9.0, 1e-6);
  EXPECT_NEAR(areas[2], 84.0, 1e-6);
}

TEST(FieldLines, CirclesAreExactOnACoarseGrid) {
  const auto radius = [](const Vector2d& p) { return p.norm() / 4.0; };
  const auto everywhere = [](const Vector2d&) { return true; };
  const std::vector<PlaneLine> lines = fieldLines({{-11, -11}, {11, 11}}, 1.0, radius, everywhere);
  ASSERT_EQ(lines.size(), 3U + 4U); // radii 2, 6 and 10, and 14 in the corners
  for (const PlaneLine& line : lines) {
    const double r = line.points.front().norm();
    EXPECT_EQ(line.isClosed, r < 11.0);
    for (const Vector2d& p : line.points)
      EXPECT_NEAR(p.norm(), std::round((r - 2.0) / 4.0) * 4.0 + 2.0, 0.01);
  }
}

TEST(FieldLines, AreOnlySoughtWhereTheyAreWanted) {
  const auto across = [](const Vector2d& p) { return p.y(); };
  const auto left = [](const Vector2d& p) { return p.x() < 0.0; };
  for (const PlaneLine& line : fieldLines({{-10, -10}, {10, 10}}, 1.0, across, left)) {
    EXPECT_FALSE(line.isClosed);
    EXPECT_NEAR(lengthOf(line), 10.0, 1.1);
  }
}

std::vector<PlaneLine> parallelLines(double spacing, double reach) {
  std::vector<PlaneLine> lines;
  for (double y = -reach; y <= reach; y += spacing)
    lines.push_back({{{-reach, y}, {0.0, y}, {reach, y}}, false});
  return lines;
}

LineJoints joints(double longest, double total) {
  return {0.5, 0.3, 1.0, longest, total};
}

TEST(JoinedLines, ParallelLinesBecomeOneZigzag) {
  const ClipperLib::Paths area{rectangle(20, 20.6)};
  const std::vector<PlaneLine> lines =
      joinedLines(parallelLines(2.0, 15.0), area, joints(3, 1e9), {});
  ASSERT_EQ(lines.size(), 1U);
  const int count = 9; // the lines at y = ±1, ±3, … ±9 are 10; one joint between each two
  EXPECT_NEAR(lengthOf(lines.front()), 10 * 19.0 + count * 2.0 + 2 * 0.8, 1e-6);
}

TEST(JoinedLines, JointsKeepToTheirLimits) {
  const ClipperLib::Paths area{rectangle(20, 20.6)};
  const auto count = [&](const LineJoints& limits) {
    return joinedLines(parallelLines(2.0, 15.0), area, limits, {}).size();
  };
  EXPECT_EQ(count(joints(1.9, 1e9)), 10U) << "too short to reach the next line";
  EXPECT_EQ(count(joints(3.0, 0.0)), 10U);
  EXPECT_EQ(count(joints(3.0, 6.5)), 7U) << "three joints of 2 mm";
}

// Free ends overlap the wall; joined ones keep half a bead from it.
TEST(JoinedLines, EndsReachBeyondTheEdge) {
  const ClipperLib::Paths area{rectangle(20, 20.6)};
  for (const PlaneLine& line : joinedLines(parallelLines(2.0, 15.0), area, joints(0, 0), {})) {
    EXPECT_NEAR(std::abs(line.points.front().x()), 10.3, 1e-6);
    EXPECT_NEAR(std::abs(line.points.back().x()), 10.3, 1e-6);
  }
}

TEST(JoinedLines, StayInsideRandomAreas) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 30; ++trial) {
    const ClipperLib::Paths area{blob(random, 12.0)};
    const Contours wide(geometry::offsetPaths(area, 0.35, {0.01}));
    double free = 0.0, joined = 0.0;
    for (const PlaneLine& line : joinedLines(parallelLines(1.7, 15.0), area, joints(0, 0), {}))
      free += lengthOf(line);
    std::size_t outside = 0, all = 0;
    for (const PlaneLine& line : joinedLines(parallelLines(1.7, 15.0), area, joints(4, 20), {})) {
      joined += lengthOf(line);
      for (std::size_t i = 1; i < line.points.size(); ++i, ++all)
        outside += wide.contains(0.5 * (line.points[i] + line.points[i - 1])) ? 0 : 1;
    }
    EXPECT_EQ(outside, 0U) << "of " << all;
    EXPECT_LE(joined, free + 20.0);
  }
}

TEST(JoinedLines, AClosedLineInsideStaysClosed) {
  PlaneLine ring{{}, true};
  for (int i = 0; i < 60; ++i)
    ring.points.emplace_back(5.0 * std::cos(0.1 * base::kPi * i / 3.0),
                             5.0 * std::sin(0.1 * base::kPi * i / 3.0));
  const auto whole = joinedLines({ring}, {rectangle(20, 20)}, joints(3, 100), {});
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_TRUE(whole.front().isClosed);
  EXPECT_NEAR(lengthOf(whole.front()), lengthOf(ring), 1e-9);
  const auto cut = joinedLines({ring}, {rectangle(20, 8)}, joints(0, 0), {});
  EXPECT_EQ(cut.size(), 2U) << "the part across its first point is one line";
}

TEST(SpacedPoints, KeepToTheLineWithFewPoints) {
  for (const bool isClosed : {false, true}) {
    PlaneLine circle{{}, isClosed};
    for (int i = 0; i < 400; ++i)
      circle.points.emplace_back(10.0 * std::cos(base::kPi * i / 200.0),
                                 10.0 * std::sin(base::kPi * i / 200.0));
    const PlaneLine spaced = spacedPoints(circle, 0.02, 5.0);
    EXPECT_LT(spaced.points.size(), 70U);
    for (const Vector2d& p : circle.points)
      EXPECT_LE(distanceTo(spaced, p), 0.02 + 1e-9);
  }
  const PlaneLine straight = spacedPoints({{{0, 0}, {1, 0}, {10.5, 0}}, false}, 0.01, 1.0);
  EXPECT_EQ(straight.points.size(), 12U);
  for (std::size_t i = 1; i < straight.points.size(); ++i)
    EXPECT_NEAR((straight.points[i] - straight.points[i - 1]).norm(), 10.5 / 11.0, 1e-9);
}

} // namespace
} // namespace voluta::toolpath
