// Solids above one cut that hide each other from the head: one piece.
#include "planar/published/greedy_decompose.h"

#include "helpers/made_solids.h"
#include "helpers/shapes.h"
#include "planar/plan_check_of.h"
#include "planar/plan_checker.h"
#include "planar/plate_contact.h"
#include "process/process.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace voluta::planar {
namespace {

using geometry::TriangleMesh;

// Two parallel lugs with a bore through both, closer together than the head is wide.
TriangleMesh clevis() {
  using test::operator+, test::operator-;
  const TriangleMesh lugs = test::box({-16, -10, 0}, {16, 10, 6}) +
                            test::box({-10, -10, 5}, {-6, 10, 36}) +
                            test::box({6, -10, 5}, {10, 10, 36});
  return lugs - test::cylinder({-11, 0, 24}, {11, 0, 24}, 6.0);
}

std::size_t maxSolids(const PlanarDecomposition& d) {
  std::size_t maximum = 0;
  for (const Piece& piece : d.pieces)
    if (piece.baseTag != kPlate)
      maximum = std::max(maximum, solids(piece.solid).size());
  return maximum;
}

TEST(Joined, LugsThatHideEachOtherFromTheHeadArePrintedTogether) {
  const TriangleMesh part = clevis();
  PlanarOptions options;
  options.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
  const PlanarDecomposition d = greedyDecompose(part, options, {}, base::RunContext({}, 2));
  EXPECT_LT(d.riskyMm2, d.riskyBeforeMm2);
  EXPECT_EQ(d.blockedPieces, 0U);
  EXPECT_EQ(maxSolids(d), 2U);
  const test::PlanCheck check = test::checkOf(d.pieces, options);
  const test::PlanVerdict verdict = test::checkPlan(part, d.pieces, check);
  EXPECT_TRUE(verdict.faults.empty());
  EXPECT_EQ(verdict.blockedPieces, 0U);
}

} // namespace
} // namespace voluta::planar
