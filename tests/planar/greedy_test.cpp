// RoboFDM's fine cuts: the head's true shape instead of constraint I.
#include "planar/published/greedy_decompose.h"
#include "planar/published/piece_ways.h"

#include "geometry/measures.h"
#include "helpers/all_seeds.h"
#include "helpers/made_parts.h"
#include "helpers/shapes.h"
#include "planar/hand_parts.h"
#include "planar/plan_check_of.h"
#include "planar/plan_checker.h"
#include "process/process.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

PlanarOptions withHead() {
  PlanarOptions options;
  options.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
  return options;
}

Piece block(const Vector3d& low, const Vector3d& high) {
  Piece piece;
  piece.solid = tagged(test::box(low, high));
  return piece;
}

TEST(PieceWays, CountsThePiecesBehindOthersInTheirBestOrder) {
  const PlanarOptions options = withHead();
  PieceWays ways(options, 1.0);
  // The head does not come down to the low block after the tower, and reaches the tower at any
  // time.
  const std::size_t tower = ways.add(block({0, 0, 0}, {5, 5, 40})),
                    low = ways.add(block({11, 0, 0}, {16, 5, 5}));
  EXPECT_EQ(ways.blocked({tower}), 0U);
  EXPECT_EQ(ways.blocked({tower, low}), 0U);
  // A block that is printed on the tower's section, upside down beside the low block.
  Piece hanging = block({11, 0, 8}, {16, 5, 12});
  hanging.base = {-Vector3d::UnitZ(), -12.0};
  hanging.baseTag = 3;
  const std::size_t over = ways.add(hanging);
  EXPECT_GT(ways.blocked({tower, low, over}), 0U);
  ways.remove(over);
  EXPECT_EQ(ways.blocked({tower, low}), 0U);
}

TEST(PieceWays, WithoutAHeadNothingIsBlocked) {
  const PlanarOptions options;
  PieceWays ways(options, 1.0);
  Piece hanging = block({0, 0, 8}, {5, 5, 12});
  hanging.base = {-Vector3d::UnitZ(), -12.0};
  const std::size_t low = ways.add(block({0, 0, 0}, {5, 5, 5})), over = ways.add(hanging);
  EXPECT_EQ(ways.blocked({low, over}), 0U);
}

// Returns the number of pieces.
std::size_t checkMadePart(unsigned seed) {
  const test::MadePart part = test::madePart(seed);
  if (!isClosed(part.mesh))
    return 0;
  const PlanarOptions options = withHead();
  const PlanarDecomposition d = greedyDecompose(part.mesh, options, {}, base::RunContext({}, 2));
  const test::PlanCheck check = test::checkOf(d.pieces, options);
  const test::PlanVerdict verdict = test::checkPlan(part.mesh, d.pieces, check);
  for (const std::string& fault : verdict.faults)
    ADD_FAILURE() << part.name << ": " << fault;
  EXPECT_LE(d.riskyMm2, d.riskyBeforeMm2) << part.name;
  EXPECT_NEAR(verdict.riskyMm2, d.riskyMm2, 0.02 * d.riskyMm2 + 1.0) << part.name;
  EXPECT_LE(verdict.blockedPieces, d.blockedPieces) << part.name;
  double volume = 0.0;
  for (const Piece& piece : d.pieces)
    volume += geometry::volume(piece.solid.mesh);
  EXPECT_NEAR(volume, geometry::volume(part.mesh), 1e-3 * volume) << part.name;
  return d.pieces.size();
}

TEST(Greedy, CutsAreCheckedOnAFewMadeParts) {
  std::size_t pieces = 0;
  for (unsigned seed = 0; seed < 2; ++seed)
    pieces += checkMadePart(seed);
  EXPECT_GT(pieces, 0U);
}

TEST(Greedy, CutsAreCheckedOnMadeParts) {
  std::size_t parts = 0, pieces = 0;
  for (unsigned seed = 100; seed < 200; seed += test::ofSeeds(12u, 4u), ++parts)
    pieces += checkMadePart(seed);
  EXPECT_GT(pieces, parts);
}

} // namespace
} // namespace voluta::planar
