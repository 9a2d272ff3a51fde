// Known errors are found at their places, and none where there are none.
#include "record/run_comparison.h"

#include "base/error.h"
#include "base/run_context.h"
#include "helpers/all_seeds.h"
#include "record/planned.h"

#include <gtest/gtest.h>

namespace voluta::record {
namespace {

using Eigen::Vector3d;
using test::placesOf, test::randomBeads, test::recordOf, test::RecordErrors;

constexpr double kRtdeS = 0.008, kMelfaS = 0.00711;

RunComparison compared(const RecordedRun& run, const PlannedRun& planned) {
  return compareRun(run, planned, {}, base::RunContext());
}

// The middle of a straight printed stretch of at least 12 mm that begins after a share of the plan.
double straightBead(const PlannedRun& planned, double share) {
  std::size_t first = 1;
  const auto isStraight = [&](std::size_t s) {
    return planned.prints[s] != 0 && planned.prints[s - 1] != 0 && s > 1 &&
           (planned.tip[s] - planned.tip[s - 1])
                   .normalized()
                   .dot((planned.tip[s - 1] - planned.tip[s - 2]).normalized()) > 0.999;
  };
  for (std::size_t s = 1; s < planned.size(); ++s) {
    if (!isStraight(s))
      first = s;
    if (planned.alongMm[first] > share * planned.lengthMm() &&
        planned.alongMm[s] - planned.alongMm[first] > 12.0)
      return 0.5 * (planned.alongMm[s] + planned.alongMm[first]);
  }
  return -1.0;
}

TEST(CompareRun, WithoutErrorsNoneIsFound) {
  for (unsigned seed = 0; seed < test::ofSeeds(20u, 100u); ++seed) {
    const PlannedRun planned = randomBeads(seed);
    for (const double cycleS : {kRtdeS, kMelfaS}) {
      const RunComparison c = compared(recordOf(planned, {}, cycleS), planned);
      EXPECT_EQ(c.verdict(), RunVerdict::Within) << seed;
      EXPECT_LT(c.pathMaxMm, 1e-9) << seed;
      EXPECT_LT(std::abs(c.speedSlowest) + std::abs(c.speedFastest), 1e-3) << seed;
      EXPECT_LT(std::abs(c.speedMean), 1e-3) << seed;
      EXPECT_GT(c.printedMm, 0.98 * c.beadsMm) << seed;
    }
  }
}

TEST(CompareRun, SlowSpeedAndWrongPathAreFoundAtTheirPlaces) {
  for (unsigned seed = 0; seed < test::ofSeeds(25u, 100u); ++seed) {
    const PlannedRun planned = randomBeads(seed);
    const double slowMm = straightBead(planned, 0.2), offsetMm = straightBead(planned, 0.6);
    ASSERT_GT(std::min(slowMm, offsetMm), 0.0) << seed;
    RecordErrors errors;
    errors.speed = [&](double mm) { return std::abs(mm - slowMm) < 5.0 ? 0.98 : 1.0; };
    // Rises and falls over 2 mm, across the line in the plane.
    errors.offset = [&](double mm) {
      const double share = std::clamp((4.0 - std::abs(mm - offsetMm)) / 2.0, 0.0, 1.0);
      return Vector3d(0, 0.3 * share, 0);
    };
    const RunComparison c = compared(recordOf(planned, errors, kRtdeS), planned);
    const auto path = placesOf(c, ErrorKind::Path), speed = placesOf(c, ErrorKind::Speed),
               flow = placesOf(c, ErrorKind::Flow);
    ASSERT_EQ(path.size(), 1u) << seed;
    EXPECT_NEAR(path[0].worst, 0.3, 0.01) << seed;
    EXPECT_LT((path[0].where - planned.tip[placeAt(planned, offsetMm).segment]).norm(), 5.0)
        << seed;
    ASSERT_EQ(speed.size(), 1u) << seed;
    EXPECT_NEAR(speed[0].worst, -0.02, 0.002) << seed;
    EXPECT_NEAR(speed[0].planS, placeAt(planned, slowMm).timeS, 0.6) << seed;
    ASSERT_EQ(flow.size(), 1u) << seed;
    EXPECT_NEAR(flow[0].worst, 1.0 / 0.98 - 1.0, 0.002) << seed;
    EXPECT_EQ(c.missingMm, 0.0) << seed;
  }
}

TEST(CompareRun, NoiseOfARealRecordIsNoError) {
  for (unsigned seed = 0; seed < test::ofSeeds(15u, 50u); ++seed) {
    const PlannedRun planned = randomBeads(seed);
    RecordErrors errors;
    errors.noiseMm = 0.01;
    errors.seed = seed;
    const RunComparison c = compared(recordOf(planned, errors, kRtdeS), planned);
    EXPECT_TRUE(placesOf(c, ErrorKind::Path).empty()) << seed;
    EXPECT_TRUE(placesOf(c, ErrorKind::Missing).empty()) << seed;
    EXPECT_LT(c.pathMaxMm, 0.08) << seed;
    EXPECT_LT(std::abs(c.speedMean), 1e-3) << seed;
  }
}

TEST(CompareRun, ASlowRunIsSlowEverywhere) {
  const PlannedRun planned = randomBeads(7);
  RecordErrors errors;
  errors.speed = [](double) { return 0.98; };
  const RunComparison c = compared(recordOf(planned, errors, kRtdeS), planned);
  EXPECT_NEAR(c.speedMean, -0.02, 1e-3);
  EXPECT_FALSE(placesOf(c, ErrorKind::Speed).empty());
  EXPECT_LT(c.pathMaxMm, 1e-9);
}

TEST(CompareRun, RecordOfAPartIsAlignedWithIt) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const PlannedRun planned = randomBeads(seed);
    const double wholeS = planned.timeS.back();
    const RunComparison c =
        compared(recordOf(planned, {}, kRtdeS, 0.43 * wholeS, 0.8 * wholeS), planned);
    EXPECT_EQ(c.verdict(), RunVerdict::Incomplete) << seed;
    EXPECT_TRUE(c.places.empty()) << seed;
    ASSERT_FALSE(c.curve.planS.empty()) << seed;
    EXPECT_NEAR(c.curve.planS.front() - 0.43 * wholeS, 0.0, 4.0) << seed;
    for (std::size_t i = 0; i < c.curve.planS.size(); ++i)
      EXPECT_NEAR(c.curve.planS[i] - c.curve.recordS[i], 0.43 * wholeS, 0.01) << seed;
  }
}

TEST(CompareRun, ABeadThatIsPassedOverIsMissing) {
  const PlannedRun planned = randomBeads(11);
  const double fromS = placeAt(planned, straightBead(planned, 0.4)).timeS;
  RecordedRun run = recordOf(planned, {}, kRtdeS);
  const auto from = static_cast<std::ptrdiff_t>(fromS / kRtdeS);
  // A connection of two lines: the recorder lost two whole seconds.
  run.tip.erase(run.tip.begin() + from, run.tip.begin() + from + 250);
  run.timeS.erase(run.timeS.begin() + from, run.timeS.begin() + from + 250);
  const RunComparison c = compared(run, planned);
  ASSERT_EQ(placesOf(c, ErrorKind::Missing).size(), 1u);
  EXPECT_NEAR(placesOf(c, ErrorKind::Missing)[0].planS, fromS, 0.1);
  EXPECT_GT(c.missingMm, 10.0);
}

TEST(CompareRun, RecordedFlowIsComparedByLength) {
  const PlannedRun planned = randomBeads(3);
  const double lessMm = straightBead(planned, 0.5);
  RecordedRun run = recordOf(planned, {}, kRtdeS);
  double mm3 = 0.0, before = 0.0;
  for (const double timeS : run.timeS) {
    const auto at = std::ranges::upper_bound(planned.timeS, timeS) - planned.timeS.begin();
    const auto s = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(at, 1, static_cast<std::ptrdiff_t>(planned.size()) - 1));
    const double share = (timeS - planned.timeS[s - 1]) / (planned.timeS[s] - planned.timeS[s - 1]);
    const double total =
        planned.extrudedMm3[s - 1] + share * (planned.extrudedMm3[s] - planned.extrudedMm3[s - 1]);
    const double along =
        planned.alongMm[s - 1] + share * (planned.alongMm[s] - planned.alongMm[s - 1]);
    mm3 += (total - before) * (std::abs(along - lessMm) < 5.0 ? 0.9 : 1.0);
    before = total;
    run.extrudedMm3.push_back(mm3);
  }
  const RunComparison c = compared(run, planned);
  EXPECT_TRUE(c.flowIsRecorded);
  const auto flow = placesOf(c, ErrorKind::Flow);
  ASSERT_EQ(flow.size(), 1u);
  EXPECT_NEAR(flow[0].worst, -0.1, 0.005);
  EXPECT_NEAR(flow[0].planS, placeAt(planned, lessMm).timeS, 0.6);
  EXPECT_TRUE(placesOf(c, ErrorKind::Speed).empty());
}

TEST(CompareRun, ARecordOfAnotherPlaceIsRefused) {
  const PlannedRun planned = randomBeads(1);
  RecordedRun run = recordOf(planned, {}, kRtdeS);
  for (Vector3d& tip : run.tip)
    tip.z() += 100.0;
  EXPECT_THROW(compared(run, planned), base::Error);
}

// The verdict by the share of the beads that is recorded, and its sentence.
TEST(CompareRun, LittleOfTheJobIsNoRecordOfIt) {
  RunComparison c;
  c.beadsMm = 9554.6;
  EXPECT_EQ(c.verdict(), RunVerdict::OtherJob) << "nothing is compared";
  c.printedMm = 95.0;
  EXPECT_EQ(c.verdict(), RunVerdict::OtherJob);
  EXPECT_EQ(base::english(verdictSentence(c)),
            "this is no record of this job: 95.0 mm of 9554.6 mm of beads agree");
  c.printedMm = 8599.0;
  EXPECT_EQ(c.verdict(), RunVerdict::Incomplete);
  EXPECT_EQ(base::english(verdictSentence(c)), "only 8599.0 mm of 9554.6 mm of beads are recorded");
  c.printedMm = 8600.0;
  EXPECT_EQ(c.verdict(), RunVerdict::Within);
  c.places.emplace_back();
  EXPECT_EQ(c.verdict(), RunVerdict::Beyond);
  EXPECT_EQ(base::english(verdictSentence(c)), "1 place is beyond the tolerances");
}

// A transfer of which only the ends are recorded is longer than the band of places that is searched
// for the next sample.
TEST(CompareRun, ATransferRecordedByItsEndsIsFollowed) {
  test::PlannedBeads beads;
  beads.travelTo({0, 0, 400});
  const auto layer = [&](double y, double z) {
    beads.travelTo({0, y, z});
    for (int line = 0; line < 6; ++line) {
      beads.printTo({line % 2 == 0 ? 30.0 : 0.0, y + 1.2 * line, z}, 20);
      beads.printTo({line % 2 == 0 ? 30.0 : 0.0, y + 1.2 * (line + 1), z}, 20);
    }
  };
  for (int k = 0; k < 6; ++k)
    layer(k % 2 == 0 ? 0.0 : 300.0, 0.8 * (k / 2 + 1));
  beads.travelTo({0, 0, 400});
  const PlannedRun& planned = beads.run();
  RecordedRun run = recordOf(planned, {}, kRtdeS);
  // Keeps the first sample of each transfer only, as its end is the first one on a bead.
  RecordedRun kept;
  for (std::size_t i = 0; i < run.tip.size(); ++i) {
    const auto at = static_cast<std::size_t>(std::ranges::lower_bound(planned.timeS, run.timeS[i]) -
                                             planned.timeS.begin());
    if (i > 0 && planned.prints[std::clamp<std::size_t>(at, 1, planned.size() - 1)] == 0)
      continue;
    kept.tip.push_back(run.tip[i]);
    kept.timeS.push_back(run.timeS[i]);
  }
  const RunComparison c = compared(kept, planned);
  EXPECT_EQ(c.verdict(), RunVerdict::Within);
  EXPECT_GT(c.printedMm, 0.99 * c.beadsMm);
  EXPECT_LT(c.pathMaxMm, 1e-6);
}

} // namespace
} // namespace voluta::record
