// Level surfaces before they are trimmed, and where fields or parts are awkward.
#include "base/error.h"
#include "base/run_context.h"
#include "curved/cell_contour.h"
#include "curved/curved_layers.h"
#include "curved/extraction.h"
#include "geometry/measures.h"
#include "layers/synthetic.h"
#include "layers/vtp_writer.h"
#include "plan/finding_kinds.h"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>
#include <thread>

namespace voluta {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

double heightOf(const Vector3d& p) {
  return p.z();
}

// Counts, without the module's own helpers: edges of more than two triangles, edges run twice the
// same way, and vertices whose boundary edges are neither none nor two.
int topologyFaults(const geometry::TriangleMesh& m) {
  std::map<std::pair<int, int>, int> directed;
  for (const auto& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++directed[{t[k], t[(k + 1) % 3]}];
  int faults = 0;
  std::map<int, int> ends;
  for (const auto& [edge, count] : directed) {
    faults += count > 1;
    if (directed.count({edge.second, edge.first}) == 0) {
      ++ends[edge.first];
      ++ends[edge.second];
    }
  }
  for (const auto& [vertex, count] : ends)
    faults += count != 2;
  return faults;
}

geometry::TriangleMesh together(geometry::TriangleMesh a, const geometry::TriangleMesh& b) {
  const int base = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles)
    a.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  return a;
}

TEST(CubeLoops, UseEachCrossedEdgeOnce) {
  for (int below = 0; below < 256; ++below) {
    std::multiset<int> used;
    for (const auto& loop : curved::cubeLoops(static_cast<std::uint8_t>(below))) {
      EXPECT_GE(loop.size(), 3u);
      used.insert(loop.begin(), loop.end());
    }
    for (int e = 0; e < 12; ++e) {
      const auto edge = curved::cubeEdges()[static_cast<std::size_t>(e)];
      const bool crossed = (below >> edge.from & 1) != (below >> edge.to & 1);
      EXPECT_EQ(used.count(e), crossed ? 1u : 0u) << below;
    }
  }
}

TEST(ExtractLevels, CoverThePartAndFaceAlongTheField) {
  const auto part = test::box({-10, -8, 0}, {10, 8, 12});
  const auto field = [](const Vector3d& p) { return 0.9 * p.z() + 0.3 * p.x() + 3.0; };
  const auto d = test::decompositionOf(part, 0.8, field);
  const auto levels = curved::extractLevels(d, 0.8, {});
  ASSERT_GE(levels.size(), 20u);
  const Vector3d gradient(0.3, 0, 0.9);
  for (const auto& level : levels) {
    if (level.level < 3)
      continue; // the first is put on the plate
    for (std::size_t v = 0; v < level.surface.vertices.size(); ++v) {
      EXPECT_NEAR(field(level.surface.vertices[v]), (level.level + 0.5) * 0.8, 2e-3);
      EXPECT_NEAR(level.direction[v].dot(gradient.normalized()), 1.0, 1e-5);
      if (level.surface.vertices[v].z() > 1.0) {
        EXPECT_NEAR(level.thicknessMm[v], 0.8 / gradient.norm(), 2e-3);
      }
    }
    for (std::size_t t = 0; t < level.surface.triangles.size(); ++t)
      if (geometry::triangleArea(level.surface, t) > 1e-6) {
        EXPECT_GT(geometry::triangleNormal(level.surface, t).dot(gradient), 0.0);
      }
    EXPECT_EQ(topologyFaults(level.surface), 0) << "level " << level.level;
  }
  // Half a voxel beyond the part on every side.
  Eigen::AlignedBox3d box;
  for (const auto& level : levels)
    box.extend(geometry::bounds(level.surface));
  EXPECT_LT(box.min().x(), -10.3);
  EXPECT_GT(box.max().x(), 10.3);
  EXPECT_LT(box.min().y(), -8.3);
  EXPECT_GT(box.max().z(), 12.0);
}

TEST(ExtractLevels, StayManifoldOnRandomFields) {
  const auto part = test::box({-6, -6, 0}, {6, 6, 12});
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> level(0.0, 8.0);
    const auto d = test::decompositionOf(part, 0.8, [&](const Vector3d&) { return level(random); });
    for (const auto& l : curved::extractLevels(d, 0.8, {})) {
      std::map<std::pair<int, int>, int> directed;
      for (const auto& t : l.surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_EQ(++directed[std::make_pair(t[k], t[(k + 1) % 3])], 1);
    }
  }
}

TEST(ExtractLevels, LimbsWithAGapOfAVoxelKeepTheirOwnValues) {
  // Two columns 1 mm apart whose levels differ by 4 mm: shared values would pile levels up in the
  // gap and bend them on both sides.
  const auto left = test::box({-8.4, -4, 0}, {-0.4, 4, 20}),
             right = test::box({0.6, -4, 0}, {8.6, 4, 20});
  const auto part = together(left, right);
  const auto field = [](const Vector3d& p) { return p.x() < 0.1 ? p.z() : p.z() + 4.0; };
  const auto d = test::decompositionOf(part, 0.4, field);
  for (const auto& level : curved::extractLevels(d, 0.8, {})) {
    if (level.level < 7)
      continue;
    for (std::size_t v = 0; v < level.surface.vertices.size(); ++v)
      EXPECT_NEAR(level.direction[v].z(), 1.0, 1e-4);
  }
  const auto result = curved::curvedLayers(d, part, {}, {});
  EXPECT_NEAR(result.volumeMm3 / geometry::volume(part), 1.0, 0.01);
}

// By the slope at a place of a field that hardly rises, the next levels are 100 mm away.
TEST(ExtractLevels, NoLayerIsThickerThanThePartWhereTheFieldIsFlat) {
  constexpr double kHeight = 4.0, kPitch = 0.8;
  const auto part = test::box({-6, -6, 0}, {6, 6, kHeight});
  const auto d = test::decompositionOf(
      part, kPitch, [](const Vector3d& p) { return 2.8 + 0.004 * (p.z() - 2.0); });
  std::size_t vertices = 0;
  for (const auto& level : curved::extractLevels(d, 0.8, {}))
    for (const double thickness : level.thicknessMm) {
      EXPECT_LT(thickness, kHeight + 2.0 * kPitch);
      ++vertices;
    }
  EXPECT_GT(vertices, 0u);
}

TEST(ExtractLevels, RanksAloneMakeLayersToo) {
  const auto part = test::box({-10, -8, 0}, {10, 8, 12});
  auto d = test::decompositionOf(part, 0.8, heightOf);
  d.field.clear();
  const auto result = curved::curvedLayers(d, part, {}, {});
  EXPECT_NEAR(result.volumeMm3 / geometry::volume(part), 1.0, 0.01);
  EXPECT_EQ(result.stack.layerCount, 15);
}

TEST(CurvedLayers, ThicknessFollowsTheField) {
  // phi = r^2 / 20 - 5 about the axis: |grad| = r / 10, so a layer is 8 / r thick.
  const auto part = test::revolved({{10, 0}, {20, 0}, {20, 16}, {10, 16}}, 128, true);
  const auto d = test::decompositionOf(
      part, 0.8, [](const Vector3d& p) { return p.head<2>().squaredNorm() / 20.0 - 5.0; });
  const auto result = curved::curvedLayers(d, part, {0.75, 0.2, 2.0, 1.2, false}, {});
  double worst = 0.0, worstInside = 0.0;
  for (const auto& p : result.stack.patches)
    for (std::size_t v = 0; v < p.surface.vertices.size(); ++v) {
      const double phi = (p.layer + 0.5) * 0.75;
      const double low = std::sqrt(20.0 * (phi + 4.625)), high = std::sqrt(20.0 * (phi + 5.375));
      const double off = std::abs(p.thicknessMm[v] - (high - low)) / (high - low);
      const double z = p.surface.vertices[v].z();
      worst = std::max(worst, off);
      if (low > 11.0 && high < 19.0 && z > 1.0 && z < 15.0)
        worstInside = std::max(worstInside, off);
    }
  EXPECT_LT(worst, 0.07); // the field is only known at voxel centres: the rim is extrapolated
  EXPECT_LT(worstInside, 0.015);
  EXPECT_NEAR(result.volumeMm3 / geometry::volume(part), 1.0, 0.01);
}

TEST(CurvedLayers, FirstLayerIsHalfItsThicknessAboveThePlate) {
  const auto part = test::box({-10, -8, 0}, {10, 8, 12.2});
  const auto d = test::decompositionOf(part, 0.8, [](const Vector3d& p) { return 1.1 * p.z(); });
  const auto result = curved::curvedLayers(d, part, {}, {});
  ASSERT_FALSE(result.stack.patches.empty());
  for (const auto& p : result.stack.patches)
    for (std::size_t v = 0; v < p.surface.vertices.size(); ++v) {
      const double foot = p.surface.vertices[v].z() - 0.5 * p.thicknessMm[v] * p.direction[v].z();
      if (p.layer == 0) {
        EXPECT_NEAR(foot, 0.0, 2e-3);
      }
      EXPECT_GT(foot, -2e-3);
    }
}

TEST(CurvedLayers, SameForAnyNumberOfThreads) {
  const auto part = test::sphere({0, 0, 10}, 10, 32);
  const auto d = test::decompositionOf(
      part, 0.8, [](const Vector3d& p) { return std::max(0.05, p.z() + 0.02 * p.x() * p.x()); });
  const auto one = curved::curvedLayers(d, part, {}, base::RunContext({}, 1));
  const auto two = curved::curvedLayers(d, part, {}, base::RunContext({}, 2));
  EXPECT_EQ(layers::writeLayersVtp(one.stack), layers::writeLayersVtp(two.stack));
}

TEST(CurvedLayers, StopsWhenCancelled) {
  const auto part = test::box({-20, -20, 0}, {20, 20, 20});
  const auto d = test::decompositionOf(part, 0.8, heightOf);
  base::CancelToken token;
  int reports = 0;
  const base::RunContext ctx(token, 1, [&](double, const voluta::base::Message&) {
    if (++reports == 2)
      token.cancel();
  });
  EXPECT_THROW(curved::curvedLayers(d, part, {}, ctx), base::Cancelled);
}

TEST(CurvedLayers, FindsPatchesThatBeginInTheAir) {
  // An overhanging block beside a column, with a field that starts in its middle.
  const auto part =
      together(test::box({-10, -5, 0}, {0, 5, 20}), test::box({5, -5, 8}, {15, 5, 20}));
  const auto d = test::decompositionOf(part, 0.8, heightOf);
  const auto result = curved::curvedLayers(d, part, {}, {});
  EXPECT_EQ(result.unsupportedPatches, 1u);
  ASSERT_EQ(result.findings.size(), 1u);
  EXPECT_EQ(voluta::plan::reportId(result.findings[0]), "unsupportedPatches");
  EXPECT_NEAR(result.findings[0].where->x(), 10.0, 5.0);
  EXPECT_NEAR(result.findings[0].where->z(), 8.4, 0.8);
  std::set<int> groups;
  for (const auto& p : result.stack.patches)
    groups.insert(p.group);
  EXPECT_EQ(groups.size(), 2u);
}

} // namespace
} // namespace voluta
