#include "replay/section_errors.h"

#include "base/run_context.h"
#include "replay/alignment.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

constexpr double kArea = 0.9, kSpeed = 20.0;

// A bead along x with steps of 1, 2, 3 ... mm, and a trajectory that deposits kArea along it.
// Motion m is point m; all motions have amounts.
struct Bead {
  plan::ReadProgram program;
  plan::Trajectory trajectory;
  std::vector<std::size_t> pointOf;
  double lengthMm = 0.0;

  explicit Bead(int steps) {
    for (int i = 0; i <= steps; ++i) {
      lengthMm += i;
      plan::ProgramMotion m;
      m.target = plan::TargetKind::ToolPoint;
      m.position = {lengthMm, 0, 0};
      m.speedMmPerS = kSpeed;
      m.extruding = i > 0;
      m.volumeMm3 = kArea * i;
      program.motions.push_back(m);
      trajectory.extrudedMm3.push_back(kArea * lengthMm);
      trajectory.timeS.push_back(lengthMm / kSpeed);
      pointOf.push_back(static_cast<std::size_t>(i));
    }
  }
  SectionErrors errors(double slower = 1.0) const {
    const ExecutedPath path = executeToolPoints(program, {});
    std::vector<double> seconds = path.durationS;
    for (double& s : seconds)
      s *= slower;
    return sectionErrors(program, path, trajectory, pointOf, seconds);
  }
};

TEST(SectionErrors, PlannedVolumesGiveNoError) {
  const SectionErrors e = Bead(8).errors();
  EXPECT_EQ(e.fraction, 0.0);
  EXPECT_FALSE(e.first);
}

TEST(SectionErrors, MoreOrLessThanTheToleranceIsTheMotionsLength) {
  for (const double by : {-0.2, -0.06, -0.04, 0.04, 0.06, 0.2}) {
    SCOPED_TRACE(by);
    Bead bead(8);
    for (const std::size_t m : {3u, 7u})
      bead.program.motions[m].volumeMm3 *= 1.0 + by;
    const SectionErrors e = bead.errors();
    const bool wrong = std::abs(by) > kSectionTolerance;
    EXPECT_NEAR(e.fraction, wrong ? (3.0 + 7.0) / bead.lengthMm : 0.0, 1e-12);
    EXPECT_EQ(e.first, wrong ? std::optional<std::size_t>(3) : std::nullopt);
  }
}

// Flows that are a fifth off, stated by the text and right by the text alone: only the plan knows.
TEST(SectionErrors, AWrongRateIsSeenAgainstThePlan) {
  for (const double by : {0.8, 1.0, 1.2}) {
    Bead bead(6);
    for (plan::ProgramMotion& m : bead.program.motions) {
      m.volumeMm3 = -1.0;
      m.flowMm3PerS = by * kArea * kSpeed;
    }
    const SectionErrors e = bead.errors();
    EXPECT_NEAR(e.fraction, by == 1.0 ? 0.0 : 1.0, 1e-12) << by;
    EXPECT_EQ(e.first.has_value(), by != 1.0);
  }
}

// A controller that takes longer deposits more at a given flow, and the same for given amounts.
TEST(SectionErrors, VolumeOfAFlowGrowsWithTheControllersTime) {
  for (const bool flows : {false, true}) {
    Bead bead(6);
    if (flows)
      for (plan::ProgramMotion& m : bead.program.motions) {
        m.volumeMm3 = -1.0;
        m.flowMm3PerS = kArea * kSpeed;
      }
    const auto path = executeToolPoints(bead.program, {});
    const std::vector<double> volume = flowingMm3(bead.program, std::vector<double>(7, 2.5));
    ASSERT_EQ(volume.size(), 7u);
    EXPECT_EQ(volume[0], 0.0) << "lays nothing";
    for (std::size_t m = 1; m < 7; ++m)
      EXPECT_NEAR(volume[m], kArea * (flows ? kSpeed * 2.5 : static_cast<double>(m)), 1e-12);
    EXPECT_EQ(bead.errors(1.03).fraction, 0.0);
    EXPECT_EQ(bead.errors(1.2).fraction, flows ? 1.0 : 0.0);
    EXPECT_EQ(bead.errors(0.8).fraction, flows ? 1.0 : 0.0);
  }
}

// Where a motion passes over points of the plan, or is at none, its own text is the reference.
TEST(SectionErrors, WithoutTwoPointsInARowTheTextIsTheMeasure) {
  const auto fractionWith = [](std::vector<std::size_t> pointOf, double slower) {
    Bead bead(4);
    for (plan::ProgramMotion& m : bead.program.motions) {
      m.volumeMm3 = -1.0;
      m.flowMm3PerS = 1.2 * kArea * kSpeed;
    }
    bead.pointOf = std::move(pointOf);
    return bead.errors(slower).fraction;
  };
  const std::size_t none = kUnmatched;
  EXPECT_EQ(fractionWith({none, none, none, none, none}, 1.0), 0.0);
  EXPECT_EQ(fractionWith({none, none, none, none, none}, 1.2), 1.0);
  // Motion 1 is at the plan's first point, 2 at its second; 4 passes over a point.
  EXPECT_NEAR(fractionWith({none, 0, 1, none, 3}, 1.0), 0.2, 1e-12);
  EXPECT_NEAR(fractionWith({0, 2, 4, 4, 3}, 1.0), 0.0, 1e-12);
  // Points that the trajectory does not have.
  EXPECT_EQ(fractionWith({4, 5, 6, 7, 8}, 1.0), 0.0);
}

TEST(SectionErrors, TravelsAndRoundingAreNoErrors) {
  Bead bead(5);
  bead.program.motions[2].extruding = false;
  bead.program.motions[4].extruding = false;
  bead.program.motions[5].volumeMm3 *= 1.1;
  EXPECT_NEAR(bead.errors().fraction, 5.0 / (1 + 3 + 5), 1e-12);
  // A text's last digit, of a motion that lays hardly anything.
  for (const double more : {0.0009, 0.0015}) {
    Bead small(3);
    for (std::size_t m = 0; m < 4; ++m)
      small.program.motions[m].volumeMm3 = small.trajectory.extrudedMm3[m] = 0.0;
    small.program.motions[2].volumeMm3 = more;
    EXPECT_EQ(small.errors().first.has_value(), more > 0.001);
  }
  Bead nothing(3);
  for (plan::ProgramMotion& m : nothing.program.motions)
    m.extruding = false;
  EXPECT_EQ(nothing.errors().fraction, 0.0);
}

} // namespace
} // namespace voluta::replay
