// Recorded samples on the planned path, in its order.
#include "record/run_alignment.h"

#include "base/run_context.h"
#include "helpers/all_seeds.h"
#include "record/planned.h"

#include <gtest/gtest.h>

namespace voluta::record {
namespace {

using Eigen::Vector3d;
using test::randomBeads, test::recordOf, test::RecordErrors;

TEST(AlignRecord, PlacesNeverDecrease) {
  for (unsigned seed = 0; seed < test::ofSeeds(25u, 100u); ++seed) {
    const PlannedRun planned = randomBeads(seed);
    RecordErrors errors;
    errors.noiseMm = 0.1;
    errors.seed = seed;
    const RecordedRun run = recordOf(planned, errors, 0.008);
    const auto aligned = alignRecord(run.tip, planned, base::RunContext());
    ASSERT_TRUE(aligned) << seed;
    for (std::size_t k = 1; k < aligned->samples.size(); ++k)
      ASSERT_LE(aligned->samples[k - 1].alongMm, aligned->samples[k].alongMm) << seed;
  }
}

// A path that is followed twice: its passes are at the same places.
TEST(AlignRecord, TheSamePathTwiceIsInItsOrder) {
  test::PlannedBeads beads;
  beads.travelTo({0, 0, 10});
  for (int pass = 0; pass < 3; ++pass) {
    beads.travelTo({0, 0, 1});
    beads.printTo({40, 0, 1}, 20);
    beads.printTo({40, 30, 1}, 20);
    beads.printTo({0, 30, 1}, 20);
    beads.printTo({0, 0, 1}, 20);
    beads.travelTo({0, 0, 10});
  }
  const PlannedRun& planned = beads.run();
  const RecordedRun run = recordOf(planned, {}, 0.008);
  const auto aligned = alignRecord(run.tip, planned, base::RunContext());
  ASSERT_TRUE(aligned);
  for (std::size_t k = 0; k < aligned->samples.size(); ++k) {
    const double planS = placeAt(planned, aligned->samples[k].alongMm).timeS;
    ASSERT_NEAR(planS, run.timeS[aligned->first + k], 0.02) << k;
  }
}

TEST(AlignRecord, AWaitBeforeAndBehindIsLeftOut) {
  const PlannedRun planned = randomBeads(5);
  RecordedRun run = recordOf(planned, {}, 0.008);
  run.tip.insert(run.tip.begin(), 500, Vector3d(300, 200, 100));
  run.tip.insert(run.tip.end(), 700, Vector3d(300, 200, 100));
  const auto aligned = alignRecord(run.tip, planned, base::RunContext());
  ASSERT_TRUE(aligned);
  EXPECT_EQ(aligned->first, 500u);
  EXPECT_EQ(aligned->end, run.tip.size() - 700);
}

} // namespace
} // namespace voluta::record
