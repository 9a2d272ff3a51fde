// The ladder over one path: places of its rungs, costs of its ways, and their starts.
#include "collision/growing_part.h"
#include "motion/ladder/path_ladder.h"
#include "motion/motion_options.h"

#include "base/run_context.h"
#include "base/units.h"
#include "motion/ladder/joint_costs.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "motion/sequence.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <utility>

using namespace voluta;
using Eigen::Vector3d;
using motion::LadderNode;
using motion::LadderPath;
using motion::PathLadder;
using robot::JointVector;

namespace {

struct Scene {
  plan::ToolPlan plan;
  process::Process process = process::loadProcess("fdm-1.0");
  robot::Cell cell;
  collision::CellCollision collision{cell, process};
  collision::GrowingPart part;
  motion::MotionOptions options;
  motion::MotionScene scene{plan, cell, collision, part, options};
  motion::PathTimes times;

  explicit Scene(plan::ToolPlan p, const std::string& id = "ur5-fixed")
      : plan(std::move(p)), cell(robot::loadCell(id, process, plate())), part(plan, 1.0, {}) {}
  static platform::PlatformSolid plate() {
    platform::PlatformSolid solid;
    solid.polygon = test::disc(40.0);
    return solid;
  }
  motion::RobotState state(const JointVector& q) const { return motion::stateAt(cell, q); }
  PathLadder ladder(const JointVector& from) {
    return {scene, 0, plan.waypointCount(), state(from), {}, times};
  }
};

// Steps along a line of uneven lengths; the nozzle leans more and more behind its middle.
plan::ToolPlan unevenLine() {
  plan::ToolPlan plan;
  std::vector<Vector3d> points, directions;
  double x = -20.0, lean = 0.0;
  for (int i = 0; i < 70; ++i) {
    x += i == 30 ? 8.0 : 0.3 + 0.02 * (i % 7); // one step longer than rungs are apart
    lean += i > 45 ? 0.06 : 0.0;
    points.emplace_back(x, 5.0, 30.0);
    directions.emplace_back(0.0, std::sin(lean), std::cos(lean));
  }
  test::appendPath(plan, points, directions, 0);
  return plan;
}

// A quarter of a ring.
plan::ToolPlan quarterRing(double radius) {
  plan::ToolPlan plan;
  std::vector<Vector3d> points;
  for (int i = 0; i <= 40; ++i) {
    const double a = 0.5 * base::kPi * i / 40;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), 20.0);
  }
  test::appendPath(plan, points, std::vector<Vector3d>(points.size(), Vector3d::UnitZ()), 0);
  return plan;
}

double pathLength(const plan::ToolPlan& plan, std::size_t from, std::size_t to) {
  double length = 0.0;
  for (std::size_t i = from + 1; i <= to; ++i)
    length += (plan.position[i] - plan.position[i - 1]).norm();
  return length;
}
double angleBetweenFrames(const plan::ToolPlan& plan, std::size_t from, std::size_t to) {
  double rotation = 0.0;
  for (std::size_t i = from + 1; i <= to; ++i)
    rotation += std::acos(std::min(1.0, plan.direction[i].dot(plan.direction[i - 1])));
  return rotation;
}

// Of the arm's joints, as the way was taken.
double costOf(const Scene& s, PathLadder& ladder, const LadderPath& path, const JointVector& from) {
  double cost = motion::startCost(from, path.q.front(), s.cell.robot().limits);
  for (std::size_t r = 0; r < path.reached; ++r) {
    cost += ladder.node(r, path.node[r]).cost;
    if (r > 0)
      cost += (path.q[r] - path.q[r - 1]).head(s.cell.armDof()).cwiseAbs().sum();
  }
  return cost;
}

} // namespace

TEST(PathLadder, RungsAreAsFarApartAsTheyMayBe) {
  Scene s(unevenLine());
  PathLadder ladder = s.ladder(s.cell.home());
  ASSERT_EQ(ladder.followed(), 70u);
  for (const std::size_t count : {70u, 33u, 2u, 1u}) {
    ladder.setRungs(count, {});
    EXPECT_EQ(ladder.waypointOf(0), 0u);
    EXPECT_EQ(ladder.waypointOf(ladder.size() - 1), count - 1);
    for (std::size_t r = 1; r < ladder.size(); ++r) {
      const std::size_t a = ladder.waypointOf(r - 1), b = ladder.waypointOf(r);
      ASSERT_LT(a, b);
      if (b > a + 1) {
        EXPECT_LE(pathLength(s.plan, a, b), s.options.rungMm + 1e-9);
        EXPECT_LE(angleBetweenFrames(s.plan, a, b), s.options.rungRotationRad + 1e-9);
      }
      if (r + 1 < ladder.size()) {
        EXPECT_TRUE(pathLength(s.plan, a, b + 1) > s.options.rungMm ||
                    angleBetweenFrames(s.plan, a, b + 1) > s.options.rungRotationRad)
            << "could be further on";
      }
    }
    for (std::size_t w = 0; w < count; ++w) {
      const std::size_t r = ladder.rungAt(w);
      EXPECT_GE(ladder.waypointOf(r), w);
      if (r > 0) {
        EXPECT_LT(ladder.waypointOf(r - 1), w);
      }
    }
  }
}

TEST(PathLadder, RefiningMakesRungsOfAllWaypointsBetweenTwo) {
  Scene s(unevenLine());
  PathLadder ladder = s.ladder(s.cell.home());
  ladder.setRungs(30, {});
  const std::size_t a = ladder.waypointOf(1), b = ladder.waypointOf(2), size = ladder.size();
  ASSERT_GT(b, a + 1);
  EXPECT_TRUE(ladder.refine(2, {}));
  EXPECT_EQ(ladder.size(), size + b - a - 1);
  for (std::size_t w = a; w <= b; ++w)
    EXPECT_EQ(ladder.waypointOf(1 + w - a), w);
  EXPECT_FALSE(ladder.refine(2, {})) << "neighbours already";
  ladder.keepUpTo(2, {});
  EXPECT_EQ(ladder.size(), 3u);
  EXPECT_EQ(ladder.waypointOf(2), a + 1);
}

TEST(PathLadder, AWayCostsItsStartItsNodesAndItsSteps) {
  for (const char* id : {"ur5-fixed", "irb1200-moving"}) {
    Scene s(quarterRing(15.0), id);
    const JointVector from = s.cell.home();
    PathLadder ladder = s.ladder(from);
    ladder.setRungs(s.plan.waypointCount(), {});
    const LadderPath path = ladder.bestPath({});
    ASSERT_EQ(path.reached, ladder.size()) << id;
    EXPECT_NEAR(path.cost, costOf(s, ladder, path, from), 1e-9);
    for (std::size_t r = 0; r < path.reached; ++r) {
      const LadderNode& node = ladder.node(r, path.node[r]);
      EXPECT_NEAR(node.cost, motion::limitCost(node.q, s.cell.robot().limits), 1e-12);
      // It is there, turned about the nozzle as in its sample.
      const Eigen::Isometry3d pose = s.cell.work_T_tool(path.q[r]);
      const std::size_t w = ladder.waypointOf(r);
      EXPECT_LT((pose.translation() - s.plan.position[w]).norm(), 1e-6);
      const Eigen::Quaterniond wanted =
          motion::turned(ladder.toolAt(w), base::kTwoPi * node.sample / s.options.samples);
      EXPECT_LT(motion::angleBetween(Eigen::Quaterniond(pose.linear()), wanted), 1e-6);
    }
  }
}

// Between rungs turns change evenly with the way along the path, the short way round.
TEST(PathLadder, ACourseIsLinearBetweenItsRungs) {
  Scene s(unevenLine());
  PathLadder ladder = s.ladder(s.cell.home());
  ladder.setRungs(30, {});
  LadderPath path = ladder.bestPath({});
  ASSERT_EQ(path.reached, ladder.size());
  const int samples = s.options.samples;
  // Any samples: on, back, and over the full circle both ways.
  const int wanted[] = {1, 3, 2, samples - 1, 1, 0, samples - 2, samples - 2, 4, 9};
  for (std::size_t r = 0; r < path.reached; ++r)
    ladder.node(r, path.node[r]).sample = wanted[r % 10];
  const motion::Course course = ladder.courseOf(path);
  ASSERT_EQ(course.rotation.size(), 30u);
  ASSERT_EQ(course.offset, std::vector<double>(30, 0.0));
  double rotation = base::kTwoPi * wanted[0] / samples;
  EXPECT_NEAR(course.rotation[0], rotation, 1e-12);
  for (std::size_t r = 1; r < path.reached; ++r) {
    const double step = base::kTwoPi / samples * (wanted[r % 10] - wanted[(r - 1) % 10]);
    const double change = std::remainder(step, base::kTwoPi);
    const std::size_t a = ladder.waypointOf(r - 1), b = ladder.waypointOf(r);
    for (std::size_t w = a; w <= b; ++w)
      EXPECT_NEAR(course.rotation[w],
                  rotation + change * pathLength(s.plan, a, w) / pathLength(s.plan, a, b), 1e-9);
    rotation += change;
  }
}

// Joint 6 is a turn further than at home: short ways begin from there. Only where it would stay
// near its limit is it turned back, once, before the path begins.
TEST(PathLadder, AnArmUnwindsOnlyWhereThatIsCheaper) {
  Scene s(quarterRing(8.0));
  const robot::JointLimits& limit = s.cell.limits()[5];
  const auto firstFrom = [&](double joint6) {
    JointVector q = s.cell.home();
    q[5] = joint6;
    PathLadder ladder = s.ladder(q);
    ladder.setRungs(s.plan.waypointCount(), {});
    const LadderPath path = ladder.bestPath({});
    EXPECT_EQ(path.reached, ladder.size());
    EXPECT_NEAR(path.cost, costOf(s, ladder, path, q), 1e-9);
    return path.q.front()[5];
  };
  const double home = s.cell.home()[5];
  EXPECT_LT(std::abs(firstFrom(home) - home), base::kPi);
  for (const double wound : {-0.62 * base::kTwoPi, 0.7 * base::kTwoPi}) {
    ASSERT_GT(wound, limit.min);
    ASSERT_LT(wound, limit.max);
    EXPECT_LT(std::abs(firstFrom(wound) - wound), 0.5 * base::kPi) << wound;
  }
}

// The first waypoint a little over the plate: of some nodes the arm meets something there, or as
// soon as it lifts the nozzle.
TEST(PathLadder, NodesThatMeetSomethingOrCannotLiftAreBlocked) {
  plan::ToolPlan plan = quarterRing(30.0);
  for (Vector3d& p : plan.position)
    p.z() = 0.8;
  for (Vector3d& d : plan.direction)
    d = Vector3d(0.5, 0.0, 0.9).normalized();
  Scene s(plan);
  const JointVector from = s.cell.home();
  // As many nodes as there are solutions for all turns.
  std::vector<JointVector> solutions;
  const auto countOf = [&](const PathLadder& ladder) {
    int count = 0;
    for (int k = 0; k < s.options.samples; ++k) {
      s.cell.inverse(
          motion::toolPose(s.plan.position[0],
                           motion::turned(ladder.toolAt(0), base::kTwoPi * k / s.options.samples)),
          from, solutions);
      count += static_cast<int>(solutions.size());
    }
    return count;
  };
  PathLadder judged = s.ladder(from), lifted = s.ladder(from);
  judged.setRungs(2, {});
  lifted.setRungs(2, {});
  const int count = countOf(judged);
  ASSERT_GT(count, 24);
  judged.judge({0}, {});
  EXPECT_FALSE(lifted.wasLifted(0));
  lifted.blockUnliftable(0, 0, {});
  EXPECT_TRUE(lifted.wasLifted(0));
  std::map<std::pair<int, int>, int> contacts;
  int met = 0;
  for (int n = 0; n < count; ++n) {
    const LadderNode& node = judged.node(0, n);
    const auto contact = judged.contactAt(node.q, 0);
    EXPECT_EQ(node.blocked, contact.has_value());
    if (contact)
      ++contacts[{contact->first, contact->second}];
    met += contact ? 1 : 0;
    // As the joints have the tool.
    const bool free = !contact && judged.liftable(s.state(node.q), 0);
    EXPECT_EQ(lifted.node(0, n).blocked, !free);
  }
  EXPECT_GT(met, 0);
  EXPECT_LT(met, count);
  // The reason given is the one that most nodes have.
  const motion::Refused refused = judged.refusalOf(0);
  EXPECT_EQ(refused.waypoint, 0u);
  EXPECT_EQ(refused.why, motion::Refusal::Collision);
  int maximum = 0;
  for (const auto& [pair, times] : contacts)
    maximum = std::max(maximum, times);
  EXPECT_EQ((contacts[{refused.contact.first, refused.contact.second}]), maximum);
  EXPECT_GT(contacts.size(), 1u);
  // All that was blocked for that may be allowed again, once.
  EXPECT_TRUE(lifted.allowUnliftable());
  EXPECT_FALSE(lifted.allowUnliftable());
  for (int n = 0; n < count; ++n)
    EXPECT_FALSE(lifted.node(0, n).blocked);
}

// Where the way comes near to a body, nearer poses cost more: at most nearCost, and nothing from
// enoughMm on.
TEST(PathLadder, NearnessCostsTheMoreTheNearer) {
  Scene s(quarterRing(30.0));
  s.options.enoughMm = 60.0;
  s.options.nearCost = 0.7;
  PathLadder ladder = s.ladder(s.cell.home());
  ladder.setRungs(2, {});
  const LadderPath path = ladder.bestPath({});
  ASSERT_EQ(path.reached, 2u);
  ladder.judge({0, 1}, {});
  ASSERT_TRUE(ladder.seekClearance(path, {}));
  EXPECT_FALSE(ladder.seekClearance(path, {})) << "known by now";
  std::vector<std::pair<double, double>> nearness; // clearance, cost
  collision::CellCollision::Frames frames;
  for (int n = 0; n < 24; ++n) {
    const LadderNode& node = ladder.node(0, n);
    if (node.blocked)
      continue;
    s.cell.framePoses(node.q, frames);
    const double clearance = s.collision.clearanceToPart(
        frames, s.part, 0, s.collision.clearance(frames, s.options.enoughMm));
    nearness.emplace_back(clearance, node.cost - motion::limitCost(node.q, s.cell.robot().limits));
  }
  std::sort(nearness.begin(), nearness.end());
  ASSERT_GT(nearness.size(), 3u);
  EXPECT_LT(nearness.front().first, 0.5 * s.options.enoughMm);
  for (std::size_t n = 0; n < nearness.size(); ++n) {
    const auto [clearance, cost] = nearness[n];
    EXPECT_GE(cost, -1e-12);
    EXPECT_LE(cost, s.options.nearCost + 1e-12);
    EXPECT_EQ(cost > 1e-12, clearance < s.options.enoughMm);
    if (n > 0 && clearance > nearness[n - 1].first + 1e-9) {
      EXPECT_LT(cost, nearness[n - 1].second);
    }
  }
  // No such cost by default.
  s.options.nearCost = 0.0;
  PathLadder other = s.ladder(s.cell.home());
  other.setRungs(2, {});
  EXPECT_FALSE(other.seekClearance(other.bestPath({}), {}));
}

TEST(PathLadder, WideningAddsNodesOfTheLastAxisAtACost) {
  Scene s(quarterRing(15.0), "irb1200-irbp");
  PathLadder ladder = s.ladder(s.cell.home());
  ASSERT_TRUE(ladder.movesPart());
  ladder.setRungs(ladder.followed(), {});
  ASSERT_GT(ladder.size(), 2u);
  const LadderPath before = ladder.bestPath({});
  ASSERT_GT(before.reached, 0u);
  EXPECT_TRUE(ladder.widen(1, {}));
  EXPECT_FALSE(ladder.widen(1, {})) << "they are there";
  const LadderPath after = ladder.bestPath({});
  EXPECT_GE(after.reached, before.reached);
  if (after.reached == before.reached) {
    EXPECT_LE(after.cost, before.cost + 1e-9) << "more nodes make no way dearer";
  }
  for (std::size_t r = 0; r < after.reached; ++r) {
    const LadderNode& node = ladder.node(r, after.node[r]);
    const double extra = node.cost - motion::limitCost(node.q, s.cell.robot().limits);
    if (node.offset == 0) {
      EXPECT_NEAR(extra, 0.0, 1e-12);
    } else {
      EXPECT_GT(extra, 0.0);
    }
    const JointVector axes = ladder.axesAt(ladder.waypointOf(r), node.offset * base::kPi / 12);
    EXPECT_LT((node.q.tail(axes.size()) - axes).norm(), 1e-9);
  }
}
