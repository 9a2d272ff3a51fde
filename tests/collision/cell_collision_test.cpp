#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "collision/shape_distance.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include "base/run_context.h"
#include "base/units.h"
#include "collision/polyhedron_distance.h"
#include "collision/random_shapes.h"
#include "geometry/least_turn.h"

#include <gtest/gtest.h>
#include <set>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

// Points all over a solid's surface and inside it.
std::vector<Vector3d> samples(const robot::Shape& shape, double size, test::RandomShapes& random) {
  std::vector<Vector3d> points;
  while (points.size() < 3000) {
    const Vector3d p = random.point(2.0 * size);
    if (collision::signedDistance(shape, p) <= 0.0)
      points.push_back(p);
  }
  return points;
}

// Of an upright bead.
void addWaypoint(plan::ToolPlan& plan, const Vector3d& tip) {
  plan.position.push_back(tip);
  plan.direction.emplace_back(0, 0, 1);
  plan.widthMm.push_back(1.2f);
  plan.heightMm.push_back(0.8f);
  plan.speedMmPerS.push_back(20);
}

} // namespace

// FCL's distance of the polyhedra against the exact distances of points of one to the other.
TEST(Polyhedron, AgainstSampling) {
  test::RandomShapes random(21);
  for (int n = 0; n < 60; ++n) {
    const robot::Shape a = random.shape(1 + n % 3, 4.0), b = random.shape(1 + n / 3 % 3, 4.0);
    const Isometry3d place = random.pose(8.0);
    const double found = collision::Polyhedron::distance(
        collision::Polyhedron(a), Isometry3d::Identity(), collision::Polyhedron(b), place);
    double minimum = 1e9;
    for (const Vector3d& p : samples(a, 4.0, random))
      minimum = std::min(minimum, collision::signedDistance(b, place.inverse() * p));
    EXPECT_LE(found, std::max(minimum, 0.0) + 1e-6) << n;
    if (minimum > 0.2) {
      EXPECT_GE(found, minimum - 1.0) << n;
    } else if (minimum < 0.0) {
      EXPECT_LE(found, 0.0) << n;
    }
  }
}

// A frustum leaning over a plate: its lowest rim, at most 0.22 % of its radius further out.
TEST(Polyhedron, AFrustumOverAPlateIsAsHighAsItsLowestRim) {
  const robot::Prism slab{{{-90, -90}, {90, -90}, {90, 90}, {-90, 90}}, -5, 0};
  const collision::Polyhedron plate(slab);
  test::RandomShapes random(22);
  for (int n = 0; n < 100; ++n) {
    const double r0 = n % 5 == 0 ? 0.0 : random.number(0.5, 8.0), r1 = random.number(0.5, 8.0);
    const Vector3d p1 = random.number(2.0, 9.0) * random.point(1.0).normalized();
    const collision::Polyhedron frustum(robot::Frustum{{0, 0, 0}, p1, r0, r1});
    const Vector3d u = p1.normalized();
    const double across = std::sqrt(1.0 - u.z() * u.z());
    const double lowest = std::min(-r0 * across, p1.z() - r1 * across);
    for (const double gap : {0.3, 4.0}) {
      const Isometry3d place(Eigen::Translation3d(1.0, -2.0, gap - lowest));
      const double found =
          collision::Polyhedron::distance(frustum, place, plate, Isometry3d::Identity());
      EXPECT_LE(found, gap + 1e-6);
      EXPECT_GE(found, gap - 0.0022 * std::max(r0, r1) - 2e-3);
      EXPECT_NEAR(found,
                  collision::Polyhedron::distance(plate, Isometry3d::Identity(), frustum, place),
                  1e-5);
    }
  }
}

// Boxes turned together are as far apart as they are upright; prisms about one axis as their
// sections, or their heights.
TEST(Polyhedron, BoxesAndPrismsAreAsFarApartAsTheirSides) {
  test::RandomShapes random(23);
  for (int n = 0; n < 60; ++n) {
    const Vector3d half(1, 2, 3), other(2, 1, 0.5);
    const Vector3d gap = n % 4 == 0   ? Vector3d(0.7, 0, 0)
                         : n % 4 == 1 ? Vector3d(0.3, 0.4, 0)
                         : n % 4 == 2 ? Vector3d(0.2, 0.3, 0.6)
                                      : Vector3d(0, 0, 1.1);
    Vector3d away;
    for (int k = 0; k < 3; ++k)
      away[k] = gap[k] > 0.0 ? half[k] + other[k] + gap[k] : random.number(-0.4, 0.4);
    const Isometry3d rotation = random.pose(20.0), slid = rotation * Eigen::Translation3d(away);
    const collision::Polyhedron a(robot::Box{Isometry3d::Identity(), half});
    const collision::Polyhedron b(robot::Box{Isometry3d::Identity(), other});
    EXPECT_NEAR(collision::Polyhedron::distance(a, rotation, b, slid), gap.norm(), 1e-5) << n;
    const robot::Prism hexagon{
        {{2, 0}, {1, 1.8}, {-1, 1.8}, {-2, 0}, {-1, -1.8}, {1, -1.8}}, -1, 1};
    const collision::Polyhedron prism(hexagon);
    const Isometry3d above = rotation * Eigen::Translation3d(0.3, 0.2, 2.0 + gap.norm()),
                     beside = rotation * Eigen::Translation3d(0.1, 3.6 + gap.norm(), 0.4);
    for (const Isometry3d& place : {above, beside})
      EXPECT_NEAR(collision::Polyhedron::distance(prism, rotation, prism, place), gap.norm(), 1e-5)
          << n;
  }
}

// The holder, 20 mm round and from 110 mm behind the tip on, is horizontal beside a plate.
TEST(Holder, MeetsAPlateThatReachesUnderIt) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const collision::GrowingPart nothing({}, 1.0, {});
  const auto meets = [&](double plateMm, double tipMm) {
    std::vector<Eigen::Vector2d> plate;
    for (int i = 0; i < 64; ++i)
      plate.emplace_back(plateMm * std::cos(i * base::kPi / 32),
                         plateMm * std::sin(i * base::kPi / 32));
    const robot::Cell cell = robot::loadCell("ur5-fixed", process, plate);
    const collision::CellCollision collision(cell, process);
    Isometry3d work_T_tool = Isometry3d::Identity();
    work_T_tool.linear() =
        geometry::shortestRotation(Vector3d::UnitZ(), -Vector3d::UnitX()).toRotationMatrix();
    work_T_tool.translation() = Vector3d(0, 0, tipMm);
    return collision.holderTouches(work_T_tool, nothing, 0, {2.0, 2.0, 0.0});
  };
  EXPECT_TRUE(meets(130.0, 21.5));
  EXPECT_FALSE(meets(130.0, 22.5)); // clear by more than the margin
  EXPECT_FALSE(meets(100.0, 15.0)); // it begins beyond the plate's edge
  EXPECT_FALSE(meets(130.0, -60.0)) << "beside what is below the plate";
}

// Beads count from the waypoint on at which they are printed.
TEST(Holder, MeetsThePartThatIsPrintedByThen) {
  const process::Process process = process::loadProcess("fdm-1.0");
  plan::ToolPlan plan;
  for (int i = 0; i <= 10; ++i) {
    plan.position.emplace_back(i, 0.0, 100.0);
    plan.direction.push_back(Vector3d::UnitZ());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(0.8f);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back({.first = 0, .count = 11});
  const collision::GrowingPart part(plan, 0.4, {});
  const robot::Cell cell = robot::loadCell("ur5-fixed", process,
                                           std::vector<Eigen::Vector2d>{{-5, -5}, {5, -5}, {0, 5}});
  const collision::CellCollision collision(cell, process);
  Isometry3d work_T_tool = Isometry3d::Identity();
  work_T_tool.linear() =
      geometry::shortestRotation(Vector3d::UnitZ(), -Vector3d::UnitX()).toRotationMatrix();
  work_T_tool.translation() = Vector3d(-150.0, 0.0, 100.0); // 150 mm behind: in the holder
  EXPECT_TRUE(collision.holderTouches(work_T_tool, part, 11, {}));
  EXPECT_FALSE(collision.holderTouches(work_T_tool, part, 0, {}));
}

class CellCollisionTest : public testing::Test {
protected:
  CellCollisionTest()
      : process(process::loadProcess("fdm-1.0")),
        cell(robot::loadCell("ur5-fixed", process, disc(20.0))), collision(cell, process) {}

  static std::vector<Eigen::Vector2d> disc(double radius) {
    std::vector<Eigen::Vector2d> polygon;
    for (int i = 0; i < 32; ++i)
      polygon.emplace_back(radius * std::cos(i * base::kPi / 16),
                           radius * std::sin(i * base::kPi / 16));
    return polygon;
  }
  robot::JointVector randomJoints(test::RandomShapes& random) const {
    robot::JointVector q(cell.dof());
    for (int i = 0; i < cell.dof(); ++i)
      q[i] = random.number(-3.1, 3.1);
    return q;
  }
  // Nozzle at a point of the work frame with direction d.
  static Isometry3d toolAt(const Vector3d& p, const Vector3d& d, double rotation) {
    Isometry3d t = Isometry3d::Identity();
    t.linear() = (geometry::shortestRotation(-Vector3d::UnitZ(), -d) *
                  Eigen::AngleAxisd(base::kPi, Vector3d::UnitX()) *
                  Eigen::AngleAxisd(rotation, Vector3d::UnitZ()))
                     .toRotationMatrix();
    t.translation() = p;
    return t;
  }

  bool collides(const robot::JointVector& q, double marginMm) const {
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    collision::Margins margins;
    margins.bodiesMm = marginMm;
    return collision.bodies(frames, margins).has_value();
  }

  process::Process process;
  robot::Cell cell;
  collision::CellCollision collision;
};

TEST_F(CellCollisionTest, HomeIsClear) {
  EXPECT_FALSE(collides(cell.home(), 2.0));
}

// Points all through every body, and their exact distance to the other body of the pair.
TEST_F(CellCollisionTest, ClearanceAgainstSampledBodies) {
  test::RandomShapes random(22);
  std::vector<std::vector<Vector3d>> points(cell.bodies().size());
  for (std::size_t b = 0; b < cell.bodies().size(); ++b)
    for (const robot::Shape& s : cell.bodies()[b].shapes) {
      const collision::Ball ball =
          collision::boundingBall(collision::place(s, Isometry3d::Identity()));
      for (int tries = 0, found = 0; found < 400 && tries < 400000; ++tries) {
        const Vector3d p = ball.centre + random.point(ball.radius);
        if (collision::signedDistance(s, p) <= 0.0) {
          points[b].push_back(p);
          ++found;
        }
      }
    }
  int free = 0, hit = 0;
  for (int n = 0; n < 60; ++n) {
    const robot::JointVector q = randomJoints(random);
    collision::CellCollision::Frames frames;
    cell.framePoses(q, frames);
    double minimum = 1e9;
    for (const auto& [a, b] : cell.checkedPairs()) {
      const auto &bodyA = cell.bodies()[static_cast<std::size_t>(a)],
                 &bodyB = cell.bodies()[static_cast<std::size_t>(b)];
      if (bodyA.role == robot::BodyRole::Head && bodyB.role == robot::BodyRole::Platform)
        continue;
      const Isometry3d b_T_a = frames[static_cast<std::size_t>(bodyB.frame)].inverse() *
                               frames[static_cast<std::size_t>(bodyA.frame)];
      for (const robot::Shape& s : bodyB.shapes)
        for (const Vector3d& p : points[static_cast<std::size_t>(a)])
          minimum = std::min(minimum, collision::signedDistance(s, b_T_a * p));
    }
    const double clearance = collision.clearance(frames, 500.0);
    EXPECT_LE(clearance, std::max(minimum, 0.0) + 1e-6);
    if (minimum <= 0.0) {
      EXPECT_TRUE(collides(q, 0.0));
      ++hit;
    }
    if (!collides(q, 2.0)) {
      EXPECT_GT(clearance, 2.0);
      EXPECT_LT(minimum - clearance, 80.0); // sparse samples of large bodies
      ++free;
    }
  }
  EXPECT_GT(free, 3);
  EXPECT_GT(hit, 3);
}

// Whichever pair is looked at first, the least is the same; the returned pair, one of the closest,
// is looked at first next time.
TEST_F(CellCollisionTest, ClearanceDoesNotDependOnTheFirstPair) {
  test::RandomShapes random(21);
  int near = 0;
  for (int n = 0; n < 60; ++n) {
    collision::CellCollision::Frames frames;
    cell.framePoses(randomJoints(random), frames);
    const double capMm = n % 2 == 0 ? 500.0 : 20.0;
    const double minimum = collision.clearance(frames, capMm);
    std::set<std::size_t> nearest;
    for (std::size_t first = 0; first <= cell.checkedPairs().size(); ++first) {
      std::size_t pair = first;
      EXPECT_NEAR(collision.clearance(frames, capMm, &pair), minimum, 1e-9) << first;
      if (minimum < capMm)
        nearest.insert(pair);
      else
        EXPECT_EQ(pair, first);
    }
    if (minimum < capMm && minimum > 0.0) {
      EXPECT_LE(nearest.size(), 2u);
      ++near;
    }
  }
  EXPECT_GT(near, 5);
}

TEST_F(CellCollisionTest, HeadAndPlatform) {
  const Vector3d up = Vector3d::UnitZ();
  EXPECT_FALSE(collision.headTouchesPlatform(toolAt({0, 0, 0.8}, up, 0.3), 0.0));
  EXPECT_FALSE(collision.headTouchesPlatform(toolAt({15, 0, -0.3}, up, 0.3), 0.0));
  EXPECT_TRUE(collision.headTouchesPlatform(toolAt({15, 0, -0.5}, up, 0.3), 0.0));
  EXPECT_TRUE(collision.headTouchesPlatform(toolAt({15, 0, 0.5}, up, 0.3), 1.0));
  // Beside the plate nothing is below.
  EXPECT_FALSE(collision.headTouchesPlatform(toolAt({60, 0, -3}, up, 0.3), 0.0));
  // Lying flat one millimetre above the plate's edge, the head's cone (12 mm, 6 mm) cuts it.
  EXPECT_TRUE(collision.headTouchesPlatform(toolAt({10, 0, 1}, Vector3d::UnitX(), 0.0), 0.0));
}

TEST_F(CellCollisionTest, PartAndHead) {
  plan::ToolPlan plan;
  for (int i = 0; i <= 30; ++i)
    addWaypoint(plan, {i - 15.0, 0, 0.8});
  plan.paths.push_back({0, 31});
  const collision::GrowingPart part(plan, 0.2, {});
  const Isometry3d on = toolAt({0, 0, 0.8}, Vector3d::UnitZ(), 0),
                   in = toolAt({0, 0, 0.0}, Vector3d::UnitZ(), 0);
  EXPECT_FALSE(collision.headTouchesPart(on, part, 31, 0.0));
  EXPECT_TRUE(collision.headTouchesPart(in, part, 31, 0.0));
  EXPECT_FALSE(collision.headTouchesPart(in, part, 8, 0.0)); // not yet printed there
  EXPECT_TRUE(collision.headTouchesPart(on, part, 31, 0.7));
}

// A bead right through each body in turn, at any place in the list.
TEST_F(CellCollisionTest, PartAndEveryBody) {
  collision::CellCollision::Frames frames;
  cell.framePoses(cell.home(), frames);
  const Isometry3d work_T_base = frames[static_cast<std::size_t>(cell.workFrame())].inverse();
  int tried = 0;
  for (const int b : cell.bodiesAgainstPart()) {
    const robot::Body& body = cell.bodies()[static_cast<std::size_t>(b)];
    if (body.role == robot::BodyRole::Head)
      continue;
    for (const robot::Shape& shape : body.shapes) {
      const collision::Ball ball =
          collision::boundingBall(collision::place(shape, Isometry3d::Identity()));
      if (collision::signedDistance(shape, ball.centre) > 0.0)
        continue;
      plan::ToolPlan plan;
      for (const double x : {-0.5, 0.0, 0.5})
        addWaypoint(plan, work_T_base * frames[static_cast<std::size_t>(body.frame)] * ball.centre +
                              Vector3d(x, 0, 0.4));
      plan.paths.push_back({0, 3});
      const collision::GrowingPart part(plan, 0.2, {});
      EXPECT_TRUE(collision.bodiesAndPart(frames, part, 3, {})) << b;
      EXPECT_FALSE(collision.bodiesAndPart(frames, part, 0, {})) << b; // not yet printed
      ++tried;
    }
  }
  EXPECT_GT(tried, 3);
}
