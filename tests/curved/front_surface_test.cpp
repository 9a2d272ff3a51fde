// The drawn front against the definition: a closed convex surface about all printed voxels.
#include "curved/front_surface.h"

#include "base/error.h"
#include "curved/convex_front.h"
#include "curved/grow.h"
#include "curved/peeling_field.h"
#include "curved/platform_polygon.h"
#include "curved/voxel_shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace voluta::curved {
namespace {

const base::RunContext kQuiet;

// Ranks by height above the plate and across: fronts that lean.
Decomposition rankedBy(const voxel::SolidVoxels& v, int across) {
  Decomposition d;
  d.grid = v.grid;
  d.platform = platformFit(v, 1.3);
  d.rank.assign(v.grid.cellCount(), 0);
  int first = 1 << 20;
  for (std::size_t c = 0; c < d.rank.size(); ++c)
    if (v.solid[c]) {
      const Eigen::Vector3i cell = v.grid.cell(c);
      d.rank[c] = cell.z() + cell.x() / across;
      first = std::min(first, d.rank[c]);
    }
  for (std::int32_t& rank : d.rank)
    if (rank > 0)
      rank -= first - 1;
  return d;
}

// In cells: how far the point is in front of the facet that it is farthest in front of.
double outside(const geometry::TriangleMesh& surface, const Eigen::Vector3d& point, double pitch) {
  double maximum = -1e9;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Eigen::Vector3d a = surface.corner(t, 0);
    const Eigen::Vector3d n =
        (surface.corner(t, 1) - a).cross(surface.corner(t, 2) - a).normalized();
    maximum = std::max(maximum, n.dot(point - a) / pitch);
  }
  return maximum;
}

void expectFront(const Decomposition& d, std::int32_t rank) {
  const geometry::TriangleMesh front = frontSurface(d, rank);
  ASSERT_FALSE(front.empty());
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : front.triangles)
    for (std::size_t s = 0; s < 3; ++s)
      ++sides[{t[s], t[(s + 1) % 3]}];
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(sides.count({side.second, side.first}), 1u);
  }
  // No printed voxel is outside; every corner is the centre of a printed voxel or a corner of the
  // platform.
  std::set<std::array<long, 3>> centres;
  for (std::size_t c = 0; c < d.rank.size(); ++c)
    if (d.rank[c] > 0 && d.rank[c] <= rank) {
      const Eigen::Vector3i cell = d.grid.cell(c);
      const Eigen::Vector3d centre = d.grid.centre(cell.x(), cell.y(), cell.z());
      EXPECT_LT(outside(front, centre, d.grid.pitch), 1e-9);
      const Eigen::Vector3d key = (centre / d.grid.pitch * 64.0).array().round();
      centres.insert({std::lround(key.x()), std::lround(key.y()), std::lround(key.z())});
    }
  for (const Eigen::Vector3d& v : front.vertices) {
    EXPECT_LT(outside(front, v, d.grid.pitch), 1e-9);
    if (v.z() > 1e-9) {
      const Eigen::Vector3d key = (v / d.grid.pitch * 64.0).array().round();
      EXPECT_EQ(centres.count({std::lround(key.x()), std::lround(key.y()), std::lround(key.z())}),
                1u);
      continue;
    }
    double nearest = 1e9;
    for (const Eigen::Vector2d& corner : d.platform)
      nearest = std::min(nearest, (corner - v.head<2>()).norm() / d.grid.pitch);
    EXPECT_LT(nearest, 0.05);
  }
}

TEST(FrontSurface, EnclosesExactlyThePrintedVoxels) {
  for (const auto& part :
       {test::mushroomPart(), test::archPart(), test::conePart(), test::boxPart(4, 3, 5, 0.7)}) {
    const Decomposition d = rankedBy(part, 3);
    const std::int32_t last = *std::max_element(d.rank.begin(), d.rank.end());
    for (std::int32_t rank = 1; rank <= last; rank += std::max(1, last / 5))
      expectFront(d, rank);
  }
}

TEST(FrontSurface, IsTheFrontThatGrowthTests) {
  const voxel::SolidVoxels part = test::mushroomPart();
  const Decomposition d = rankedBy(part, 2);
  const VoxelGraph graph = voxelGraph(part.grid, part.solid, part.plateLayer(), d.platform);
  ConvexFront front(graph);
  for (std::int32_t rank = 1; rank <= 20; rank += 3) {
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (d.rank[d.grid.index(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2])] <= rank)
        front.insert(v);
    front.rebuild();
    const geometry::TriangleMesh surface = frontSurface(d, rank);
    for (std::size_t v = 0; v < graph.size(); ++v) {
      const auto [i, j, k] = graph.cell[v];
      EXPECT_NEAR(-outside(surface, d.grid.centre(i, j, k), d.grid.pitch), front.depth(v), 1e-6);
    }
  }
}

TEST(FrontSurface, IsEmptyBeforeTheFirstStepAndRefusesHalfADecomposition) {
  Decomposition d = rankedBy(test::boxPart(3, 3, 3), 3);
  EXPECT_TRUE(frontSurface(d, 0).empty());
  d.rank.pop_back();
  EXPECT_THROW(frontSurface(d, 1), base::Error);
}

TEST(PeelingField, OfADecompositionLeavesSupportOut) {
  Decomposition d = rankedBy(test::boxPart(7, 7, 7), 3);
  d.support.assign(d.rank.size(), 0);
  const std::size_t post = d.grid.index(1, 1, 1), missed = d.grid.index(4, 4, 4);
  d.support[post] = 1;
  d.rank[missed] = -1;
  const std::vector<std::int32_t> peeled = peelingField(d, kQuiet);
  EXPECT_EQ(peeled[post], 0);
  EXPECT_GT(peeled[missed], 1) << "in the heart";
  EXPECT_EQ(peeled[d.grid.index(4, 4, 7)], 1) << "on top";
  for (std::size_t c = 0; c < peeled.size(); ++c)
    EXPECT_EQ(peeled[c] == 0, d.rank[c] == 0 || c == post);
}

} // namespace
} // namespace voluta::curved
