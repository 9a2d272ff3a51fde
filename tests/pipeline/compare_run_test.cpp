// Records of a planned box, with and without errors, beside its plan.
#include "pipeline/compare_run.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "program/common/rotation_vector.h"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using record::ErrorKind;

// Differences from the plan, by the plan's time.
struct Differences {
  double slowFromS = 0.0, slowToS = 0.0, speed = 1.0;
  double offsetFromS = 0.0, offsetToS = 0.0;
  Vector3d offset{0, 0, 0};
};

// Returns an RTDE record of the box's motion at 125 Hz: poses of the TCP in the robot's base.
std::string rtdeRecord(const Differences& d) {
  const PlanResult& plan = test::boxPlan();
  const plan::Trajectory& t = *plan.job.trajectory;
  const robot::Cell& cell = *plan.cell;
  constexpr double kCycleS = 0.008;
  std::string text = "timestamp actual_TCP_pose_0 actual_TCP_pose_1 actual_TCP_pose_2 "
                     "actual_TCP_pose_3 actual_TCP_pose_4 actual_TCP_pose_5\n";
  std::size_t i = 1;
  double recordS = 1000.0;
  for (double planS = 0.0; planS <= t.timeS.back(); recordS += kCycleS) {
    while (i + 1 < t.pointCount() && t.timeS[i] < planS)
      ++i;
    const double span = t.timeS[i] - t.timeS[i - 1];
    const double share = span > 0.0 ? std::min(1.0, (planS - t.timeS[i - 1]) / span) : 1.0;
    const robot::JointVector from = Eigen::Map<const Eigen::VectorXd>(t.at(i - 1), t.dof),
                             to = Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
    const robot::JointVector q = from + share * (to - from);
    Isometry3d work_T_tool = cell.work_T_tool(q);
    if (t.move[i] != plan::MoveKind::Joint) // Straight in the work frame, as programs move
      work_T_tool.translation() = (1.0 - share) * cell.work_T_tool(from).translation() +
                                  share * cell.work_T_tool(to).translation();
    if (planS > d.offsetFromS && planS < d.offsetToS)
      work_T_tool.translation() += d.offset;
    const Isometry3d tcp = cell.base_T_flange(work_T_tool, q) * cell.flange_T_moved();
    const Vector3d rotation = program::rotationVector(Eigen::Quaterniond(tcp.linear()));
    text += fmt::format("{:.3f} {:.7f} {:.7f} {:.7f} {:.7f} {:.7f} {:.7f}\n", recordS,
                        1e-3 * tcp.translation().x(), 1e-3 * tcp.translation().y(),
                        1e-3 * tcp.translation().z(), rotation.x(), rotation.y(), rotation.z());
    planS += kCycleS * (planS > d.slowFromS && planS < d.slowToS ? d.speed : 1.0);
  }
  return text;
}

// Returns the time at which a printed motion of a few centimetres begins, after a share of the
// plan.
double longMotionAt(double share) {
  const plan::Trajectory& t = *test::boxPlan().job.trajectory;
  std::size_t first = 0;
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (t.move[i] != plan::MoveKind::Print || t.timeS[i - 1] < share * t.timeS.back())
      first = i;
    if (t.timeS[i] - t.timeS[first] > 3.0)
      return t.timeS[first];
  }
  return 0.0;
}

record::RunComparison compared(const Differences& d) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "record.csv";
  base::writeFile(file, rtdeRecord(d));
  const ComparedRun run = compareRun(test::boxPlan().job, file, {}, base::RunContext());
  EXPECT_EQ(run.format, "rtde");
  return run.comparison;
}

std::vector<record::ErrorPlace> placesOf(const record::RunComparison& c, ErrorKind kind) {
  std::vector<record::ErrorPlace> places;
  std::ranges::copy_if(c.places, std::back_inserter(places),
                       [&](const record::ErrorPlace& place) { return place.kind == kind; });
  return places;
}

TEST(ComparedRun, OfThePlanItselfHasNoError) {
  const record::RunComparison c = compared({});
  EXPECT_EQ(c.verdict(), record::RunVerdict::Within);
  EXPECT_LT(c.pathMaxMm, 0.02);
  EXPECT_LT(std::abs(c.speedMean), 1e-3);
  EXPECT_EQ(c.missingMm, 0.0);
  EXPECT_GT(c.printedMm, 0.98 * c.beadsMm);
}

TEST(ComparedRun, SlowSpeedAndWrongPathAreFoundAtTheirPlaces) {
  const double slowS = longMotionAt(0.3), offsetS = longMotionAt(0.7);
  ASSERT_GT(slowS, 0.0);
  ASSERT_GT(offsetS, slowS + 3.0);
  const record::RunComparison c =
      compared({slowS, slowS + 3.0, 0.98, offsetS + 1.0, offsetS + 2.0, {0, 0, 0.3}});
  const auto path = placesOf(c, ErrorKind::Path), speed = placesOf(c, ErrorKind::Speed);
  ASSERT_EQ(path.size(), 1u);
  EXPECT_NEAR(path[0].worst, 0.3, 0.02);
  EXPECT_NEAR(path[0].planS, offsetS + 1.5, 0.6);
  ASSERT_FALSE(speed.empty());
  EXPECT_NEAR(speed[0].worst, -0.02, 0.004);
  for (const record::ErrorPlace& place : speed)
    EXPECT_NEAR(place.planS, slowS + 1.5, 2.0);
}

TEST(ComparedRun, BadInputIsRefused) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "record.csv";
  EXPECT_THROW(compareRun(test::boxPlan().job, file, {}, base::RunContext()), base::Error);
  base::writeFile(file, "a b\n1 2\n");
  EXPECT_THROW(compareRun(test::boxPlan().job, file, {}, base::RunContext()), base::Error);
  EXPECT_THROW(compareRun(folder.path() / "none.voluta", file, {}, base::RunContext()),
               base::Error);
}

} // namespace
} // namespace voluta::pipeline
