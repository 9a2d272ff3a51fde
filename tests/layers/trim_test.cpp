// Trimming, cleaning, pieces and order on surfaces made by hand.
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "helpers/flat_square.h"
#include "helpers/shapes.h"
#include "helpers/vtk_array.h"
#include "layers/clean_surface.h"
#include "layers/layer_checks.h"
#include "layers/order.h"
#include "layers/patches.h"
#include "layers/polygon_fill.h"
#include "layers/trim.h"
#include "layers/vtp_writer.h"

#include <gtest/gtest.h>
#include <map>
#include <random>
#include <utility>

namespace voluta::layers {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using test::flatSquare;

geometry::TriangleMesh turned(geometry::TriangleMesh m, double angle) {
  const Eigen::Matrix3d r = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  for (auto& v : m.vertices)
    v = r * v;
  return m;
}

TEST(TrimToPart, CutsABoxAtAnyAngleWithItsCorners) {
  for (double angle : {0.0, 0.1, 0.5, 0.785}) {
    const auto part = turned(test::box({-7.3, -4.1, -5}, {7.3, 4.1, 5}), angle);
    const PartBoundary boundary(part, 0.8, {});
    LevelSurface s = trimToPart(flatSquare(10, 0.7, 0.2), boundary, {}, {});
    EXPECT_NEAR(geometry::area(s.surface), 14.6 * 8.2, 0.03) << angle;
    cleanSurface(s, {}, {});
    EXPECT_NEAR(geometry::area(s.surface), 14.6 * 8.2, 0.05) << angle;
    LayerStack stack;
    for (auto& p : makePatches(s, {}).patches)
      stack.patches.push_back(p);
    ASSERT_EQ(stack.patches.size(), 1u);
    const auto check = checkBoundaries(stack, boundary.query(), 1e-3, {});
    EXPECT_LT(check[0].farthestMm, 1e-4);
    EXPECT_TRUE(check[0].simple);
  }
}

TEST(TrimToPart, FollowsFacesInThePlanesOfTheGrid) {
  // The part's walls run along rows of vertices, where every test is a tie.
  const auto part = test::box({-7, -4.2, -5}, {7, 4.2, 5});
  const PartBoundary boundary(part, 0.8, {});
  const LevelSurface s = trimToPart(flatSquare(9.8, 0.7, 0.2), boundary, {}, {});
  EXPECT_NEAR(geometry::area(s.surface), 14.0 * 8.4, 0.01);
}

TEST(TrimToPart, KeepsSlotsAndWallsThinnerThanATriangle) {
  geometry::TriangleMesh part = test::box({-8, -8, -5}, {-0.15, 8, 5});
  const geometry::TriangleMesh right = test::box({0.15, -8, -5}, {0.45, 8, 5});
  const int base = static_cast<int>(part.vertices.size());
  part.vertices.insert(part.vertices.end(), right.vertices.begin(), right.vertices.end());
  for (const auto& t : right.triangles)
    part.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  const PartBoundary boundary(part, 0.8, {});
  const LevelSurface s = trimToPart(flatSquare(10, 0.83, 0.1), boundary, {}, {});
  EXPECT_NEAR(geometry::area(s.surface), (7.85 + 0.3) * 16, 0.3);
}

// Distance of a point from the nearest boundary edge.
double fromBoundary(const LevelSurface& s, const Vector3d& x) {
  double nearest = 1e300;
  const auto edges = geometry::sortedHalfEdges(s.surface);
  geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
    if (e - b != 1)
      return;
    const Vector3d &p = s.surface.vertices[static_cast<std::size_t>(edges[b].low)],
                   &q = s.surface.vertices[static_cast<std::size_t>(edges[b].high)];
    const double t = std::clamp((x - p).dot(q - p) / (q - p).squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (x - p - t * (q - p)).norm());
  });
  return nearest;
}

TEST(TrimToPart, FindsCornersAtAnyPlaceInTheGrid) {
  // Blocks and fins as wide as a fifth of a triangle, their top 0.03 mm above the level: corners
  // fall inside triangles, poke through their edges by a hair, and no place is far from a facet.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0.0, 0.83), rotation(0.0, 1.57), width(0.12, 2.0);
  for (int n = 0; n < 60; ++n) {
    const double w = width(random), x = place(random), y = place(random);
    const auto part = turned(test::box({x, y, -1}, {x + 4.3, y + w, 0.13}), rotation(random));
    const PartBoundary boundary(part, 0.8, {});
    const LevelSurface s = trimToPart(flatSquare(8, 0.83, 0.1), boundary, {}, {});
    for (const Vector3d& v : part.vertices)
      EXPECT_LT(fromBoundary(s, {v.x(), v.y(), 0.1}), 0.02) << n << ": " << v.transpose();
  }
}

TEST(TrimToPart, LeavesHolesAndCavitiesEmpty) {
  geometry::TriangleMesh part = test::sphere({0, 0, 0}, 9, 48);
  geometry::TriangleMesh hole = test::sphere({1, 0, 0}, 4, 48);
  for (auto& t : hole.triangles)
    std::swap(t[0], t[1]);
  const int base = static_cast<int>(part.vertices.size());
  part.vertices.insert(part.vertices.end(), hole.vertices.begin(), hole.vertices.end());
  for (const auto& t : hole.triangles)
    part.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  const PartBoundary boundary(part, 0.8, {});
  const LevelSurface s = trimToPart(flatSquare(11, 0.7, 0.03), boundary, {}, {});
  EXPECT_NEAR(geometry::area(s.surface) / (base::kPi * (81 - 16)), 1.0, 0.004);
}

TEST(TrimToPart, NothingIsLeftOutside) {
  const auto part = test::box({-1, -1, 10}, {1, 1, 12});
  const PartBoundary boundary(part, 0.8, {});
  EXPECT_TRUE(trimToPart(flatSquare(5, 0.7, 0.0), boundary, {}, {}).surface.empty());
}

TEST(FillPolygon, AreaIsKeptOnRandomStars) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.3, 2.0);
  for (int round = 0; round < 200; ++round) {
    const int n = 3 + round % 10;
    std::vector<Vector2d> star;
    double area = 0.0;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * base::kPi * i / n;
      star.push_back(radius(random) * Vector2d(std::cos(a), std::sin(a)));
    }
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Vector2d &p = star[i], &q = star[(i + 1) % star.size()];
      area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    double filled = 0.0;
    for (const auto& t : fillPolygon(star)) {
      const auto at = [&](int k) {
        return star[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
      };
      const Vector2d u = at(1) - at(0), v = at(2) - at(0);
      const double a = 0.5 * (u.x() * v.y() - u.y() * v.x());
      EXPECT_GE(a, -1e-12);
      filled += a;
    }
    EXPECT_NEAR(filled, area, 1e-9);
  }
}

TEST(MakePatches, SetsSmallPiecesApart) {
  LevelSurface s = flatSquare(5, 0.5, 1.0);
  const LevelSurface sliver = flatSquare(0.4, 0.2, 2.0); // 0.64 mm2: less than a round bead
  const int base = static_cast<int>(s.surface.vertices.size());
  for (std::size_t v = 0; v < sliver.surface.vertices.size(); ++v) {
    s.surface.vertices.push_back(sliver.surface.vertices[v]);
    s.thicknessMm.push_back(0.8);
    s.direction.push_back(Vector3d::UnitZ());
    s.clearDirection.push_back(Vector3d::UnitZ());
  }
  for (const auto& t : sliver.surface.triangles)
    s.surface.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  const PatchesOfLevel patches = makePatches(s, {});
  ASSERT_EQ(patches.patches.size(), 1u);
  EXPECT_NEAR(geometry::area(patches.patches[0].surface), 100.0, 1e-9);
  ASSERT_EQ(patches.slivers.size(), 1u);
  EXPECT_NEAR(geometry::area(patches.slivers[0].surface), 0.64, 1e-9);
}

// A strip's width does not depend on its place and length: from half a bead on it is kept.
TEST(MakePatches, StripsNarrowerThanHalfABeadAreSlivers) {
  for (const double width : {0.4, 0.55, 0.65, 1.0})
    for (const double atX : {-15.0, 40.0}) {
      LevelSurface s;
      for (int i = 0; i <= 120; ++i)
        for (const double y : {0.0, 0.5 * width, width}) {
          s.surface.vertices.emplace_back(atX + 0.25 * i, 3.0 + y, 1.0);
          s.thicknessMm.push_back(0.8);
          s.direction.push_back(Vector3d::UnitZ());
          s.clearDirection.push_back(Vector3d::UnitZ());
        }
      for (int i = 0; i < 120; ++i)
        for (int k = 0; k < 2; ++k) {
          const int a = 3 * i + k;
          s.surface.triangles.push_back({a, a + 3, a + 4});
          s.surface.triangles.push_back({a, a + 4, a + 1});
        }
      const PatchesOfLevel patches = makePatches(s, {1.2});
      EXPECT_EQ(patches.slivers.size(), width < 0.6 ? 1u : 0u) << width;
      EXPECT_EQ(patches.patches.size(), width < 0.6 ? 0u : 1u) << width;
    }
}

// Two holes that meet in a corner, and two squares that do: each boundary continues in one way.
TEST(MakePatches, BoundariesThatTouchInAVertexAreSeparated) {
  for (const bool holes : {true, false}) {
    LevelSurface s = flatSquare(4, 2.0, 1.0);
    std::erase_if(s.surface.triangles, [&](const std::array<int, 3>& t) {
      Vector3d middle = Vector3d::Zero();
      for (const int v : t)
        middle += s.surface.vertices[static_cast<std::size_t>(v)] / 3.0;
      const bool inHole = std::max(std::abs(middle.x()), std::abs(middle.y())) < 2.0 &&
                          middle.x() * middle.y() > 0.0;
      return holes ? inHole : middle.x() * middle.y() < 0.0;
    });
    const PatchesOfLevel patches = makePatches(s, {1.2});
    ASSERT_EQ(patches.patches.size(), holes ? 1u : 2u);
    EXPECT_TRUE(patches.slivers.empty());
    double area = 0.0;
    std::size_t doubled = 0;
    for (const Patch& p : patches.patches) {
      area += geometry::area(p.surface);
      ASSERT_EQ(p.thicknessMm.size(), p.surface.vertices.size());
      ASSERT_EQ(p.direction.size(), p.surface.vertices.size());
      std::map<std::pair<int, int>, int> edges; // from, to
      for (const auto& t : p.surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
          ++edges[{t[k], t[(k + 1) % 3]}];
      std::map<int, int> out;
      for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        if (!edges.contains({edge.second, edge.first}))
          ++out[edge.first];
      }
      for (const auto& [vertex, count] : out)
        EXPECT_EQ(count, 1) << vertex;
      for (const Vector3d& v : p.surface.vertices)
        doubled += v.head<2>().norm() < 1e-9 ? 1 : 0;
    }
    EXPECT_NEAR(area, holes ? 64.0 - 8.0 : 32.0, 1e-9);
    EXPECT_EQ(doubled, 2u) << "the vertex in the middle";
  }
}

TEST(OrderForPrinting, LayersFirstThenShortWays) {
  LayerStack stack;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-50, 50);
  for (int n = 0; n < 60; ++n) {
    Patch p;
    p.surface = flatSquare(1, 1, n % 4).surface;
    const double x = place(random);
    for (auto& v : p.surface.vertices)
      v.x() += x;
    p.layer = n % 4;
    stack.patches.push_back(p);
  }
  const auto travel = [](const LayerStack& s) {
    double distance = 0.0;
    for (std::size_t p = 1; p < s.patches.size(); ++p)
      distance += (s.patches[p].surface.vertices[0] - s.patches[p - 1].surface.vertices[0]).norm();
    return distance;
  };
  const double before = travel(stack);
  orderForPrinting(stack);
  EXPECT_EQ(stack.layerCount, 4);
  for (std::size_t p = 1; p < stack.patches.size(); ++p)
    EXPECT_LE(stack.patches[p - 1].layer, stack.patches[p].layer);
  EXPECT_LT(travel(stack), 0.3 * before);
}

TEST(LayerStatistics, AreaTimesMeanIsTheVolume) {
  LayerStack stack;
  stack.layerCount = 2;
  for (double t : {0.5, 0.9}) {
    Patch p;
    p.surface = flatSquare(5, 0.5, 1.0).surface;
    p.thicknessMm.assign(p.surface.vertices.size(), t);
    stack.patches.push_back(p);
  }
  const plan::LayerStatistics s = layerStatistics(stack);
  EXPECT_NEAR(s.areaMm2, 200.0, 1e-9);
  EXPECT_NEAR(s.volumeMm3(), 140.0, 1e-9);
  EXPECT_NEAR(s.thicknessStdMm, 0.2, 1e-9);
  EXPECT_NEAR(s.thicknessP01Mm, 0.5, 1e-9);
  EXPECT_NEAR(s.thicknessP99Mm, 0.9, 1e-9);
}

TEST(VtpWriter, DeclaresItsArraysAndCounts) {
  LayerStack stack;
  Patch p;
  p.surface = flatSquare(1, 1, 0.4).surface;
  p.thicknessMm.assign(p.surface.vertices.size(), 0.8);
  p.direction.assign(p.surface.vertices.size(), Vector3d::UnitZ());
  stack.patches.push_back(p);
  const std::string xml = writeLayersVtp(stack);
  EXPECT_NE(xml.find("NumberOfPoints=\"9\" NumberOfPolys=\"8\""), std::string::npos);
  for (const char* name : {"thickness", "direction", "layer", "group", "connectivity", "offsets"})
    EXPECT_NE(xml.find("Name=\"" + std::string(name) + "\""), std::string::npos) << name;
  EXPECT_EQ(test::vtkArray<float>(xml, "thickness"), std::vector<float>(9, 0.8f));
}

// One piece after the other: point numbers continue, and each triangle has the numbers of its
// patch.
TEST(VtpWriter, HoldsEveryPatchWithItsOwnPointsAndMarks) {
  LayerStack stack;
  for (int k = 0; k < 3; ++k) {
    Patch p;
    const double z = 0.4 + 0.75 * k;
    p.surface.vertices = {{0, 0, z}, {2, 0, z}, {2, 1, z + 0.25}, {0, 1, z + 0.5}};
    p.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
    if (k == 1) { // of another size
      p.surface.vertices.push_back({1, 2, z});
      p.surface.triangles.push_back({3, 2, 4});
    }
    for (std::size_t v = 0; v < p.surface.vertices.size(); ++v) {
      p.thicknessMm.push_back(0.5 + 0.125 * static_cast<double>(v) + k);
      p.direction.push_back(Vector3d(0, v % 2 ? 0.6 : -0.6, 0.8));
    }
    p.layer = 2 * k;
    p.group = k == 2 ? kSupportGroup : 5 + k;
    stack.patches.push_back(p);
  }
  const std::string xml = writeLayersVtp(stack);
  EXPECT_NE(xml.find("NumberOfPoints=\"13\" NumberOfPolys=\"7\""), std::string::npos);

  const auto points = test::vtkArray<float>(xml, "Points");
  const auto direction = test::vtkArray<float>(xml, "direction");
  const auto thickness = test::vtkArray<float>(xml, "thickness");
  const auto corners = test::vtkArray<std::int32_t>(xml, "connectivity");
  const auto offsets = test::vtkArray<std::int32_t>(xml, "offsets");
  const auto layer = test::vtkArray<std::int32_t>(xml, "layer");
  const auto group = test::vtkArray<std::int32_t>(xml, "group");
  const auto patch = test::vtkArray<std::int32_t>(xml, "patch");
  ASSERT_EQ(points.size(), 39u);
  ASSERT_EQ(direction.size(), 39u);
  ASSERT_EQ(thickness.size(), 13u);
  ASSERT_EQ(corners.size(), 21u);
  ASSERT_EQ(offsets.size(), 7u);
  ASSERT_EQ(layer.size(), 7u);
  ASSERT_EQ(group.size(), 7u);
  ASSERT_EQ(patch.size(), 7u);
  std::size_t triangle = 0;
  for (std::size_t k = 0; k < stack.patches.size(); ++k) {
    const Patch& p = stack.patches[k];
    for (const auto& t : p.surface.triangles) {
      EXPECT_EQ(offsets[triangle], static_cast<int>(3 * triangle + 3));
      EXPECT_EQ(layer[triangle], p.layer);
      EXPECT_EQ(group[triangle], p.group);
      EXPECT_EQ(patch[triangle], static_cast<int>(k));
      for (std::size_t c = 0; c < 3; ++c) {
        const auto v = static_cast<std::size_t>(t[c]);
        const auto at = static_cast<std::size_t>(corners[3 * triangle + c]);
        EXPECT_EQ(thickness[at], static_cast<float>(p.thicknessMm[v]));
        for (int axis = 0; axis < 3; ++axis) {
          const std::size_t i = 3 * at + static_cast<std::size_t>(axis);
          EXPECT_EQ(points[i], static_cast<float>(p.surface.vertices[v][axis]));
          EXPECT_EQ(direction[i], static_cast<float>(p.direction[v][axis]));
        }
      }
      ++triangle;
    }
  }
}

} // namespace
} // namespace voluta::layers
