// Motions slowed to a limit of the jerk.
#include "collision/growing_part.h"
#include "motion/jerk_limit.h"
#include "motion/motion_options.h"
#include "platform/platform_solid.h"
#include "process/process.h"
#include "process/tooling.h"
#include "robot/cell.h"

#include "base/error.h"
#include "base/run_context.h"
#include "motion/jerk.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using robot::JointVector;

namespace {

double greatest(const std::vector<JointVector>& q, const std::vector<double>& times) {
  const motion::JerkMeasure jerk = motion::jerkOf(q, times);
  return *std::max_element(jerk.maxAbs.begin(), jerk.maxAbs.end());
}

struct Path {
  std::vector<JointVector> q;
  std::vector<double> times;
};

// Two joints along waves with corners, at uneven times.
Path randomPath(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Path path;
  JointVector q = JointVector::Zero(2), rate = JointVector::Zero(2);
  const std::size_t count = 2 + static_cast<std::size_t>(120.0 * unit(random));
  for (std::size_t i = 0; i < count; ++i) {
    if (unit(random) < 0.1)
      rate = Eigen::Vector2d(unit(random) - 0.5, unit(random) - 0.5);
    path.q.push_back(q);
    path.times.push_back(i == 0 ? 0.0 : path.times.back() + 0.02 + 0.04 * unit(random));
    q += 0.04 * rate;
  }
  return path;
}

double shareOfLongest(const Path& path, const std::vector<double>& times) {
  double maximum = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i)
    maximum = std::max(maximum, (times[i] - times[i - 1]) / (path.times[i] - path.times[i - 1]));
  return maximum;
}

} // namespace

// From 0 to 2 within T: a jerk of 8 * 2 / T^3 (Jerk.OfOneStepFromRestToRest), so 2 s for a limit
// of 2.
TEST(JerkLimit, OfOneStepIsKnown) {
  const std::vector<JointVector> q{JointVector::Zero(1), JointVector::Constant(1, 2.0)};
  const std::vector<double> times = motion::timesWithinJerk(q, {0.0, 1.0}, {}, 2.0);
  EXPECT_NEAR(times.back(), 2.0, 0.02);
  EXPECT_GE(times.back(), 2.0);
}

TEST(JerkLimit, IsKeptByRandomPaths) {
  int kept = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    const Path path = randomPath(seed);
    for (const double limit : {2000.0, 100.0, 5.0}) {
      const std::vector<double> times = motion::timesWithinJerk(path.q, path.times, {}, limit);
      ASSERT_EQ(times.size(), path.times.size());
      for (std::size_t i = 1; i < times.size(); ++i)
        ASSERT_GE(times[i] - times[i - 1], path.times[i] - path.times[i - 1] - 1e-9) << seed;
      if (shareOfLongest(path, times) < motion::kMaxSlowdown - 1e-6) {
        EXPECT_LE(greatest(path.q, times), limit * 1.0001) << seed << " " << limit;
        ++kept;
      }
      EXPECT_LE(greatest(path.q, times), greatest(path.q, path.times) * 1.0001) << seed;
    }
  }
  EXPECT_GT(kept, 300) << "most are not so slow that the limit is given up";
}

TEST(JerkLimit, ChangesNothingThatKeepsIt) {
  const Path path = randomPath(3);
  const double own = greatest(path.q, path.times);
  const std::vector<double> times = motion::timesWithinJerk(path.q, path.times, {}, 1.01 * own);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], path.times[i], 1e-12);
}

// A joint at 1 rad/s from rest to rest: each ramp takes at least 2 sqrt(1 / jerk) s and adds half
// of that.
TEST(JerkLimit, RampsAreNotMuchLongerThanTheyMustBe) {
  Path path;
  for (int i = 0; i <= 400; ++i) {
    path.q.push_back(JointVector::Constant(1, 0.01 * i));
    path.times.push_back(0.01 * i);
  }
  for (const double limit : {10.0, 1.0}) {
    const std::vector<double> times = motion::timesWithinJerk(path.q, path.times, {}, limit);
    EXPECT_LE(greatest(path.q, times), limit * 1.0001);
    const double added = times.back() - path.times.back(), minimum = 2.0 / std::sqrt(limit);
    EXPECT_GT(added, minimum);
    EXPECT_LT(added, 1.15 * minimum);
  }
}

TEST(JerkLimit, RefusesNoLimit) {
  EXPECT_THROW(motion::timesWithinJerk({}, {}, {}, 0.0), base::Error);
}

namespace {

motion::MotionResult planned(const plan::ToolPlan& plan, double maxJerk) {
  const process::Process process = process::loadProcess("fdm-1.0");
  platform::PlatformSolid plate;
  plate.polygon = test::disc(20.0);
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, plate);
  const collision::GrowingPart part(plan, 1.0, {});
  motion::MotionOptions options;
  options.maxJerk = maxJerk;
  return motion::MotionPlanner(plan, cell, process::Tooling(process), part, options).plan({});
}

double greatest(const std::vector<double>& jerks) {
  return *std::max_element(jerks.begin(), jerks.end());
}

bool isOverLimit(const plan::Finding& finding) {
  return finding.kind == plan::FindingKind::JerkOverLimit;
}

} // namespace

TEST(JerkLimit, IsKeptByAWholeMotion) {
  const plan::ToolPlan plan = test::cylinder(12.0, 3);
  const motion::MotionResult free = planned(plan, 0.0), limited = planned(plan, 20.0);
  EXPECT_GT(greatest(free.statistics.maxJerk), 20.0);
  EXPECT_EQ(free.statistics.jerkSlowedS, 0.0);
  EXPECT_LE(greatest(limited.statistics.maxJerk), 20.0 * 1.001);
  EXPECT_LE(greatest(limited.statistics.maxTravelJerk), 20.0 * 1.01);
  EXPECT_GT(limited.statistics.jerkSlowedS, 0.0);
  EXPECT_GT(limited.statistics.durationS, free.statistics.durationS);
  EXPECT_EQ(limited.trajectory.extrudedMm3.back(), free.trajectory.extrudedMm3.back());
  EXPECT_TRUE(std::none_of(limited.findings.begin(), limited.findings.end(), isOverLimit));
}

TEST(JerkLimit, RemainingExcessBecomesAFindingWithItsPlace) {
  const motion::MotionResult limited = planned(test::cylinder(12.0, 1), 1e-4);
  const auto found = std::find_if(limited.findings.begin(), limited.findings.end(), isOverLimit);
  ASSERT_NE(found, limited.findings.end());
  EXPECT_FALSE(found->blocking);
  ASSERT_TRUE(found->whenS);
  EXPECT_LE(*found->whenS, limited.trajectory.timeS.back());
  EXPECT_TRUE(found->where);
}
