// The hull and the front, by brute force.
#include "curved/convex_front.h"
#include "curved/convex_hull.h"
#include "curved/cut_voxels.h"
#include "curved/flood.h"
#include "curved/grid_solver.h"
#include "curved/platform_polygon.h"
#include "curved/reverse_growth.h"
#include "curved/support_order.h"
#include "curved/voxel_shapes.h"
#include "curved/voxels_by_level.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace voluta::curved {
namespace {

const base::RunContext kQuiet;

VoxelGraph graphOf(const voxel::SolidVoxels& v) {
  return voxelGraph(v.grid, v.solid, v.plateLayer(), platformFit(v, 0.0));
}

// All points behind all facets, each edge shared by two facets the other way round, all facets of
// one surface without handles.
void expectHull(const std::vector<HullFacet>& hull, const std::vector<LatticePoint>& points) {
  std::map<std::pair<int, int>, int> edges;
  std::set<int> corners;
  for (const HullFacet& f : hull) {
    for (const LatticePoint& p : points)
      ASSERT_LE(f.normal.dot(p), f.offset);
    for (std::size_t s = 0; s < 3; ++s) {
      ++edges[{f.corner[s], f.corner[(s + 1) % 3]}];
      corners.insert(f.corner[s]);
      EXPECT_EQ(f.normal.dot(points[static_cast<std::size_t>(f.corner[s])]), f.offset);
    }
    EXPECT_GT(f.normal.squaredNorm(), 0.0);
  }
  for (const auto& [edge, n] : edges) {
    EXPECT_EQ(n, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(static_cast<int>(corners.size()) - static_cast<int>(edges.size() / 2) +
                static_cast<int>(hull.size()),
            2);
}

TEST(ConvexHull, RandomPoints) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 40; ++trial) {
    // Few values a coordinate give many flat faces and straight edges.
    const int range = trial % 2 ? 4 : 2000;
    std::vector<LatticePoint> points;
    for (int i = 0; i < 120; ++i)
      points.emplace_back(static_cast<double>(random() % static_cast<unsigned>(range)),
                          static_cast<double>(random() % static_cast<unsigned>(range)),
                          static_cast<double>(random() % static_cast<unsigned>(range)));
    expectHull(convexHull(points), points);
  }
}

TEST(ConvexHull, FlatOrTooFewPointsHaveNone) {
  EXPECT_TRUE(convexHull({}).empty());
  EXPECT_TRUE(convexHull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {3, 1, 0}}).empty());
  EXPECT_THROW(convexHull({{0.5, 0, 0}}), base::Error);
}

TEST(ConvexFront, AgreesWithBruteForceWhileVoxelsAreRemoved) {
  const voxel::SolidVoxels part = test::blobPart(5);
  const VoxelGraph graph = graphOf(part);
  ConvexFront front(graph), bare(graph, ConvexFront::Columns::None);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    front.insert(v);
    bare.insert(v);
  }
  std::mt19937 random(11);
  for (int round = 0; round < 4; ++round) {
    front.rebuild();
    bare.rebuild();
    std::vector<LatticePoint> all = graph.platform;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (front.present(v))
        all.push_back(graph.lattice(v));
    const std::vector<HullFacet> hull = convexHull(all);
    std::set<std::int32_t> shallow, outermost;
    std::size_t hint = 0;
    for (std::size_t v = 0; v < graph.size(); ++v) {
      double depth = 1e9;
      for (const HullFacet& f : hull)
        depth =
            std::min(depth, (f.offset - f.normal.dot(graph.lattice(v))) / f.normal.norm() / 16.0);
      EXPECT_NEAR(front.depth(v), depth, 1e-9);
      EXPECT_EQ(front.deeperThan(v, 0.0, hint), depth > 1e-10);
      EXPECT_EQ(bare.deeperThan(v, 0.0, hint), depth > 1e-10);
      for (const double limit : {0.1, 0.5, 0.75, 3.0})
        if (std::abs(depth - limit) > 1e-9) {
          EXPECT_EQ(front.deeperThan(v, limit, hint), depth > limit);
          EXPECT_EQ(bare.deeperThan(v, limit, hint), depth > limit);
        }
      if (front.present(v) && depth <= 0.75)
        shallow.insert(static_cast<std::int32_t>(v));
      if (front.present(v) && depth < 1e-10)
        outermost.insert(static_cast<std::int32_t>(v));
    }
    std::vector<std::int32_t> near;
    front.nearSurface(0.75, near);
    const std::set<std::int32_t> found(near.begin(), near.end());
    EXPECT_EQ(near.size(), found.size());
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (front.present(v)) {
        EXPECT_EQ(front.isNearSurface(v, 0.75), found.count(static_cast<std::int32_t>(v)) > 0) << v;
      }
    EXPECT_TRUE(std::includes(shallow.begin(), shallow.end(), found.begin(), found.end()));
    EXPECT_TRUE(std::includes(found.begin(), found.end(), outermost.begin(), outermost.end()));
    EXPECT_GE(found.size(), shallow.size() - shallow.size() / 5);
    for (const std::int32_t v : near)
      if (random() % 2) {
        front.remove(static_cast<std::size_t>(v));
        bare.remove(static_cast<std::size_t>(v));
      }
  }
}

TEST(ConvexFront, KeptFacetsAnswerLikeThoseFromScratch) {
  const VoxelGraph graph = graphOf(test::blobPart(5));
  ConvexFront front(graph);
  for (std::size_t v = 0; v < graph.size(); ++v)
    front.insert(v);
  std::mt19937 random(7);
  std::set<std::int32_t> onFront;
  std::vector<std::int32_t> near, gone;
  for (int round = 0; round < 30 && front.count() > 0; ++round) {
    front.rebuild();
    ConvexFront fresh(graph);
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (front.present(v))
        fresh.insert(v);
    fresh.rebuild();
    EXPECT_EQ(front.facetCount() == 0, fresh.facetCount() == 0);
    std::size_t hint = 0, freshHint = 0;
    for (std::size_t v = 0; v < graph.size(); ++v)
      for (const double depth : {0.0, 0.6})
        ASSERT_EQ(front.deeperThan(v, depth, hint), fresh.deeperThan(v, depth, freshHint))
            << v << " round " << round;

    // Points seen by new facets stay on the front until they are removed.
    front.onNewFacets(near);
    onFront.insert(near.begin(), near.end());
    fresh.nearSurface(0.0, near);
    std::set<std::int32_t> left;
    for (const std::int32_t v : onFront)
      if (front.present(static_cast<std::size_t>(v)))
        left.insert(v);
    EXPECT_EQ(left, std::set<std::int32_t>(near.begin(), near.end()));

    const auto isRemovable = [&](std::size_t v) {
      return left.count(static_cast<std::int32_t>(v)) > 0;
    };
    front.nearRemovable(1.0, isRemovable, near);
    for (const std::int32_t v : left)
      if (random() % 4 == 0)
        front.remove(static_cast<std::size_t>(v));
    front.nearRemoved(1.0, gone);
    for (const std::int32_t v : gone) {
      EXPECT_TRUE(front.present(static_cast<std::size_t>(v)));
      EXPECT_FALSE(front.deeperThan(static_cast<std::size_t>(v), 1.0 + 1e-9, hint));
    }
    // Some return, like restored voxels: inside the front of the next query.
    if (round % 3 == 2) {
      front.rebuild();
      for (const std::int32_t v : near)
        if (front.present(static_cast<std::size_t>(v)) && random() % 2 == 0) {
          front.remove(static_cast<std::size_t>(v));
          front.insert(static_cast<std::size_t>(v));
        }
    }
  }
}

TEST(ConvexFront, ClearNormalHasEverythingBehindIt) {
  const VoxelGraph graph = graphOf(test::conePart());
  ConvexFront front(graph);
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (graph.cell[v][2] < 10)
      front.insert(v);
  front.rebuild();
  for (std::size_t v = 0; v < graph.size(); ++v) {
    if (front.present(v))
      continue;
    const Eigen::Vector3d n = front.clearNormal(v, Eigen::Vector3d::UnitZ());
    EXPECT_NEAR(n.norm(), 1.0, 1e-9);
    for (std::size_t w = 0; w < graph.size(); ++w)
      if (front.present(w)) {
        ASSERT_LE(n.dot(graph.lattice(w) - graph.lattice(v)), 1e-6);
      }
  }
}

TEST(ConvexFront, OfAFlatPartIsThePlanarHull) {
  // One cell deep: a tree whose crown spans its stem's notch.
  const VoxelGraph graph = graphOf(test::voxelPart(21, 1, 16, [](int i, int, int k) {
    return (i >= 8 && i < 13) || (k >= 12 && i >= 2) || (i == 2 && k >= 6);
  }));
  ConvexFront front(graph);
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (graph.cell[v][2] <= 13)
      front.insert(v);
  front.rebuild();
  // The planar hull by all pairs: a point is outside when a line through two points has it alone on
  // one side.
  std::vector<Eigen::Vector2d> points;
  for (const LatticePoint& p : graph.platform)
    points.emplace_back(p.x(), p.z());
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (front.present(v))
      points.emplace_back(graph.lattice(v).x(), graph.lattice(v).z());
  std::size_t hint = 0, inside = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const Eigen::Vector2d q(graph.lattice(v).x(), graph.lattice(v).z());
    bool outside = false;
    for (const Eigen::Vector2d& a : points)
      for (const Eigen::Vector2d& b : points) {
        const Eigen::Vector2d side = b - a;
        const auto orientation = [&](const Eigen::Vector2d& p) {
          return side.x() * (p.y() - a.y()) - side.y() * (p.x() - a.x());
        };
        outside |= side.squaredNorm() > 0.0 && orientation(q) <= 0.0 &&
                   std::all_of(points.begin(), points.end(),
                               [&](const Eigen::Vector2d& p) { return orientation(p) >= 0.0; });
      }
    inside += !outside;
    EXPECT_EQ(front.deeperThan(v, 0.0, hint), !outside) << v;
  }
  EXPECT_GT(inside, 20u);
}

TEST(Flood, LeavesNoPits) {
  const VoxelGraph graph = graphOf(test::blobPart(8));
  std::mt19937 random(2);
  std::vector<float> field(graph.size());
  for (float& f : field)
    f = static_cast<float>(random() % 1000) / 50.0f;
  const std::vector<float> raised = withoutPits(graph, field, 0.15f, kQuiet);
  // Every voxel from a neighbour to another, by faces where they reach it: a plain search for the
  // shortest distances.
  std::vector<float> minimum(graph.size(), std::numeric_limits<float>::infinity());
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (graph.onPlatform[v])
      minimum[v] = std::max(field[v], 0.075f);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t v = 0; v < graph.size(); ++v)
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = graph.neighbour[v][s]; w >= 0) {
          const float by = std::max(field[v], minimum[static_cast<std::size_t>(w)] + 0.15f);
          changed |= by < minimum[v];
          minimum[v] = std::min(minimum[v], by);
        }
  }
  std::size_t byEdge = 0, kept = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    bool carried = graph.onPlatform[v] != 0;
    for (const std::int32_t w : graph.neighbour[v])
      carried |= w >= 0 && raised[static_cast<std::size_t>(w)] <= raised[v] - 0.1499f;
    EXPECT_TRUE(carried) << v;
    EXPECT_GE(raised[v], field[v]);
    kept += raised[v] == field[v];
    if (std::isfinite(minimum[v]))
      EXPECT_EQ(raised[v], minimum[v]) << v;
    else
      ++byEdge;
  }
  EXPECT_GT(kept, 0u);
  EXPECT_LT(kept, graph.size());
  EXPECT_LT(byEdge, graph.size());
}

TEST(Flood, GeodesicDistanceOfABoxIsItsHeight) {
  const VoxelGraph graph = graphOf(test::boxPart(7, 5, 9));
  const std::vector<float> distance = geodesicDistance(graph, {}, kQuiet);
  for (std::size_t v = 0; v < graph.size(); ++v)
    EXPECT_NEAR(distance[v], static_cast<float>(graph.cell[v][2] - 1) + 0.5f, 1e-5f);
}

TEST(Flood, DistanceAlongRanksFollowsNonDecreasingWays) {
  const VoxelGraph graph = graphOf(test::archPart());
  // With sheets of a whole cell this arch is opened beside its crown.
  PeelOptions options;
  options.sheet = 1.0;
  const Peeling peeled = peel(graph, {}, options, kQuiet);
  const std::vector<float> along = geodesicDistance(graph, peeled.rank, kQuiet);
  const std::vector<float> shortest = geodesicDistance(graph, {}, kQuiet);
  bool differ = false;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    EXPECT_GE(along[v], shortest[v] - 1e-4f);
    differ |= along[v] > shortest[v] + 1.0f;
    bool carried = graph.onPlatform[v] != 0;
    for (const std::int32_t w : graph.neighbour[v])
      carried |= w >= 0 && along[static_cast<std::size_t>(w)] < along[v] &&
                 peeled.rank[static_cast<std::size_t>(w)] <= peeled.rank[v];
    EXPECT_TRUE(carried) << v;
  }
  EXPECT_TRUE(differ);
}

TEST(ChamferDistance, EqualsFloodOverTheRemainingVoxels) {
  const VoxelGraph graph = graphOf(test::blobPart(5));
  std::vector<float> value(graph.size(), -7.0f);
  std::vector<std::uint8_t> present(graph.size(), 0);
  std::vector<std::int32_t> among;
  std::mt19937 random(2);
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (random() % 3 != 0) {
      present[v] = 1;
      among.push_back(static_cast<std::int32_t>(v));
    }
  chamferDistance(graph, among, present, value, kQuiet);
  const Flood whole = flood(graph, present, kQuiet);
  for (std::size_t v = 0; v < graph.size(); ++v)
    EXPECT_EQ(value[v], present[v] ? whole.value[v] : -7.0f) << v;
}

TEST(SupportOrder, RerouteKeepsSupportAndChangesNothingElse) {
  const VoxelGraph graph = graphOf(test::blobPart(5));
  std::mt19937 random(9);
  std::vector<std::uint8_t> present(graph.size(), 0);
  for (std::uint8_t& p : present)
    p = random() % 10 < 4;
  SupportOrder support(graph, present, kQuiet);
  std::size_t rerouted = 0, refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const auto v = static_cast<std::size_t>(random() % graph.size());
    if (!present[v])
      continue;
    const auto count = [&] { return std::count(present.begin(), present.end(), 1); };
    std::vector<bool> allowed(graph.size());
    for (std::size_t u = 0; u < graph.size(); ++u)
      allowed[u] = present[u] && support.allows(u);
    present[v] = 0;
    const bool stands =
        static_cast<std::ptrdiff_t>(flood(graph, present, kQuiet).reached) == count();
    ASSERT_EQ(support.reroute(v, graph.size()), stands) << trial;
    if (!stands) {
      ++refused;
      present[v] = 1;
      for (std::size_t u = 0; u < graph.size(); ++u)
        ASSERT_EQ(present[u] && support.allows(u), allowed[u]) << u;
      continue;
    }
    rerouted += !allowed[v];
    support.drop(v);
    for (std::size_t u = 0; u < graph.size(); ++u) {
      if (!present[u] || graph.onPlatform[u])
        continue;
      const auto& beside = graph.neighbour[u];
      ASSERT_TRUE(std::any_of(beside.begin(), beside.end(), [&](std::int32_t w) {
        return w >= 0 && present[static_cast<std::size_t>(w)] &&
               support.later(u, static_cast<std::size_t>(w));
      })) << u;
    }
  }
  EXPECT_GT(rerouted, 5u);
  EXPECT_GT(refused, 5u);
}

TEST(VoxelsByLevel, AreInOrderAndWithoutThoseOfNone) {
  const VoxelsByLevel levels({3, -1, 0, 3, 7, 0, -2});
  ASSERT_EQ(levels.levels(), 3u);
  const auto of = [&](std::size_t n) {
    return std::vector<std::int32_t>(levels.of(n).begin(), levels.of(n).end());
  };
  EXPECT_EQ(of(0), (std::vector<std::int32_t>{2, 5}));
  EXPECT_EQ(of(1), (std::vector<std::int32_t>{0, 3}));
  EXPECT_EQ(of(2), (std::vector<std::int32_t>{4}));
  EXPECT_EQ(VoxelsByLevel({}).levels(), 0u);
  EXPECT_EQ(VoxelsByLevel({-1}).levels(), 0u);
}

TEST(CutVoxels, LossIsTheVolumeConnectedOnlyThroughAVoxel) {
  const VoxelGraph graph = graphOf(test::voxelPart(9, 3, 9, [](int i, int j, int k) {
    // A post, a bridge one voxel thick to a ball.
    return (i < 2 && k < 6) || (j == 1 && k == 4 && i < 6) || (i >= 6 && k >= 3 && k <= 5);
  }));
  const std::vector<std::uint8_t> all(graph.size(), 1);
  std::vector<std::int32_t> among(graph.size());
  std::iota(among.begin(), among.end(), 0);
  CutVoxels cuts(graph);
  cuts.find(std::vector<std::uint8_t>(graph.size(), 0), among); // leaves no traces
  cuts.find(all, among);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    std::vector<std::uint8_t> rest = all;
    rest[v] = 0;
    const Flood reached = flood(graph, rest, kQuiet);
    EXPECT_EQ(static_cast<std::size_t>(cuts.lossWithout(v)), graph.size() - 1 - reached.reached)
        << v;
  }
}

TEST(GridSolver, SolvesTheStatedEquations) {
  const VoxelGraph graph = graphOf(test::blobPart(3));
  std::mt19937 random(4);
  std::vector<float> screen(graph.size()), truth(graph.size()), b(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    screen[v] = static_cast<float>(random() % 100) / 1000.0f;
    truth[v] = static_cast<float>(graph.cell[v][2]) + 0.01f * static_cast<float>(random() % 100);
  }
  for (std::size_t v = 0; v < graph.size(); ++v) {
    b[v] = (screen[v] + (graph.onPlatform[v] ? 2.0f : 0.0f)) * truth[v];
    for (std::size_t s = 0; s < 6; ++s)
      if (const std::int32_t w = graph.neighbour[v][s]; w >= 0)
        b[v] += truth[v] - truth[static_cast<std::size_t>(w)];
  }
  GridSolver solver(graph);
  solver.setScreen(screen);
  std::vector<float> x(graph.size(), 0.0f);
  EXPECT_LE(solver.solve(b, x, 1e-6, 40, kQuiet), 25);
  for (std::size_t v = 0; v < graph.size(); ++v)
    EXPECT_NEAR(x[v], truth[v], 2e-3f);
}

TEST(Platform, FitFollowsTheFootprintOfThePart) {
  const voxel::SolidVoxels part = test::mushroomPart();
  const std::vector<Eigen::Vector2d> fit = platformFit(part, 0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < fit.size(); ++i) {
    const Eigen::Vector2d &a = fit[i], &b = fit[(i + 1) % fit.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  // Stem of radius 3 cells about a cell's centre: an octagon-like hull of a 7 x 7 plus.
  EXPECT_GT(area, 29.0);
  EXPECT_LE(area, 49.0);
  EXPECT_EQ(platformRect(4.0, 2.0).size(), 4u);
  for (const Eigen::Vector2d& p : platformDisc(10.0))
    EXPECT_NEAR(p.norm(), 5.0, 1e-12);
  voxel::SolidVoxels floating = test::voxelPart(3, 3, 5, [](int, int, int k) { return k > 2; });
  EXPECT_THROW(platformFit(floating, 0.0), base::Error);
}

} // namespace
} // namespace voluta::curved
