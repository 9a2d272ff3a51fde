// The sources' growth schemes: small parts by hand, random ones by brute force.
#include "curved/forward_growth.h"

#include "base/error.h"
#include "curved/convex_front.h"
#include "curved/incremental_front.h"
#include "curved/layer_order.h"
#include "curved/peeling_field.h"
#include "curved/plain_growth.h"
#include "curved/platform_polygon.h"
#include "curved/rank_checker.h"
#include "curved/voxel_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace voluta::curved {
namespace {

using test::insideHull;
using test::PlainGrowth;

const base::RunContext kQuiet;
constexpr ForwardScheme kSchemes[] = {ForwardScheme::Greedy, ForwardScheme::Incremental,
                                      ForwardScheme::Adaptive, ForwardScheme::Guided};

VoxelGraph graphOf(const voxel::SolidVoxels& v, double margin = 0.0) {
  return voxelGraph(v.grid, v.solid, v.plateLayer(), platformFit(v, margin));
}

std::size_t missed(const ForwardGrowth& g) {
  return static_cast<std::size_t>(std::count(g.rank.begin(), g.rank.end(), 0));
}

// Rank of the voxel at (i, j, k) as voxelPart counts them.
std::int32_t rankAt(const VoxelGraph& graph, const ForwardGrowth& g, int i, int j, int k) {
  const std::int32_t v = graph.voxelAt[graph.grid.index(i + 1, j + 1, k + 1)];
  return g.rank.at(static_cast<std::size_t>(v));
}

test::RankVerdict judged(const voxel::SolidVoxels& part, const VoxelGraph& graph,
                         const std::vector<std::int32_t>& rank, double margin = 0.0) {
  Decomposition d;
  d.grid = part.grid;
  d.platform = platformFit(part, margin);
  d.rank.assign(part.grid.cellCount(), 0);
  for (std::size_t c = 0; c < d.rank.size(); ++c)
    d.rank[c] = part.solid[c] ? -1 : 0;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (rank[v] > 0)
      d.rank[graph.grid.index(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2])] = rank[v];
  return test::checkRanks(d, part.solid);
}

// Algorithm 1 word for word, with a hull from scratch for each layer.
std::vector<std::int32_t> plainGreedy(const VoxelGraph& graph) {
  std::vector<std::int32_t> rank(graph.size(), 0), layer, next;
  ConvexFront front(graph);
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (graph.onPlatform[v])
      layer.push_back(static_cast<std::int32_t>(v));
  std::size_t hint = 0;
  for (std::int32_t r = 1; !layer.empty(); ++r) {
    for (const std::int32_t v : layer) {
      rank[static_cast<std::size_t>(v)] = r;
      front.insert(static_cast<std::size_t>(v));
    }
    front.rebuild();
    next.clear();
    for (const std::int32_t v : layer)
      for (const std::int32_t w : graph.neighbour[static_cast<std::size_t>(v)])
        if (w >= 0 && rank[static_cast<std::size_t>(w)] == 0 &&
            !front.deeperThan(static_cast<std::size_t>(w), 0.0, hint)) {
          rank[static_cast<std::size_t>(w)] = -1;
          next.push_back(w);
        }
    layer = next;
  }
  return rank;
}

// Two posts of six voxels, ten apart, and an arm along the plate from the first: both posts may
// rise above the arm only once it is complete.
voxel::SolidVoxels armBetweenPosts() {
  return test::voxelPart(11, 1, 6,
                         [](int i, int, int k) { return i == 0 || i == 10 || (k == 1 && i <= 4); });
}

TEST(IncrementalFront, AgreesWithAHullFromScratch) {
  std::mt19937 random(7);
  for (const Boundary boundary : {Boundary::Outside, Boundary::Inside})
    for (int trial = 0; trial < 24; ++trial) {
      // Few values a coordinate give many flat faces and straight edges.
      const unsigned range = trial % 2 ? 4 : 60;
      std::vector<LatticePoint> points;
      for (int i = 0; i < 80; ++i)
        points.emplace_back(random() % range, random() % range, random() % range);
      points.emplace_back(-1, -1, -1);
      points.emplace_back(5, -1, -1);
      points.emplace_back(-1, 5, -1);
      points.emplace_back(-1, -1, 5);
      IncrementalFront front(points, boundary);
      EXPECT_FALSE(front.inside(0));
      front.build({80, 81, 82, 83});
      std::vector<std::int32_t> in{80, 81, 82, 83}, guarded, swallowed;
      std::vector<std::uint8_t> gone(points.size(), 0);
      for (std::int32_t p = 40; p < 80; ++p)
        if (!front.inside(p)) {
          front.guard(p);
          guarded.push_back(p);
        }
      for (std::int32_t p = 0; p < 40; ++p) {
        in.push_back(p);
        std::vector<LatticePoint> corners;
        for (const std::int32_t c : in)
          corners.push_back(points[static_cast<std::size_t>(c)]);
        const std::vector<HullFacet> hull = convexHull(corners);
        std::vector<std::int32_t> expected;
        for (const std::int32_t g : guarded)
          if (!gone[static_cast<std::size_t>(g)] &&
              insideHull(hull, points[static_cast<std::size_t>(g)], boundary))
            expected.push_back(g);
        EXPECT_EQ(front.wouldSwallow(p, 1000), expected.size());
        EXPECT_EQ(front.wouldSwallow(p, 1), std::min<std::size_t>(1, expected.size()));
        swallowed.clear();
        front.add(p, swallowed);
        std::sort(swallowed.begin(), swallowed.end());
        EXPECT_EQ(swallowed, expected);
        for (const std::int32_t g : swallowed)
          gone[static_cast<std::size_t>(g)] = 1;
        for (std::int32_t q = 0; q < 84; ++q)
          ASSERT_EQ(front.inside(q),
                    insideHull(hull, points[static_cast<std::size_t>(q)], boundary));
      }
    }
}

TEST(LayerOrder, FloodsFromTheFirstAndHalvesAlongTheAxis) {
  const VoxelGraph graph = graphOf(test::boxPart(6, 1, 1));
  const std::vector<std::int32_t> layer{3, 0, 5, 1, 4, 2};
  EXPECT_EQ(floodingOrder(graph, layer), (std::vector<std::int32_t>{3, 4, 2, 5, 1, 0}));
  EXPECT_EQ(floodingOrder(graph, {5, 0, 1, 3}), (std::vector<std::int32_t>{5, 0, 1, 3}));
  EXPECT_EQ(halvingOrder(graph, layer), (std::vector<std::int32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(floodingOrder(graph, {}).empty());
  EXPECT_TRUE(halvingOrder(graph, {}).empty());
}

TEST(ForwardGrowth, ABoxGrowsInFlatLayersInAnyScheme) {
  const VoxelGraph graph = graphOf(test::boxPart(7, 5, 6));
  for (const ForwardScheme scheme : kSchemes)
    for (const Boundary boundary : {Boundary::Outside, Boundary::Inside}) {
      ForwardOptions options;
      options.boundary = boundary;
      const ForwardGrowth g = forwardGrowth(graph, scheme, options, kQuiet);
      EXPECT_EQ(g.ranks, 6);
      EXPECT_EQ(g.reduced + g.sacrificed, 0u);
      for (std::size_t v = 0; v < graph.size(); ++v)
        EXPECT_EQ(g.rank[v], graph.cell[v][2]);
      EXPECT_EQ(g.peeling.empty(), scheme != ForwardScheme::Guided);
    }
}

TEST(ForwardGrowth, ATSpreadsFromItsStem) {
  const VoxelGraph graph =
      graphOf(test::voxelPart(5, 1, 4, [](int i, int, int k) { return i == 2 || k == 3; }));
  for (const ForwardScheme scheme :
       {ForwardScheme::Greedy, ForwardScheme::Incremental, ForwardScheme::Adaptive}) {
    const ForwardGrowth g = forwardGrowth(graph, scheme, {}, kQuiet);
    EXPECT_EQ(missed(g), 0u);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(rankAt(graph, g, 2, 0, k), k + 1);
    for (int i = 1; i <= 3; ++i)
      EXPECT_EQ(rankAt(graph, g, i, 0, 3), 4);
    EXPECT_EQ(rankAt(graph, g, 0, 0, 3), 5);
    EXPECT_EQ(rankAt(graph, g, 4, 0, 3), 5);
  }
}

TEST(ForwardGrowth, HookTipPrintsOnlyWithoutPlatformBelowIt) {
  const voxel::SolidVoxels hook = test::voxelPart(11, 1, 7, [](int i, int, int k) {
    return i == 0 || (i <= 4 && k == 6) || (i == 4 && k >= 1);
  });
  const VoxelGraph narrow = graphOf(hook);
  ForwardGrowth g = forwardGrowth(narrow, ForwardScheme::Greedy, {}, kQuiet);
  EXPECT_EQ(missed(g), 0u);
  EXPECT_EQ(rankAt(narrow, g, 3, 0, 6), 9);
  EXPECT_EQ(rankAt(narrow, g, 4, 0, 5), 10);
  EXPECT_EQ(rankAt(narrow, g, 4, 0, 1), 14);
  // With six cells of platform below and beside the tip, the line from the stem's top to the
  // platform's edge passes above its lower part, and from the arm above the rest.
  const VoxelGraph wide = graphOf(hook, 9.5);
  for (const ForwardScheme scheme : kSchemes) {
    g = forwardGrowth(wide, scheme, {}, kQuiet);
    EXPECT_EQ(missed(g), 5u);
    EXPECT_EQ(rankAt(wide, g, 4, 0, 5), 0);
    EXPECT_GT(rankAt(wide, g, 4, 0, 6), 0);
  }
}

TEST(ForwardGrowth, ShadowPreventionWaitsForTheArm) {
  const VoxelGraph graph = graphOf(armBetweenPosts());
  const ForwardGrowth greedy = forwardGrowth(graph, ForwardScheme::Greedy, {}, kQuiet);
  EXPECT_EQ(missed(greedy), 2u); // the arm's end
  EXPECT_EQ(greedy.ranks, 6);
  for (const ForwardScheme scheme : {ForwardScheme::Incremental, ForwardScheme::Adaptive})
    for (const QueueOrder queue : {QueueOrder::Insertion, QueueOrder::Flooding}) {
      ForwardOptions options;
      options.queue = queue;
      const ForwardGrowth g = forwardGrowth(graph, scheme, options, kQuiet);
      EXPECT_EQ(missed(g), 0u);
      EXPECT_EQ(g.reduced, 2u);
      EXPECT_EQ(g.sacrificed, 0u);
      EXPECT_EQ(g.ranks, 8);
      EXPECT_EQ(rankAt(graph, g, 2, 0, 1), 3);
      EXPECT_EQ(rankAt(graph, g, 3, 0, 1), 4);
      EXPECT_EQ(rankAt(graph, g, 4, 0, 1), 5);
      EXPECT_EQ(rankAt(graph, g, 0, 0, 2), 5);
      EXPECT_EQ(rankAt(graph, g, 10, 0, 5), 8);
    }
  const ForwardGrowth guided = forwardGrowth(graph, ForwardScheme::Guided, {}, kQuiet);
  EXPECT_EQ(missed(guided), 0u);
  EXPECT_EQ(guided.peeling, peelingField(graph, kQuiet));
}

TEST(ForwardGrowth, ThresholdLetsALayerShadowThatMany) {
  const VoxelGraph graph = graphOf(armBetweenPosts());
  const auto lost = [&](std::int32_t threshold) {
    ForwardOptions options;
    options.ispThreshold = threshold;
    return missed(forwardGrowth(graph, ForwardScheme::Incremental, options, kQuiet));
  };
  EXPECT_EQ(lost(0), 0u); // fewer than the whole layer would: two, then one
  EXPECT_EQ(lost(1), 0u);
  EXPECT_EQ(lost(2), 1u); // the layer that shadows only the arm's last voxel is accepted
  EXPECT_EQ(lost(3), 2u); // as greedy
}

TEST(ForwardGrowth, BoundaryMayCountAsInside) {
  const VoxelGraph graph = graphOf(armBetweenPosts());
  ForwardOptions options;
  options.boundary = Boundary::Inside;
  const ForwardGrowth greedy = forwardGrowth(graph, ForwardScheme::Greedy, options, kQuiet);
  EXPECT_EQ(missed(greedy), 3u); // the first of them is on the front's flat top
  for (const ForwardScheme scheme : {ForwardScheme::Incremental, ForwardScheme::Adaptive}) {
    const ForwardGrowth g = forwardGrowth(graph, scheme, options, kQuiet);
    EXPECT_EQ(missed(g), 0u);
    EXPECT_EQ(g.ranks, 9);
    EXPECT_EQ(rankAt(graph, g, 10, 0, 1), 5); // waits for the arm from the first layer on
    EXPECT_EQ(rankAt(graph, g, 4, 0, 1), 5);
  }
}

TEST(ForwardGrowth, GreedyIsAlgorithm1) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const VoxelGraph graph = graphOf(test::blobPart(seed));
    EXPECT_EQ(forwardGrowth(graph, ForwardScheme::Greedy, {}, kQuiet).rank, plainGreedy(graph));
  }
  const VoxelGraph arch = graphOf(test::archPart(), 3.0);
  EXPECT_EQ(forwardGrowth(arch, ForwardScheme::Greedy, {}, kQuiet).rank, plainGreedy(arch));
}

TEST(ForwardGrowth, EverySchemeKeepsItsInvariants) {
  std::vector<std::pair<voxel::SolidVoxels, double>> parts;
  parts.emplace_back(
      test::voxelPart(14, 4, 9, [](int i, int, int k) { return k >= 6 || i < 3 || i >= 11; }), 2.0);
  parts.emplace_back(test::voxelPart(15, 3, 11,
                                     [](int i, int, int k) {
                                       return i < 3 || i >= 12 || k >= 8 ||
                                              (i >= 6 && i < 9 && k >= 2);
                                     }),
                     0.0);
  for (const unsigned seed : {9u, 12u, 15u})
    parts.emplace_back(test::blobPart(seed), 6.0);
  std::size_t reduced = 0, sacrificed = 0;
  for (const auto& [part, margin] : parts) {
    const VoxelGraph graph = graphOf(part, margin);
    for (const ForwardScheme scheme : kSchemes)
      for (int variant = 0; variant < 7; ++variant) {
        ForwardOptions options;
        options.queue = variant == 1 ? QueueOrder::Insertion : QueueOrder::Flooding;
        options.boundary = variant == 2 ? Boundary::Inside : Boundary::Outside;
        options.ispThreshold = variant == 3 ? 0 : variant == 4 ? 4 : variant == 5 ? 20 : 1;
        options.sacrifice = variant >= 4 ? Sacrifice::Fewest : Sacrifice::Layer;
        const ForwardGrowth g = forwardGrowth(graph, scheme, options, kQuiet);
        EXPECT_EQ(g.rank, PlainGrowth(graph, scheme, options).rank)
            << graph.size() << " voxels, scheme " << static_cast<int>(scheme) << ", variant "
            << variant;
        reduced += g.reduced;
        sacrificed += g.sacrificed;
      }
  }
  EXPECT_GT(reduced, 100u);
  EXPECT_GT(sacrificed, 10u);
}

TEST(ForwardGrowth, EveryRankKeepsBothConstraints) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const voxel::SolidVoxels part = test::blobPart(seed);
    const double margin = seed % 3 == 0 ? 6.0 : 0.0;
    const VoxelGraph graph = graphOf(part, margin);
    for (const ForwardScheme scheme : kSchemes)
      for (int variant = 0; variant < 5; ++variant) {
        ForwardOptions options;
        options.queue = variant == 1 ? QueueOrder::Insertion : QueueOrder::Flooding;
        options.boundary = variant == 2 ? Boundary::Inside : Boundary::Outside;
        options.ispThreshold = variant == 3 ? 0 : variant == 4 ? 5 : 1;
        options.sacrifice = variant == 4 ? Sacrifice::Fewest : Sacrifice::Layer;
        options.fieldStep = variant == 4 ? 3 : 1;
        const ForwardGrowth g = forwardGrowth(graph, scheme, options, kQuiet);
        const test::RankVerdict verdict = judged(part, graph, g.rank, margin);
        EXPECT_EQ(verdict.unsupported, 0u);
        EXPECT_EQ(verdict.inside, 0u);
        EXPECT_EQ(verdict.wrongCells, 0u);
        EXPECT_EQ(g.ranks, *std::max_element(g.rank.begin(), g.rank.end()));
        for (std::size_t v = 0; v < graph.size(); ++v)
          EXPECT_EQ(g.rank[v] == 1, graph.onPlatform[v] != 0);
      }
  }
}

TEST(ForwardGrowth, ThePeelingFieldBendsTheLayersOfAnArch) {
  const VoxelGraph graph = graphOf(test::archPart());
  EXPECT_GT(missed(forwardGrowth(graph, ForwardScheme::Greedy, {}, kQuiet)), 200u);
  for (const ForwardScheme scheme : {ForwardScheme::Incremental, ForwardScheme::Adaptive}) {
    const ForwardGrowth g = forwardGrowth(graph, scheme, {}, kQuiet);
    EXPECT_EQ(missed(g), 0u);
    EXPECT_GT(g.reduced, 0u);
  }
  const ForwardGrowth guided = forwardGrowth(graph, ForwardScheme::Guided, {}, kQuiet);
  EXPECT_EQ(missed(guided), 0u);
  EXPECT_EQ(guided.reduced, 0u); // nothing to prevent any more
}

TEST(ForwardGrowth, FewestSacrificeLosesLessThanALayer) {
  // A hanging tip between two posts: nothing saves all of it.
  const VoxelGraph graph = graphOf(test::voxelPart(31, 7, 24, [](int i, int, int k) {
    return i < 5 || i >= 26 || k >= 19 || (i >= 13 && i < 18 && k >= 4);
  }));
  ForwardOptions options;
  const ForwardGrowth layer = forwardGrowth(graph, ForwardScheme::Adaptive, options, kQuiet);
  options.sacrifice = Sacrifice::Fewest;
  const ForwardGrowth fewest = forwardGrowth(graph, ForwardScheme::Adaptive, options, kQuiet);
  EXPECT_GT(layer.sacrificed, 0u);
  EXPECT_GT(missed(fewest), 0u);
  EXPECT_LE(missed(fewest), missed(layer));
}

TEST(ForwardGrowth, SameForAnyNumberOfThreads) {
  const VoxelGraph graph = graphOf(test::blobPart(21));
  for (const ForwardScheme scheme : kSchemes) {
    const base::RunContext one(base::CancelToken{}, 1), two(base::CancelToken{}, 2);
    EXPECT_EQ(forwardGrowth(graph, scheme, {}, one).rank,
              forwardGrowth(graph, scheme, {}, two).rank);
  }
}

TEST(ForwardGrowth, StopsWhenCancelledAndReportsForwards) {
  const VoxelGraph graph = graphOf(test::mushroomPart());
  for (const double at : {0.0, 0.05, 0.3, 0.6}) {
    const base::CancelToken token;
    double last = 0.0;
    const base::RunContext ctx(token, 1, [&](double fraction, const voluta::base::Message&) {
      EXPECT_GE(fraction, last - 1e-9);
      last = fraction;
      if (fraction >= at)
        token.cancel();
    });
    EXPECT_THROW(forwardGrowth(graph, ForwardScheme::Guided, {}, ctx), base::Cancelled) << at;
  }
}

TEST(ForwardGrowth, NothingOnThePlatformIsNoGrowth) {
  const voxel::SolidVoxels part = test::boxPart(4, 4, 4);
  const VoxelGraph graph =
      voxelGraph(part.grid, part.solid, part.plateLayer(), platformRect(1.0, 1.0, {50.0, 50.0}));
  for (const ForwardScheme scheme : kSchemes) {
    const ForwardGrowth g = forwardGrowth(graph, scheme, {}, kQuiet);
    EXPECT_EQ(g.ranks, 0);
    EXPECT_EQ(missed(g), graph.size());
  }
}

TEST(ForwardGrowth, RefusesANegativeThreshold) {
  ForwardOptions wrong;
  wrong.ispThreshold = -1;
  EXPECT_THROW(
      forwardGrowth(graphOf(test::boxPart(2, 2, 2)), ForwardScheme::Adaptive, wrong, kQuiet),
      base::Error);
}

TEST(PeelingField, BoxIsPeeledFromTheTop) {
  for (const double margin : {0.0, 20.0}) {
    const VoxelGraph graph = graphOf(test::boxPart(8, 6, 7), margin);
    const std::vector<std::int32_t> field = peelingField(graph, kQuiet);
    for (std::size_t v = 0; v < graph.size(); ++v)
      EXPECT_EQ(field[v], 8 - graph.cell[v][2]);
  }
}

TEST(PeelingField, OctahedronIsPeeledInShells) {
  // |x| + |y| + |z| <= 9 above a platform of one cell: its faces are planes of the lattice, so each
  // sheet above the middle is one shell.
  const VoxelGraph graph = graphOf(test::voxelPart(19, 19, 19, [](int i, int j, int k) {
    return std::abs(i - 9) + std::abs(j - 9) + std::abs(k - 9) <= 9;
  }));
  const std::vector<std::int32_t> field = peelingField(graph, kQuiet);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const auto& c = graph.cell[v];
    if (c[2] >= 10) {
      EXPECT_EQ(field[v], 10 - (std::abs(c[0] - 10) + std::abs(c[1] - 10) + std::abs(c[2] - 10)));
    }
  }
}

TEST(PeelingField, EachSheetIsTheHullBoundaryOfTheRest) {
  const VoxelGraph graph = graphOf(test::blobPart(4), 2.0);
  const std::vector<std::int32_t> field = peelingField(graph, kQuiet);
  const std::int32_t last = *std::max_element(field.begin(), field.end());
  EXPECT_GE(*std::min_element(field.begin(), field.end()), 1);
  for (std::int32_t round = 1; round <= last; ++round) {
    std::vector<LatticePoint> rest = graph.platform;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (field[v] >= round)
        rest.push_back(graph.lattice(v));
    const std::vector<HullFacet> hull = convexHull(rest);
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (field[v] >= round) {
        ASSERT_EQ(field[v] == round, !insideHull(hull, graph.lattice(v), Boundary::Outside));
      }
  }
}

TEST(PeelingField, StopsWhenCancelled) {
  const base::CancelToken token;
  token.cancel();
  EXPECT_THROW(peelingField(graphOf(test::boxPart(3, 3, 3)), base::RunContext(token, 1)),
               base::Cancelled);
}

} // namespace
} // namespace voluta::curved
