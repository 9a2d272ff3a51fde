// Plans of both schemes, judged by a checker that shares nothing with them.
#include "planar/published/greedy_decompose.h"
#include "planar/search/beam_search.h"

#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/all_seeds.h"
#include "helpers/models.h"
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

constexpr double kDegree = base::degreesToRadians(1.0);

void expectValid(const TriangleMesh& part, const PlanarDecomposition& d,
                 const PlanarOptions& options) {
  const test::PlanVerdict verdict =
      test::checkPlan(part, d.pieces, test::checkOf(d.pieces, options));
  for (const std::string& fault : verdict.faults)
    ADD_FAILURE() << fault;
  EXPECT_NEAR(verdict.riskyMm2, d.riskyMm2, 0.02 * d.riskyMm2 + 1.0);
  EXPECT_LE(verdict.blockedPieces, d.blockedPieces);
}

// A block in two, cut at z = 10.
std::vector<Piece> twoBlocks() {
  Piece lower, upper;
  lower.solid = tagged(test::box({0, 0, 0}, {20, 20, 10}));
  upper.solid = tagged(test::box({0, 0, 10}, {20, 20, 30}));
  upper.base = {Vector3d::UnitZ(), 10.0};
  upper.baseTag = 0;
  return {lower, upper};
}

TEST(PlanChecker, FindsEachFault) {
  const TriangleMesh block = test::box({0, 0, 0}, {20, 20, 30});
  const auto faults = [&](const std::vector<Piece>& pieces) {
    return test::checkPlan(block, pieces, {}).faults.size();
  };
  EXPECT_EQ(faults(twoBlocks()), 0u);
  EXPECT_EQ(test::checkPlan(block, twoBlocks(), {}).riskyMm2, 0.0);
  auto pieces = twoBlocks();
  std::swap(pieces[0], pieces[1]);
  EXPECT_GT(faults(pieces), 0u) << "printed before what holds it";
  pieces = twoBlocks();
  pieces.pop_back();
  EXPECT_GT(faults(pieces), 0u) << "a piece less";
  pieces = twoBlocks();
  pieces[1].solid.mesh.triangles.pop_back();
  EXPECT_GT(faults(pieces), 0u) << "open";
  pieces = twoBlocks();
  pieces[1].solid = tagged(test::box({0, 0, 9}, {20, 20, 29}));
  pieces[1].base.offsetMm = 9.0;
  EXPECT_GT(faults(pieces), 0u) << "overlaps what it stands on";
  pieces = twoBlocks();
  pieces[1].base.offsetMm = 12.0;
  EXPECT_GT(faults(pieces), 0u) << "below its base";
}

TEST(PlanChecker, KnowsRiskyAreaAndTheHead) {
  // Upside down over the plate nothing is supported: all of the underside is risky.
  auto pieces = twoBlocks();
  std::swap(pieces[0], pieces[1]);
  EXPECT_NEAR(test::checkPlan(test::box({0, 0, 0}, {20, 20, 30}), pieces, {}).riskyMm2, 400.0,
              1e-6);
  // A tower beside a low block: after the tower the head does not come down to the block.
  Piece tower, block;
  tower.solid = tagged(test::box({0, 0, 0}, {5, 5, 40}));
  block.solid = tagged(test::box({11, 0, 0}, {16, 5, 5}));
  TriangleMesh both = tower.solid.mesh;
  test::append(both, block.solid.mesh);
  test::PlanCheck check;
  check.head = process::loadProcess("fdm-1.0").head;
  EXPECT_EQ(test::checkPlan(both, {tower, block}, check).blockedPieces, 1u);
  EXPECT_EQ(test::checkPlan(both, {block, tower}, check).blockedPieces, 0u);
}

TEST(PlanChecker, SeesSectionsThatCross) {
  // A block in four by two planes through one another: each base is cut by the other's.
  const TriangleMesh block = test::box({0, 0, 0}, {20, 20, 20});
  const auto piece = [](const Vector3d& low, const Vector3d& high, const Plane& base,
                        std::int32_t tag) {
    Piece p;
    p.solid = tagged(test::box(low, high));
    p.base = base;
    p.baseTag = tag;
    return p;
  };
  // The upper block rests on both lower ones, the wall beside them through its base.
  const Piece left = piece({0, 0, 0}, {10, 20, 10}, {Vector3d::UnitZ(), 0.0}, kPlate);
  const Piece right = piece({10, 0, 0}, {20, 20, 10}, {Vector3d::UnitX(), 10.0}, 0);
  const Piece upper = piece({0, 0, 10}, {20, 20, 20}, {Vector3d::UnitZ(), 10.0}, 1);
  EXPECT_TRUE(test::checkPlan(block, {left, right, upper}, {}).faults.empty())
      << "sections that end at one another touch";
  const Piece wall = piece({10, 0, 0}, {20, 20, 20}, {Vector3d::UnitX(), 10.0}, 0);
  Piece through = piece({0, 0, 10}, {20, 20, 20}, {Vector3d::UnitZ(), 10.0}, 1);
  EXPECT_FALSE(test::checkPlan(block, {left, wall, through}, {}).faults.empty());
}

struct HandPart {
  const char* name;
  TriangleMesh (*make)();
  int alphaDeg;
  // One piece has risky undersides, so 2 at least. At 45 degrees a way half up, half to one side
  // prints undersides, tops and the ends on the other side at once: all but the post is one piece.
  // At 30 degrees no way does (at most 30 degrees up for the undersides, at least 60 for the ends),
  // so that each side is a piece of its own: 3. Of the ball neither does at 45 degrees, as it looks
  // every way but to its stem: arm and near side, far side, post: 3.
  std::size_t best;
  bool head; // a head of the size of ours has no room beside the ball
};
std::ostream& operator<<(std::ostream& out, const HandPart& p) {
  return out << p.name;
}

class HandParts : public testing::TestWithParam<HandPart> {
protected:
  void SetUp() override {
    if (GetParam().head)
      options_.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
    options_.rule.overhangRad = GetParam().alphaDeg * kDegree;
    options_.target = 1e-9;
  }
  PlanarOptions options_;
};

TEST_P(HandParts, TheBeamFindsTheBestNumberOfPieces) {
  const TriangleMesh part = GetParam().make();
  ASSERT_TRUE(isClosed(part));
  const PlanarDecomposition d = beamDecompose(part, options_, base::RunContext({}, 2));
  EXPECT_GT(d.riskyBeforeMm2, 50.0);
  EXPECT_NEAR(d.riskyMm2, 0.0, 1e-6);
  EXPECT_EQ(d.pieces.size(), GetParam().best);
  EXPECT_EQ(d.blockedPieces, 0u);
  expectValid(part, d, options_);
}

TEST_P(HandParts, TheGreedySchemeEndsWithAValidPlan) {
  const TriangleMesh part = GetParam().make();
  const PlanarDecomposition d = greedyDecompose(part, options_, {}, base::RunContext({}, 2));
  EXPECT_LT(d.riskyMm2, 0.5 * d.riskyBeforeMm2);
  expectValid(part, d, options_);
  RecordProperty("pieces", static_cast<int>(d.pieces.size()));
  RecordProperty("riskyMm2", std::to_string(d.riskyMm2));
  const PlanarDecomposition again = greedyDecompose(part, options_, {}, base::RunContext({}, 1));
  ASSERT_EQ(again.pieces.size(), d.pieces.size());
  for (std::size_t i = 0; i < d.pieces.size(); ++i)
    EXPECT_EQ(again.pieces[i].solid.mesh.vertices, d.pieces[i].solid.mesh.vertices);
}

INSTANTIATE_TEST_SUITE_P(Hand, HandParts,
                         testing::Values(HandPart{"tee", test::tee, 45, 2, true},
                                         HandPart{"tee", test::tee, 30, 3, true},
                                         HandPart{"wye", test::wye, 45, 2, true},
                                         HandPart{"wye", test::wye, 30, 3, true},
                                         HandPart{"mushroom", test::mushroom, 45, 2, true},
                                         HandPart{"mushroom", test::mushroom, 30, 3, true},
                                         HandPart{"hangingBall", test::hangingBall, 45, 3, false}));

class ModelPlans : public testing::TestWithParam<const char*> {};

TEST_P(ModelPlans, BothSchemesAreValidAndTheBeamLeavesNoMore) {
  VOLUTA_MODEL_OR_SKIP(file, GetParam());
  TriangleMesh part = geometry::readMesh(file).mesh;
  const double low = geometry::bounds(part).min().z();
  for (Vector3d& v : part.vertices)
    v.z() -= low;
  PlanarOptions options;
  options.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
  const PlanarDecomposition greedy = greedyDecompose(part, options, {}, base::RunContext({}, 2));
  expectValid(part, greedy, options);
  EXPECT_LT(greedy.riskyMm2, greedy.riskyBeforeMm2);
  const PlanarDecomposition beam = beamDecompose(part, options, base::RunContext({}, 2));
  expectValid(part, beam, options);
  EXPECT_LE(beam.riskyMm2, greedy.riskyMm2);
}

INSTANTIATE_TEST_SUITE_P(Real, ModelPlans,
                         testing::ValuesIn(test::allSeeds()
                                               ? std::vector{"spot.stl", "bunny_7k.stl"}
                                               : std::vector{"spot.stl"}));

} // namespace
} // namespace voluta::planar
