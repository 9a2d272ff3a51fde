// RoboFDM's first two phases, each step on something whose answer is known.
#include "planar/piece_cut.h"
#include "planar/published/gaussian_mixture.h"
#include "planar/published/graph_cut.h"
#include "planar/published/greedy_decompose.h"
#include "planar/published/piece_graph.h"
#include "planar/published/piece_merge.h"
#include "planar/published/region_planes.h"
#include "planar/published/shape_diameter.h"
#include "planar/published/skeleton.h"
#include "planar/published/surface_regions.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "planar/hand_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

// Quantiles of a normal distribution, near enough: sums of two evenly spread numbers.
void addHump(double mean, double deviation, int count, std::vector<double>& out) {
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      out.push_back(mean + deviation * std::sqrt(6.0) * ((i + j + 1.0) / count - 1.0));
}

TEST(GaussianMixture, FindsHumpsAndHowManyThereAre) {
  std::vector<double> values;
  addHump(2.0, 0.3, 20, values);
  addHump(10.0, 1.0, 40, values);
  const std::vector<double> weights(values.size(), 1.0);
  const GaussianMixture two = fitMixture(values, weights, 2);
  EXPECT_NEAR(two.parts[0].mean, 2.0, 0.05);
  EXPECT_NEAR(two.parts[1].mean, 10.0, 0.05);
  EXPECT_NEAR(two.parts[0].deviation, 0.3, 0.03);
  EXPECT_NEAR(two.parts[1].deviation, 1.0, 0.05);
  EXPECT_NEAR(two.parts[0].share, 0.2, 0.01);
  EXPECT_EQ(bestMixture(values, weights, 6).parts.size(), 2u);
  values.clear();
  addHump(5.0, 1.0, 30, values);
  EXPECT_EQ(bestMixture(values, std::vector<double>(values.size(), 1.0), 6).parts.size(), 1u);
}

TEST(GraphCut, AgreesWithNeighboursWhereThatIsCheaper) {
  // A row whose third node leans a little to the other label, and whose last two do by far.
  const std::vector<std::vector<double>> costs{{0, 0, 1, 0, 9, 9}, {9, 9, 0, 9, 0, 0}};
  std::vector<LabelEdge> edges;
  for (std::size_t i = 0; i + 1 < 6; ++i)
    edges.push_back({{i, i + 1}, 2.0});
  EXPECT_EQ(graphCut(costs, edges), (std::vector<std::size_t>{0, 0, 0, 0, 1, 1}));
  for (LabelEdge& e : edges)
    e.cost = 0.1;
  EXPECT_EQ(graphCut(costs, edges), (std::vector<std::size_t>{0, 0, 1, 0, 1, 1}));
}

// A thick foot, a thin neck and a thick head, each 24 mm and more apart in z.
TriangleMesh dumbbell() {
  std::vector<Eigen::Vector2d> profile{{0, 0}};
  const auto stretch = [&](double r, double from, double to) {
    for (int i = 0; i <= 16; ++i)
      profile.emplace_back(r, from + (to - from) * i / 16);
  };
  for (const double r : {4.0, 8.0})
    profile.emplace_back(r, 0.0);
  stretch(12.0, 0.0, 24.0);
  profile.emplace_back(8.0, 24.5);
  stretch(4.0, 25.0, 65.0);
  profile.emplace_back(8.0, 65.5);
  stretch(12.0, 66.0, 90.0);
  for (const double r : {8.0, 4.0, 0.0})
    profile.emplace_back(r, 90.0);
  return test::turned(profile, 40);
}

struct Coarse {
  TriangleMesh mesh = dumbbell();
  Piece whole = wholePart(mesh, RiskRule());
  CurveSkeleton skeleton = curveSkeleton(mesh, base::RunContext());
  std::vector<double> diameters = shapeDiameters(mesh, skeleton, base::RunContext());
  SurfaceRegions regions = surfaceRegions(mesh, diameters, 2);
  std::vector<RegionPlane> planes = regionPlanes(mesh, regions);
};

TEST(CoarseDecomposition, TheSkeletonIsTheAxisAndDiametersAreRadii) {
  const Coarse c;
  ASSERT_FALSE(c.skeleton.points.empty());
  for (const Vector3d& p : c.skeleton.points)
    EXPECT_LT(p.head<2>().norm(), 1.5);
  for (std::size_t t = 0; t < c.mesh.triangles.size(); ++t) {
    const Vector3d m = (c.mesh.corner(t, 0) + c.mesh.corner(t, 1) + c.mesh.corner(t, 2)) / 3.0;
    if (m.z() > 35.0 && m.z() < 55.0) {
      EXPECT_NEAR(c.diameters[t], 4.0, 1.0);
    }
  }
}

TEST(CoarseDecomposition, PlanesAreWhereTheThicknessChanges) {
  const Coarse c;
  ASSERT_EQ(c.regions.count, 3);
  ASSERT_EQ(c.planes.size(), 2u);
  const PieceGraph graph =
      pieceGraph(c.mesh, c.regions, c.planes, c.whole, RiskRule(), std::nullopt);
  EXPECT_EQ(graph.order.size(), 3u);
  ASSERT_EQ(graph.outwards.size(), 2u);
  EXPECT_EQ(graph.outwards[0].from, graph.root);
  EXPECT_EQ(graph.outwards[0].to, graph.outwards[1].from);
  const std::array<double, 2> z{24.5, 65.5};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(graph.outwards[i].plane.normal.z(), 0.99);
    EXPECT_NEAR(graph.outwards[i].plane.offsetMm, z[i], 5.0);
    EXPECT_GT(graph.outwards[i].plane.heightOf(graph.outwards[i].beyond), 0.0);
  }
}

TEST(CoarseDecomposition, RootOffThePlateIsRefused) {
  const Coarse c;
  const auto graph = [&](const Vector3d& root) {
    return pieceGraph(c.mesh, c.regions, c.planes, c.whole, RiskRule(), root);
  };
  EXPECT_EQ(graph({12, 0, 10}).root, graph({0, 0, 0}).root);
  try {
    graph({0, 0, 90});
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    EXPECT_NE(std::string(e.what()).find("0.0, 0.0, 90.0"), std::string::npos);
    EXPECT_NE(voluta::base::english(e.remedy()).find("place the part"), std::string::npos);
  }
}

TEST(Merge, UndoesACut) {
  const Piece whole = wholePart(dumbbell(), RiskRule());
  const auto cut = splitPiece(whole, {Vector3d::UnitZ(), 40.0}, 0, {}, RiskRule());
  ASSERT_TRUE(cut);
  const auto one = merged(cut->below, cut->above.front());
  ASSERT_TRUE(one);
  EXPECT_TRUE(isClosed(one->solid.mesh));
  EXPECT_NEAR(geometry::volume(one->solid.mesh), geometry::volume(whole.solid.mesh), 1e-6);
  EXPECT_EQ(geometry::components(one->solid.mesh).count, 1);
  EXPECT_NEAR(riskyArea(*one, RiskRule()), riskyArea(whole, RiskRule()), 1e-6);
  EXPECT_TRUE(sectionsHeld(*one).empty());
  EXPECT_FALSE(merged(cut->above.front(), cut->below));
}

TEST(Greedy, AnOpenMeshIsRefused) {
  TriangleMesh open = test::box({0, 0, 0}, {10, 10, 10});
  open.triangles.pop_back();
  EXPECT_THROW(greedyDecompose(open, {}, {}, base::RunContext()), base::Error);
}

TEST(Greedy, PrintablePartIsOnePiece) {
  const PlanarDecomposition d =
      greedyDecompose(test::box({0, 0, 0}, {10, 12, 14}), {}, {}, base::RunContext());
  EXPECT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.riskyMm2, 0.0);
}

} // namespace
} // namespace voluta::planar
