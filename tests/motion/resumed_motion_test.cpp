// A resumed motion: its start, and the part that stays as it was.
#include "collision/growing_part.h"
#include "motion/motion_options.h"
#include "motion/resumed_motion.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include "base/error.h"
#include "base/run_context.h"
#include "collision/cell_collision.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;
using plan::MoveKind;
using robot::JointVector;

namespace {

constexpr std::size_t kNone = plan::kNoWaypoint;

// Two beads and a wipe by hand: J L w0 P(divided) w1 P w2 W L L w3 P w4 L.
plan::Trajectory resolved() {
  plan::Trajectory t;
  t.dof = 2;
  const auto add = [&](MoveKind move, std::size_t waypoint) {
    const auto i = static_cast<double>(t.pointCount());
    t.joints.insert(t.joints.end(), {i, -i});
    t.extrudedMm3.push_back((t.extrudedMm3.empty() ? 0.0 : t.extrudedMm3.back()) +
                            (move == MoveKind::Print ? 1.0 + i : 0.0));
    t.timeS.push_back(0.5 * i * i);
    t.move.push_back(move);
    t.waypoint.push_back(waypoint);
  };
  add(MoveKind::Joint, kNone);  // 0
  add(MoveKind::Linear, 0);     // 1
  add(MoveKind::Print, kNone);  // 2
  add(MoveKind::Print, 1);      // 3
  add(MoveKind::Print, 2);      // 4
  add(MoveKind::Wipe, kNone);   // 5
  add(MoveKind::Linear, kNone); // 6
  add(MoveKind::Linear, 3);     // 7
  add(MoveKind::Print, 4);      // 8
  add(MoveKind::Linear, kNone); // 9
  return t;
}

plan::ToolPlan twoPaths() {
  plan::ToolPlan plan;
  const std::vector<Vector3d> up(3, Vector3d::UnitZ());
  test::appendPath(plan, {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}, up, 0);
  test::appendPath(plan, {{0, 5, 1}, {1, 5, 1}}, {up[0], up[0]}, 0);
  return plan;
}

class ResumeMotion : public testing::Test {
protected:
  plan::ToolPlan plan_ = test::slab(12.0, 2);
  process::Process process_ = process::loadProcess("fdm-1.0");
  robot::Cell cell_ = robot::loadCell("ur5-fixed", process_, test::disc(20.0));
  collision::GrowingPart part_{plan_, 0.45, {}};
  motion::MotionOptions options_;
  plan::Trajectory t_ =
      motion::MotionPlanner(plan_, cell_, process::Tooling(process_), part_, options_)
          .plan({})
          .trajectory;

  static JointVector at(const plan::Trajectory& t, std::size_t i) {
    return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
  }
  Vector3d tip(const plan::Trajectory& t, std::size_t i) const {
    return cell_.work_T_tool(at(t, i)).translation();
  }
  std::size_t pointOf(std::size_t waypoint) const {
    for (std::size_t i = 0; i + 1 < t_.pointCount(); ++i)
      if (t_.waypoint[i] == waypoint && t_.move[i + 1] == MoveKind::Print)
        return i;
    ADD_FAILURE();
    return 0;
  }
  // A run's end: the last of the points printed without a stop.
  std::size_t endOfRun(std::size_t point) const {
    while (point + 1 < t_.pointCount() && t_.move[point + 1] == MoveKind::Print)
      ++point;
    return point;
  }
  motion::Resumed resumed(std::size_t point) const {
    const auto found = motion::resumeAt(t_, point, plan_, cell_, process::Tooling(process_), part_,
                                        options_, 0, {});
    EXPECT_TRUE(found);
    return found.value_or(motion::Resumed{});
  }
};

} // namespace

TEST(ResumePoint, IsAWaypointFromWhichPrintingCanContinue) {
  const plan::Trajectory t = resolved();
  const std::size_t wanted[] = {1, 1, 1, 3, 7, 7, 7, 7};
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(motion::resumePoint(t, i), wanted[i]) << i;
  EXPECT_FALSE(motion::resumePoint(t, 8));
  EXPECT_FALSE(motion::resumePoint(t, 9));
  EXPECT_FALSE(motion::resumePoint(t, 100));
}

TEST(ResumePoint, OfABeadIsItsBeginning) {
  const plan::Trajectory t = resolved();
  const std::size_t wanted[] = {1, 1, 1, 1, 7, 7, 7, 7};
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(motion::resumePointOfBead(t, i), wanted[i]) << i;
  EXPECT_FALSE(motion::resumePointOfBead(t, 8));
}

TEST(ResumePoint, OfAPathIsWhereItsFirstPrintedBeadBegins) {
  const plan::ToolPlan plan = twoPaths();
  plan::Trajectory t = resolved();
  EXPECT_EQ(motion::resumePointOfPath(t, plan, 0), 1u);
  EXPECT_EQ(motion::resumePointOfPath(t, plan, 1), 7u);
  EXPECT_THROW(motion::resumePointOfPath(t, plan, 2), base::Error);
  t.move[8] = MoveKind::Linear; // the second path is not printed
  EXPECT_EQ(motion::resumePointOfPath(t, plan, 0), 1u);
  EXPECT_FALSE(motion::resumePointOfPath(t, plan, 1));
  t.move[2] = t.move[3] = MoveKind::Linear; // of the first only its last piece
  EXPECT_EQ(motion::resumePointOfPath(t, plan, 0), 3u);
}

TEST(PartOf, CountsTimeAndMaterialFromItsOwnStart) {
  const plan::Trajectory t = resolved();
  for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>(0, 10), {3, 9}, {4, 5}}) {
    const plan::Trajectory part = motion::partOf(t, first, last);
    ASSERT_EQ(part.pointCount(), last - first);
    EXPECT_EQ(part.dof, 2);
    EXPECT_EQ(part.joints.size(), 2 * (last - first));
    for (std::size_t i = 0; i < part.pointCount(); ++i) {
      EXPECT_EQ(part.at(i)[0], t.at(first + i)[0]);
      EXPECT_EQ(part.at(i)[1], t.at(first + i)[1]);
      EXPECT_EQ(part.move[i], i == 0 ? MoveKind::Joint : t.move[first + i]);
      EXPECT_EQ(part.waypoint[i], t.waypoint[first + i]);
      EXPECT_NEAR(part.timeS[i], t.timeS[first + i] - t.timeS[first], 1e-12);
      EXPECT_NEAR(part.extrudedMm3[i], t.extrudedMm3[first + i] - t.extrudedMm3[first], 1e-12);
    }
  }
  EXPECT_THROW(motion::partOf(t, 4, 4), base::Error);
  EXPECT_THROW(motion::partOf(t, 4, 11), base::Error);
}

// At a bead's start, within a bead, and right before its end.
TEST_F(ResumeMotion, TheRestIsAsItWasPlanned) {
  const std::size_t second = plan_.paths[1].first;
  for (const std::size_t waypoint : {second, second + 40, std::size_t{5}, second - 2}) {
    SCOPED_TRACE(waypoint);
    const std::size_t point = pointOf(waypoint);
    const motion::Resumed r = resumed(point);
    const plan::Trajectory& all = r.trajectory;
    ASSERT_GT(r.firstPoint, point + 1);
    const std::size_t left = t_.pointCount() - point; // from the place on
    ASSERT_GT(all.pointCount(), r.firstPoint + left);
    const std::size_t begin = all.pointCount() - left; // where the place is come to again
    EXPECT_EQ(all.joints.size(), all.pointCount() * 6);

    for (std::size_t i = 0; i <= point; ++i) {
      EXPECT_EQ(at(all, i), at(t_, i));
      EXPECT_EQ(all.timeS[i], t_.timeS[i]);
      EXPECT_EQ(all.move[i], t_.move[i]);
      EXPECT_EQ(all.extrudedMm3[i], t_.extrudedMm3[i]);
    }
    // Home, then the way to the rest of the path, without deposition.
    EXPECT_LT((at(all, r.firstPoint) - cell_.home()).norm(), 1e-12);
    EXPECT_EQ(at(all, r.firstPoint - 1), at(all, r.firstPoint));
    EXPECT_EQ(all.timeS[r.firstPoint - 1], all.timeS[r.firstPoint]);
    EXPECT_EQ(all.move[r.firstPoint], MoveKind::Joint);
    EXPECT_EQ(begin - r.firstPoint, r.firstPoint - 1 - point);
    for (std::size_t k = 0; point + k < r.firstPoint; ++k) {
      EXPECT_EQ(at(all, point + k), at(all, begin - k));
      EXPECT_EQ(all.waypoint[begin - k], k == 0 ? waypoint : kNone);
      EXPECT_EQ(all.waypoint[point + k], k == 0 ? waypoint : kNone);
      EXPECT_EQ(all.extrudedMm3[begin - k], t_.extrudedMm3[point]);
      EXPECT_EQ(all.extrudedMm3[point + k], t_.extrudedMm3[point]);
      EXPECT_NE(all.move[begin - k], MoveKind::Print);
      if (k > 0) {
        EXPECT_EQ(all.move[point + k], all.move[begin - k + 1]);
      }
    }
    for (std::size_t i = 1; i < left; ++i) {
      EXPECT_EQ(at(all, begin + i), at(t_, point + i));
      EXPECT_EQ(all.move[begin + i], t_.move[point + i]);
      EXPECT_EQ(all.waypoint[begin + i], t_.waypoint[point + i]);
      EXPECT_EQ(all.extrudedMm3[begin + i], t_.extrudedMm3[point + i]);
    }
    for (std::size_t i = 1; i < all.pointCount(); ++i)
      if (i != r.firstPoint) {
        EXPECT_GT(all.timeS[i], all.timeS[i - 1]) << i;
      }
    // Times change only in the run that is cut.
    const std::size_t end = t_.move[point] == MoveKind::Print ? endOfRun(point) : point;
    for (std::size_t i = end + 1; i < t_.pointCount(); ++i)
      EXPECT_NEAR(all.timeS[begin + i - point] - all.timeS[begin + i - point - 1],
                  t_.timeS[i] - t_.timeS[i - 1], 1e-9)
          << i;
  }
}

// In the middle of a straight line, at speed in the first plan: from rest it takes longer by the
// ramp to that speed, and is no faster than before.
TEST_F(ResumeMotion, TheRunThatIsCutBeginsFromRest) {
  const std::size_t point = pointOf(plan_.paths[1].first + 19); // 12 mm lines of 1 mm steps
  ASSERT_EQ(t_.move[point], MoveKind::Print);
  const motion::Resumed r = resumed(point);
  const plan::Trajectory& all = r.trajectory;
  const std::size_t begin = all.pointCount() - (t_.pointCount() - point), end = endOfRun(point);
  const double speed = 20.0, acceleration = process_.accelerationMmPerS2;
  double distance = 0.0;
  for (std::size_t i = point + 1; i <= end; ++i) {
    const std::size_t k = begin + i - point;
    const double step = (tip(all, k) - tip(all, k - 1)).norm();
    distance += step;
    const double time = all.timeS[k] - all.timeS[begin];
    EXPECT_LE(step / (all.timeS[k] - all.timeS[k - 1]), speed + 1e-6);
    EXPECT_LE(distance, 0.5 * acceleration * time * time + 1e-6);
    for (int j = 0; j < 6; ++j)
      EXPECT_LE(std::abs(at(all, k)[j] - at(all, k - 1)[j]),
                cell_.limits()[static_cast<std::size_t>(j)].velocity *
                        (all.timeS[k] - all.timeS[k - 1]) +
                    1e-9);
  }
  const double later =
      (all.timeS[begin + end - point] - all.timeS[begin]) - (t_.timeS[end] - t_.timeS[point]);
  EXPECT_NEAR(later, 0.5 * speed / acceleration, 1e-3);
}

// The way there and back is clear of the cell and of the beads printed by then.
TEST_F(ResumeMotion, TheWayThereIsClear) {
  const collision::CellCollision collision(cell_, process_);
  const std::size_t waypoint = plan_.paths[1].first + 30, point = pointOf(waypoint);
  const motion::Resumed r = resumed(point);
  const std::size_t begin = r.trajectory.pointCount() - (t_.pointCount() - point);
  collision::CellCollision::Frames frames;
  for (std::size_t i = point + 1; i <= begin; ++i) {
    const JointVector a = at(r.trajectory, i - 1), b = at(r.trajectory, i);
    const int pieces = std::max(1, static_cast<int>((b - a).cwiseAbs().maxCoeff() / 0.01));
    for (int k = 0; k < pieces; ++k) {
      cell_.framePoses(a + (k + 0.5) / pieces * (b - a), frames);
      EXPECT_FALSE(collision.bodies(frames, {0.0, 0.0, -0.1})) << i;
      EXPECT_FALSE(collision.bodiesAndPart(frames, part_, waypoint, {0.0, 0.0, 0.0})) << i;
    }
  }
}

// Whatever the print has switched on by then is on before the rest moves, all others are off.
TEST_F(ResumeMotion, OutputsAreSetAgain) {
  const auto set = [](std::size_t point, int output, bool on) {
    return plan::TrajectoryEvent{
        .point = point, .kind = plan::EventKind::Output, .tool = output, .on = on};
  };
  const std::size_t point = pointOf(plan_.paths[1].first + 19);
  t_.events = {set(2, 3, true), set(3, 4, true), set(4, 4, false), set(point + 1, 5, true)};
  const motion::Resumed r = resumed(point);
  std::vector<plan::TrajectoryEvent> own;
  for (const plan::TrajectoryEvent& event :
       motion::partOf(r.trajectory, r.firstPoint, r.trajectory.pointCount()).events)
    if (event.kind == plan::EventKind::Output)
      own.push_back(event);
  ASSERT_EQ(own.size(), 4u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(own[k].point, 0u) << "before the first motion";
    EXPECT_EQ(own[k].tool, 3 + static_cast<int>(k));
    EXPECT_EQ(own[k].on, k == 0);
  }
  EXPECT_EQ(own[3].tool, 5);
  EXPECT_TRUE(own[3].on);
  EXPECT_GT(own[3].point, 0u);
}

// Nobody knows whether the print stopped before or behind them.
TEST_F(ResumeMotion, EventsBeforeTheFirstBeadOfTheRestComeAgain) {
  using enum plan::EventKind;
  const std::size_t point = pointOf(plan_.paths[1].first);
  std::size_t printed = point;
  while (t_.move[printed] != MoveKind::Print)
    --printed;
  t_.events = {{.point = printed, .kind = Wait, .seconds = 7.0}, // before the last bead's end
               {.point = printed + 1, .kind = Output, .tool = 3, .on = true},
               {.point = printed + 1, .kind = Pause, .text = "Put in the nut"},
               {.point = printed + 1, .kind = Wait, .seconds = 60.0},
               {.point = printed + 1, .kind = Statement, .text = "own()", .format = "urscript"},
               {.point = printed + 1, .kind = Output, .tool = 3, .on = false}};
  const auto eventsOf = [](const motion::Resumed& r) {
    return motion::partOf(r.trajectory, r.firstPoint, r.trajectory.pointCount()).events;
  };
  const std::vector<plan::TrajectoryEvent> rest = eventsOf(resumed(point));
  const plan::EventKind wanted[] = {Output, Output, Pause, Wait, Output, Purge};
  ASSERT_EQ(rest.size(), std::size(wanted));
  for (std::size_t k = 0; k < rest.size(); ++k) {
    EXPECT_EQ(rest[k].kind, wanted[k]) << k;
    EXPECT_EQ(rest[k].point == 0, k == 0) << "the state of the output, before the first motion";
  }
  EXPECT_EQ(rest[2].text, "Put in the nut");
  EXPECT_DOUBLE_EQ(rest[3].seconds, 60.0);
  EXPECT_EQ(rest[1].point, rest[4].point);
  // Where the bead goes on, they have been.
  for (const plan::TrajectoryEvent& event : eventsOf(resumed(pointOf(plan_.paths[1].first + 3))))
    EXPECT_TRUE(event.kind != Pause && event.kind != Wait);
}
