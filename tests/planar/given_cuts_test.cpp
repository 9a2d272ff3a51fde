// Cuts given by the user: pieces of parts for which they are known, and cuts that are refused.
#include "planar/given_cuts.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "helpers/octagon_prism.h"
#include "planar/search/beam_search.h"

#include <gtest/gtest.h>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

constexpr double kBeadMm = 1.2;

// A leg of 8 x 8 x 20 with a bar of 40 x 8 x 8 across its top, of one piece.
TriangleMesh tee() {
  return test::tee(20, 40);
}

// Two posts on a foot.
TriangleMesh fork() {
  return test::octagonPrism(
      {{{-20, 0}, {20, 0}, {20, 25}, {10, 25}, {10, 5}, {-10, 5}, {-10, 25}, {-20, 25}}},
      {{{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}, {0, 5, 6}, {0, 6, 7}}}, 5);
}

GivenCut cut(const Vector3d& point, const Vector3d& normal) {
  return {point, {normal.normalized(), normal.normalized().dot(point)}, {}};
}

PlanarDecomposition decomposed(const TriangleMesh& part, const std::vector<GivenCut>& cuts) {
  return decomposeByCuts(part, cuts, {}, kBeadMm, {});
}

std::string refusal(const TriangleMesh& part, const std::vector<GivenCut>& cuts) {
  try {
    decomposed(part, cuts);
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    return e.what();
  }
  return "accepted";
}

TEST(GivenCuts, ATeesArmsArePrintedSideways) {
  const PlanarDecomposition d =
      decomposed(tee(), {cut({4, 0, 24}, {1, 0, 0}), cut({-4, 0, 24}, {-1, 0, 0})});
  ASSERT_EQ(d.pieces.size(), 3u);
  EXPECT_NEAR(d.riskyBeforeMm2, 2 * 16 * 8, 1e-9);
  EXPECT_NEAR(d.riskyMm2, 0.0, 1e-9);
  EXPECT_NEAR(d.sectionMm2, 2 * 8 * 8, 1e-9);
  EXPECT_EQ(d.pieces[0].parent, -1);
  EXPECT_NEAR(geometry::volume(d.pieces[0].solid.mesh), 8 * 8 * 28, 1e-9);
  for (const std::size_t arm : {1u, 2u}) {
    EXPECT_EQ(d.pieces[arm].parent, 0);
    EXPECT_TRUE(isClosed(d.pieces[arm].solid.mesh));
    EXPECT_NEAR(geometry::volume(d.pieces[arm].solid.mesh), 16 * 8 * 8, 1e-9);
    EXPECT_NEAR(std::abs(d.pieces[arm].base.normal.x()), 1.0, 1e-12);
  }
}

TEST(GivenCuts, OnlyTheSolidsOnTheNearestSectionAreCutOff) {
  const TriangleMesh part = fork();
  const PlanarDecomposition right = decomposed(part, {cut({12, 0, 15}, {0, 0, 1})});
  ASSERT_EQ(right.pieces.size(), 2u);
  EXPECT_GT(geometry::bounds(right.pieces[1].solid.mesh).min().x(), 9.9);
  EXPECT_NEAR(geometry::volume(right.pieces[1].solid.mesh), 10 * 10 * 10, 1e-9);
  // The same plane once more, for the other post.
  const PlanarDecomposition both =
      decomposed(part, {cut({12, 0, 15}, {0, 0, 1}), cut({-12, 0, 15}, {0, 0, 1})});
  ASSERT_EQ(both.pieces.size(), 3u);
  EXPECT_NEAR(both.sectionMm2, 2 * 100.0, 1e-9);
}

TEST(GivenCuts, SolidsAtFurtherPointsBelongToTheSamePiece) {
  GivenCut posts = cut({12, 0, 15}, {0, 0, 1});
  posts.also = {{-12, 0, 15}};
  const PlanarDecomposition d = decomposed(fork(), readGivenCuts(givenCutsText({posts}), "posts"));
  ASSERT_EQ(d.pieces.size(), 2u);
  EXPECT_NEAR(geometry::volume(d.pieces[1].solid.mesh), 2 * 10 * 10 * 10, 1e-9);
  EXPECT_NEAR(d.sectionMm2, 2 * 100.0, 1e-9);
  EXPECT_EQ(d.pieces[1].parent, 0);
  const std::vector<GivenCut> again = cutsOf(d.pieces);
  ASSERT_EQ(again.size(), 1u);
  ASSERT_EQ(again[0].also.size(), 1u);
  EXPECT_NEAR(again[0].point.x() + again[0].also[0].x(), 0.0, 1e-9);
}

TEST(GivenCuts, CutsOfASearchReproduceItsPieces) {
  const TriangleMesh part = tee();
  const PlanarDecomposition found = beamDecompose(part, {}, {});
  ASSERT_GT(found.pieces.size(), 1u);
  const std::vector<GivenCut> cuts =
      readGivenCuts(givenCutsText(cutsOf(found.pieces)), "the search's");
  ASSERT_EQ(cuts.size(), found.pieces.size() - 1);
  const PlanarDecomposition again = decomposed(part, cuts);
  ASSERT_EQ(again.pieces.size(), found.pieces.size());
  EXPECT_NEAR(again.riskyMm2, found.riskyMm2, 1e-3);
  EXPECT_NEAR(again.sectionMm2, found.sectionMm2, 1e-3);
  const std::vector<GivenCut> twice = cutsOf(again.pieces);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    EXPECT_LT((twice[i].plane.normal - cuts[i].plane.normal).norm(), 1e-6);
    EXPECT_NEAR(twice[i].plane.offsetMm, cuts[i].plane.offsetMm, 1e-3);
  }
}

TEST(GivenCuts, WrongOnesAreRefusedInOneLineThatNamesThem) {
  const TriangleMesh part = tee();
  const GivenCut fine = cut({4, 0, 24}, {1, 0, 0});
  EXPECT_EQ(refusal(part, {fine, cut({0, 0, 40}, {0, 0, 1})}),
            "cut 2: the plane misses the part (move it so that it crosses the part)");
  // Below the plane are the ends of the bar, above it the body that carries them.
  EXPECT_NE(refusal(part, {cut({4, 0, 24}, {-1, 0, 0})}).find("cut 1: leaves a piece without"),
            std::string::npos);
  EXPECT_NE(
      refusal(part, {fine, cut({-19, 0, 24}, {-1, 0, 0})}).find("cut 2: leaves a piece only 1 mm"),
      std::string::npos);
  EXPECT_NE(refusal(part, {cut({0, 0, 0.5}, {0, 0, 1})}).find("cut 1: leaves a piece only 0.5 mm"),
            std::string::npos);
  for (const char* wrong :
       {"", "[]", R"([{"point": [0,0,1]}])", R"([{"point": [0,0,1], "normal": [0,0,0]}])",
        R"([{"point": [0,0,1], "normal": [0,0,1], "also": [[1,2]]}])",
        R"([{"point": [0,0,1], "normal": [0,0,1], "also": 3}])",
        R"([{"corners": [[-1,-1,4],[8,-1,4],[8,11,4],[-1,11,4]]}])"})
    EXPECT_THROW(readGivenCuts(wrong, "here"), base::Error) << wrong;
  TriangleMesh open = part;
  open.triangles.pop_back();
  EXPECT_NE(refusal(open, {fine}).find("not closed"), std::string::npos);
}

} // namespace
} // namespace voluta::planar
