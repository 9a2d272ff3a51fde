// Parts of the kinds that people print, from seeds: sound ones, and a few of them planned.
#include "helpers/made_parts.h"
#include "pipeline/checked_program.h"
#include "project/loaded_part.h"

#include "base/run_context.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "pipeline/road.h"
#include "plan/finding.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

TEST(MadeParts, AreSoundAndTheSameForASeed) {
  for (unsigned seed = 0; seed < 48; ++seed) {
    const test::MadePart part = test::madePart(seed);
    const geometry::Diagnosis found = geometry::diagnose(part.mesh);
    EXPECT_TRUE(found.watertight) << part.name;
    EXPECT_GT(found.volumeMm3, 500.0) << part.name;
    EXPECT_NEAR(geometry::bounds(part.mesh).min().z(), 0.0, 1e-9) << part.name;
    EXPECT_LT(geometry::bounds(part.mesh).sizes().maxCoeff(), 130.0) << part.name;
    // CGAL may number vertices and place diagonals another way; the solid is the same.
    const test::MadePart again = test::madePart(seed);
    EXPECT_EQ(again.name, part.name);
    EXPECT_NEAR(geometry::volume(again.mesh), geometry::volume(part.mesh), 1e-6) << part.name;
  }
}

// Parts that no plan was ever tuned on: one of each kind that plans within seconds. More of them:
// bin/write_made_parts.
class PlannedMadePart : public testing::TestWithParam<unsigned> {};

TEST_P(PlannedMadePart, PassesWithoutFindingsThatBlock) {
  const test::MadePart part = test::madePart(GetParam());
  pipeline::PlanRequest request;
  request.item().loaded =
      project::loadedFrom(part.name + ".stl", std::make_shared<geometry::TriangleMesh>(part.mesh),
                          {}, true, base::RunContext());
  request.choices.item().automatic = true;
  request.choices.item().scale = "fit";
  request.choices.formats = {"csv", "gcode-extended"};
  const pipeline::PlanResult result = pipeline::planPart(request, base::RunContext({}, 2));
  for (const plan::Finding& f : result.job.report.findings)
    EXPECT_FALSE(f.blocking) << part.name << ": " << plan::englishReason(f);
  for (const auto& checked : result.checked)
    EXPECT_TRUE(checked->verdict.passed) << part.name << ": " << checked->program.format;
  EXPECT_TRUE(result.job.report.replay.passed) << part.name;
}

// An arch, stairs and a tree.
INSTANTIATE_TEST_SUITE_P(OfSeeds, PlannedMadePart, testing::Values(73u, 35u, 21u));

} // namespace
