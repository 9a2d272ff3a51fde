// Slicing: sections and layers of parts whose measures are known.
#include "plan/finding_kinds.h"
#include "planar/slicing/slicing.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "helpers/models.h"
#include "helpers/shapes.h"
#include "planar/flat.h"
#include "planar/slicing/region_mesh.h"
#include "planar/slicing/user_planes.h"
#include "sliced_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

// A cone as a pyramid of n sides on z = 0.
TriangleMesh cone(double radius, double height, int n) {
  TriangleMesh m;
  m.vertices = {{0, 0, 0}, {0, 0, height}};
  for (int i = 0; i < n; ++i) {
    const double a = 2.0 * base::kPi * i / n;
    m.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.0);
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 + i, b = 2 + (i + 1) % n;
    m.triangles.push_back({a, b, 1});
    m.triangles.push_back({b, a, 0});
  }
  return m;
}

// A torus about z, its middle at height `centre`.
TriangleMesh torus(double ring, double tube, double centre, int n, int k) {
  TriangleMesh m;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < k; ++j) {
      const double a = 2.0 * base::kPi * i / n, b = 2.0 * base::kPi * j / k;
      const double r = ring + tube * std::cos(b);
      m.vertices.emplace_back(r * std::cos(a), r * std::sin(a), centre + tube * std::sin(b));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < k; ++j) {
      const int a = i * k + j, b = (i + 1) % n * k + j, c = (i + 1) % n * k + (j + 1) % k,
                d = i * k + (j + 1) % k;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return m;
}

double areaOf(const layers::LayerStack& stack, int layer) {
  double sum = 0.0;
  for (const layers::Patch& p : stack.patches)
    if (p.layer == layer)
      sum += geometry::area(p.surface);
  return sum;
}

// Boundary vertices are on the mesh, inner ones inside it; triangles face the nozzle.
void expectWithin(const SliceResult& sliced, const std::vector<Piece>& pieces) {
  std::vector<geometry::MeshQuery> query;
  for (const Piece& piece : pieces)
    query.emplace_back(piece.solid.mesh);
  double farthest = 0.0;
  for (const layers::Patch& patch : sliced.stack.patches) {
    const auto& solid = query[static_cast<std::size_t>(patch.group)];
    for (const Vector3d& v : patch.surface.vertices)
      farthest = std::max(farthest, solid.inside(v) ? 0.0 : solid.closest(v).distance);
    for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
      const Vector3d middle =
          (patch.surface.corner(t, 0) + patch.surface.corner(t, 1) + patch.surface.corner(t, 2)) /
          3.0;
      farthest = std::max(farthest, solid.inside(middle) ? 0.0 : solid.closest(middle).distance);
      // Level, except where it is thicker to absorb slivers over it.
      EXPECT_GT(geometry::triangleNormal(patch.surface, t).dot(patch.direction.front()), 0.99);
    }
  }
  EXPECT_LT(farthest, 2.1e-3);
  const auto query0 = layers::checkBoundaries(
      sliced.stack, geometry::MeshQuery(pieces.front().solid.mesh), 1e-6, {});
  for (const layers::BoundaryCheck& check : query0)
    EXPECT_TRUE(check.simple);
}

TEST(Section, OfABoxIsItsRectangle) {
  const TriangleMesh box = test::box({0, 0, 0}, {4, 5, 6});
  const Sections across(box, Vector3d::UnitZ());
  EXPECT_NEAR(areaOf(across.at(2.5)), 20.0, 1e-12);
  EXPECT_TRUE(across.at(-0.1).empty());
  EXPECT_TRUE(across.at(6.1).empty());
  // Faces on the plane count as above it.
  EXPECT_NEAR(areaOf(across.at(6.0)), 20.0, 1e-12);
  EXPECT_NEAR(areaOf(across.at(0.0)), 0.0, 1e-12);
  const Sections slanted(box, Vector3d(1, 0, 1).normalized());
  EXPECT_NEAR(areaOf(slanted.at(5.0 / std::sqrt(2.0))), 4.0 * std::sqrt(2.0) * 5.0, 1e-9);
}

TEST(Section, HolesCountAsNothing) {
  TriangleMesh hollow = test::box({0, 0, 0}, {10, 10, 10});
  test::append(hollow, test::box({2, 2, 2}, {8, 8, 8}), true);
  const Sections across(hollow, Vector3d::UnitZ());
  EXPECT_NEAR(areaOf(across.at(5.0)), 100.0 - 36.0, 1e-12);
  const layers::LevelSurface s = sectionSurface(across.at(5.0), 1.0, {});
  EXPECT_NEAR(geometry::area(s.surface), 64.0, 1e-9);
}

TEST(Section, OfATorusIsTwoRings) {
  const TriangleMesh ring = torus(20.0, 6.0, 6.0, 96, 48);
  const Section level = Sections(ring, Vector3d::UnitZ()).at(6.3);
  const double half = std::sqrt(36.0 - 0.09);
  EXPECT_NEAR(areaOf(level), base::kPi * 4.0 * 20.0 * half, 0.01 * areaOf(level));
  const Section upright = Sections(ring, Vector3d::UnitX()).at(0.1);
  EXPECT_NEAR(areaOf(upright), 2.0 * base::kPi * 36.0, 0.02 * areaOf(upright));
  const layers::LevelSurface s = sectionSurface(upright, 1.0, {});
  EXPECT_EQ(geometry::components(s.surface).count, 2);
}

TEST(RegionMesh, TrianglesAreOfOneSizeAndWellShaped) {
  const std::vector<Eigen::Vector2d> square{{0, 0}, {20, 0}, {20, 15}, {0, 15}};
  const auto mesh = meshRegion(square, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 1.0);
  ASSERT_TRUE(mesh);
  double area = 0.0, longest = 0.0, minimum = 1.0;
  for (const auto& t : mesh->triangles) {
    const auto corner = [&](std::size_t k) {
      return mesh->points[static_cast<std::size_t>(t[k % 3])];
    };
    double sides = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, (corner(k + 1) - corner(k)).norm());
      sides += (corner(k + 1) - corner(k)).squaredNorm();
    }
    const Eigen::Vector2d a = corner(1) - corner(0), b = corner(2) - corner(0);
    const double twice = a.x() * b.y() - a.y() * b.x();
    EXPECT_GT(twice, 0.0);
    area += 0.5 * twice;
    minimum = std::min(minimum, 2.0 * std::sqrt(3.0) * twice / sides);
  }
  EXPECT_NEAR(area, 300.0, 1e-9);
  EXPECT_LT(longest, 1.8);
  EXPECT_GT(minimum, 0.4);
}

TEST(RegionMesh, CrossingEdgesGiveNothing) {
  const std::vector<Eigen::Vector2d> bow{{0, 0}, {10, 10}, {10, 0}, {0, 10}};
  EXPECT_FALSE(meshRegion(bow, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, 1.0));
}

TEST(LayerBounds, AFlatTopGetsAWholeNumberOfLayers) {
  for (const double height : {8.0, 8.3, 7.7, 1.2, 1.7, 0.3, 1.0005, 2.0007}) {
    const std::vector<double> bounds =
        layerBounds(pieceOf(test::box({0, 0, 0}, {20, 20, height})), {});
    EXPECT_EQ(bounds.front(), 0.0);
    EXPECT_EQ(bounds.back(), height);
    for (std::size_t k = 1; k < bounds.size(); ++k) {
      const double h = bounds[k] - bounds[k - 1];
      EXPECT_NEAR(h, bounds[1], 1e-9);
      EXPECT_LE(h, 1.0 + 1e-9);
      EXPECT_GE(h, std::min(height, 0.4) - 1e-9);
    }
  }
}

TEST(LayerBounds, ShelvesAndCeilingsAreBetweenLayers) {
  // A step at 5.2, a ceiling at 8.9, the top at 12.3.
  const TriangleMesh step = prism(
      {{0, 0}, {30, 0}, {30, 5.2}, {12, 5.2}, {12, 8.9}, {20, 8.9}, {20, 12.3}, {0, 12.3}}, 20.0);
  const std::vector<double> bounds = layerBounds(pieceOf(step), {});
  for (const double level : {5.2, 8.9, 12.3})
    EXPECT_TRUE(std::any_of(bounds.begin(), bounds.end(), [&](double z) {
      return std::abs(z - level) < 1e-9;
    })) << level;
  for (std::size_t k = 1; k < bounds.size(); ++k) {
    EXPECT_LE(bounds[k] - bounds[k - 1], 1.0 + 1e-9);
    EXPECT_GE(bounds[k] - bounds[k - 1], 0.4 - 1e-9);
  }
  // All of the part is printed, which sections across steps miss.
  const SliceResult sliced = slicePieces({pieceOf(step)}, {}, {});
  EXPECT_NEAR(volumeOf(sliced), 20.0 * (30.0 * 5.2 + 12.0 * 3.7 + 20.0 * 3.4), 1e-3);
}

TEST(LayerBounds, OfShelvesCloserThanALayerTheLargerCounts) {
  const TriangleMesh steps = prism(
      {{0, 0}, {30, 0}, {30, 5.2}, {24, 5.2}, {24, 5.45}, {10, 5.45}, {10, 9.1}, {0, 9.1}}, 20.0);
  const std::vector<double> bounds = layerBounds(pieceOf(steps), {});
  const auto nearest = [&](double level) {
    double minimum = 1e9;
    for (const double z : bounds)
      minimum = std::min(minimum, std::abs(z - level));
    return minimum;
  };
  EXPECT_LT(nearest(5.45), 1e-9);
  EXPECT_GT(nearest(5.2), 0.2);
  EXPECT_LT(nearest(9.1), 1e-9);
}

TEST(LayerBounds, WithoutLevelFacesTheLastLayerTakesTheRest) {
  for (const double height : {10.0, 10.1, 10.3, 10.5, 10.7}) {
    const std::vector<double> bounds = layerBounds(pieceOf(cone(8.0, height, 32)), {});
    EXPECT_EQ(bounds.back(), height);
    EXPECT_NEAR(bounds[1], 0.8, 1e-12);
    for (std::size_t k = 1; k < bounds.size(); ++k) {
      EXPECT_LE(bounds[k] - bounds[k - 1], 1.0 + 1e-9);
      EXPECT_GE(bounds[k] - bounds[k - 1], 0.4 - 1e-9);
    }
  }
}

TEST(LayerBounds, AFirstLayerOfItsOwnHeightComesFirst) {
  HeightOptions options;
  options.firstMm = 0.5;
  for (const bool adaptive : {false, true})
    for (const double height : {0.95, 1.2, 3.0, 8.0, 8.3, 10.7}) {
      options.adaptive = adaptive;
      for (const Piece& piece :
           {pieceOf(test::box({0, 0, 0}, {20, 20, height})), pieceOf(cone(8.0, height, 32))}) {
        const std::vector<double> bounds = layerBounds(piece, options);
        EXPECT_EQ(bounds.front(), 0.0);
        EXPECT_EQ(bounds[1], 0.5) << height;
        EXPECT_EQ(bounds.back(), height);
        for (std::size_t k = 1; k < bounds.size(); ++k) {
          EXPECT_LE(bounds[k] - bounds[k - 1], 1.0 + 1e-9);
          EXPECT_GE(bounds[k] - bounds[k - 1], 0.4 - 1e-9);
        }
      }
    }
  // Too low for a second layer.
  const std::vector<double> low =
      layerBounds(pieceOf(test::box({0, 0, 0}, {20, 20, 0.8})), options);
  EXPECT_EQ(low, (std::vector<double>{0.0, 0.8}));
  // A shelf above it is still between layers.
  const TriangleMesh step =
      prism({{0, 0}, {20, 0}, {20, 3.3}, {10, 3.3}, {10, 9.0}, {0, 9.0}}, 20.0);
  options.adaptive = false;
  const std::vector<double> stepped = layerBounds(pieceOf(step), options);
  EXPECT_EQ(stepped[1], 0.5);
  EXPECT_TRUE(std::ranges::any_of(stepped, [](double z) { return std::abs(z - 3.3) < 1e-9; }));
}

TEST(LayerBounds, AdaptiveLayersAreThinWhereTheSurfaceLeans) {
  HeightOptions options;
  options.adaptive = true;
  options.cuspMm = 0.5;
  // Upright to z = 10, then a slope of 60 degrees against the upright.
  const double rise = 10.0 * std::tan(base::kPi / 6.0);
  const TriangleMesh roof = prism({{-10, 0}, {10, 0}, {10, 10}, {0, 10 + rise}, {-10, 10}}, 20.0);
  const std::vector<double> bounds = layerBounds(pieceOf(roof), options);
  const double cosine = std::cos(base::kPi / 6.0);
  for (std::size_t k = 1; k + 2 < bounds.size(); ++k) {
    const double h = bounds[k] - bounds[k - 1];
    EXPECT_GE(h, 0.4 - 1e-9);
    if (bounds[k] <= 10.0 + 1e-9 || bounds[k - 1] > 10.0) {
      EXPECT_NEAR(h, bounds[k] <= 10.0 + 1e-9 ? 1.0 : 0.5 / cosine, 1e-9) << bounds[k];
    }
  }
  EXPECT_EQ(bounds.back(), 10.0 + rise);
  // A step of 3.3 mm: a boundary is on it.
  const TriangleMesh step =
      prism({{0, 0}, {20, 0}, {20, 3.3}, {10, 3.3}, {10, 9.0}, {0, 9.0}}, 20.0);
  const std::vector<double> stepped = layerBounds(pieceOf(step), options);
  EXPECT_TRUE(std::any_of(stepped.begin(), stepped.end(),
                          [](double z) { return std::abs(z - 3.3) < 1e-9; }));
}

TEST(Slicing, LayersOfAConeAreItsSections) {
  const double radius = 15.0, height = 12.0;
  const int n = 64;
  const std::vector<Piece> pieces{pieceOf(cone(radius, height, n))};
  const SliceResult sliced = slicePieces(pieces, {}, {});
  const double base = 0.5 * n * std::sin(2.0 * base::kPi / n) * radius * radius;
  const std::vector<double> bounds = layerBounds(pieces.front(), {});
  for (int k = 0; k < sliced.stack.layerCount; ++k) {
    const double middle =
        0.5 * (bounds[static_cast<std::size_t>(k)] + bounds[static_cast<std::size_t>(k) + 1]);
    const double share = 1.0 - middle / height;
    EXPECT_NEAR(areaOf(sliced.stack, k), base * share * share, 1e-3 * base) << k;
  }
  EXPECT_NEAR(volumeOf(sliced) + sliced.sliverVolumeMm3, base * height / 3.0,
              0.01 * base * height / 3.0);
  EXPECT_EQ(sliced.unsupportedPatches, 0u);
  expectWithin(sliced, pieces);
}

TEST(Slicing, AWedgeOnItsSide) {
  const std::vector<Piece> pieces{pieceOf(prism({{0, 0}, {30, 0}, {0, 12}}, 10.0))};
  const SliceResult sliced = slicePieces(pieces, {}, {});
  EXPECT_NEAR(volumeOf(sliced), 1800.0, 18.0);
  expectWithin(sliced, pieces);
}

TEST(Slicing, APieceAlongItsOwnBase) {
  // An inclined bar on a plane of its own.
  Piece bar = pieceOf(test::box({0, 0, 0}, {6, 6, 20}));
  const Eigen::AngleAxisd rotation(0.7, Vector3d(1, 2, 0).normalized());
  for (Vector3d& v : bar.solid.mesh.vertices)
    v = rotation * v + Vector3d(3, 4, 30);
  bar.base.normal = rotation * Vector3d::UnitZ();
  bar.base.offsetMm = bar.base.normal.dot(Vector3d(3, 4, 30));
  const std::vector<Piece> pieces{pieceOf(test::box({-20, -20, 0}, {20, 20, 4})), bar};
  const SliceResult sliced = slicePieces(pieces, {}, {});
  EXPECT_EQ(sliced.layersOfPiece, (std::vector<int>{5, 25}));
  EXPECT_EQ(sliced.stack.layerCount, 30);
  EXPECT_NEAR(sliced.volumeOfPiece[1], 720.0, 1e-6);
  for (const layers::Patch& patch : sliced.stack.patches) {
    EXPECT_EQ(patch.group, patch.layer < 5 ? 0 : 1);
    EXPECT_NEAR(geometry::area(patch.surface), patch.group == 0 ? 1600.0 : 36.0, 1e-6);
    for (const Vector3d& d : patch.direction)
      EXPECT_TRUE(d.isApprox(patch.group == 0 ? Vector3d::UnitZ() : bar.base.normal));
  }
  // It is unsupported where it is.
  EXPECT_EQ(sliced.unsupportedPatches, 1u);
  ASSERT_FALSE(sliced.findings.empty());
  EXPECT_EQ(plan::reportId(sliced.findings.back()), "beginsInAir");
}

TEST(Slicing, WallsTooNarrowForABeadGiveAFinding) {
  TriangleMesh fin = test::box({-10, -10, 0}, {10, 10, 8});
  test::append(fin, test::box({20, -10, 0}, {20.1, 10, 8}));
  const SliceResult sliced = slicePieces({pieceOf(fin)}, {}, {});
  EXPECT_EQ(sliced.slivers, 10u);
  EXPECT_NEAR(sliced.sliverVolumeMm3, 16.0, 1e-6);
  ASSERT_EQ(sliced.findings.size(), 1u);
  EXPECT_EQ(plan::reportId(sliced.findings.front()), "slivers");
}

// Two blocks in one mesh, one reaching into the other: their sections cross.
TEST(Slicing, ASectionThatCrossesItselfIsFilledByItsWinding) {
  TriangleMesh blocks = test::box({-10, -10, 0}, {10, 10, 8});
  test::append(blocks, test::box({5, -4, 0}, {20, 3, 8}));
  const SliceResult sliced = slicePieces({pieceOf(blocks)}, {}, {});
  EXPECT_NEAR(volumeOf(sliced), (20.0 * 20.0 + 10.0 * 7.0) * 8.0, 1.0);
  EXPECT_TRUE(sliced.findings.empty());
  // One inside the other adds nothing, and takes nothing away.
  TriangleMesh nested = test::box({-10, -10, 0}, {10, 10, 8});
  test::append(nested, test::box({-9, -3, -1}, {11, 3, 9}));
  const SliceResult whole = slicePieces({pieceOf(nested)}, {}, {});
  EXPECT_GT(volumeOf(whole), 20.0 * 20.0 * 8.0);
}

TEST(Slicing, RealPiecesStayWithinAndAddUp) {
  VOLUTA_MODEL_OR_SKIP(path, "spot.stl");
  const TriangleMesh spot = geometry::readMesh(path).mesh;
  const std::vector<Piece> whole{pieceOf(spot)};
  const SliceResult sliced = slicePieces(whole, {}, base::RunContext(base::CancelToken(), 2));
  expectWithin(sliced, whole);
  const double volume = geometry::volume(spot);
  EXPECT_NEAR(volumeOf(sliced), volume, 0.01 * volume);
}

TEST(Flat, OverhangOfARoofGivesAFinding) {
  // A table: top 20 x 20 on a leg of 4 x 4.
  const TriangleMesh table =
      prism({{-2, 0}, {2, 0}, {2, 10}, {10, 10}, {10, 14}, {-10, 14}, {-10, 10}, {-2, 10}}, 20.0);
  const PlanarDecomposition d = flatDecomposition(table, {});
  EXPECT_EQ(d.pieces.size(), 1u);
  EXPECT_NEAR(d.riskyMm2, 320.0, 1e-9);
  EXPECT_EQ(d.riskyMm2, d.riskyBeforeMm2);
  ASSERT_EQ(d.findings.size(), 2u);
  EXPECT_NEAR(d.findings[0].where->z(), 10.0, 1e-9);
  EXPECT_FALSE(d.findings[0].blocking);
  TriangleMesh open = table;
  open.triangles.pop_back();
  EXPECT_THROW(flatDecomposition(open, {}), base::Error);
}

TEST(Flat, FacesOnPrintedMaterialAreNoOverhangs) {
  // A gallows whose arm is on earlier material: its underside is no overhang.
  Piece piece = pieceOf(gallows());
  ASSERT_NEAR(riskyArea(piece, {}), 100.0, 1e-9);
  EXPECT_EQ(overhangFindings({piece}, {}, Overhangs::Pieces).size(), 1u);
  for (std::size_t t = 0; t < piece.solid.tag.size(); ++t)
    if (geometry::triangleNormal(piece.solid.mesh, t).z() < -0.9 &&
        piece.solid.mesh.corner(t, 0).z() > 1.0)
      piece.solid.tag[t] = kOnPrinted;
  EXPECT_EQ(riskyArea(piece, {}), 0.0);
  EXPECT_TRUE(overhangFindings({piece}, {}, Overhangs::Pieces).empty());
}

TEST(Flat, OverhangsArePlacedOnTheFacesThemselves) {
  // The middle of a ring's underside is in the air.
  const Piece ring = pieceOf(torus(20.0, 4.0, 10.0, 48, 24));
  const plan::Findings one = overhangFindings({ring}, {}, Overhangs::Pieces);
  ASSERT_EQ(one.size(), 1u);
  ASSERT_TRUE(one[0].where);
  EXPECT_NEAR(one[0].where->head<2>().norm(), 20.0, 4.0);
  EXPECT_LT(one[0].where->z(), 10.0);

  // Seven shelves on a post, each longer than the one below: five have findings of their own, the
  // two lowest one together, at the larger of them.
  std::vector<Eigen::Vector2d> profile{{0, 0}, {4, 0}};
  for (int k = 0; k < 7; ++k)
    for (const auto& [x, z] : {std::pair(4.0, 6.0), {8.0 + k, 6.0}, {8.0 + k, 8.0}, {4.0, 8.0}})
      profile.emplace_back(x, z + 6.0 * k);
  profile.emplace_back(0, 46);
  const plan::Findings many =
      overhangFindings({pieceOf(prism(profile, 10.0))}, {}, Overhangs::Pieces);
  ASSERT_EQ(many.size(), 6u);
  EXPECT_EQ(many[5].count, 2u);
  ASSERT_TRUE(many[5].where);
  EXPECT_NEAR(many[5].where->z(), 12.0, 1e-9);
  EXPECT_GT(many[5].where->x(), 4.0);
}

TEST(UserPlanes, LayersOfABentBarAreItsSections) {
  // A quarter ring about the y axis through x = 30: section 8 x 10, from the plate up and over.
  const int n = 60;
  const double centre = 30.0, inner = 22.0, outer = 30.0;
  std::vector<Eigen::Vector2d> profile;
  const auto add = [&](double radius, int k) {
    const double a = 0.5 * base::kPi * k / n;
    profile.emplace_back(centre - radius * std::cos(a), radius * std::sin(a));
  };
  for (int k = n; k >= 0; --k)
    add(outer, k);
  for (int k = 0; k <= n; ++k)
    add(inner, k);
  const TriangleMesh bar = prism(profile, 10.0);
  ASSERT_TRUE(isClosed(bar));
  ASSERT_GT(geometry::volume(bar), 0.0);
  const double step = 0.5 * base::kPi / n; // 0.68 mm in the middle
  std::string json = "[";
  for (int k = 0; k < n; ++k) {
    const double a = (k + 0.5) * step;
    json += (k > 0 ? "," : "") + std::string("{\"point\": [30, 0, 0], \"normal\": [") +
            std::to_string(std::sin(a)) + ", 0, " + std::to_string(std::cos(a)) + "]}";
  }
  const SliceResult sliced = sliceByPlanes(bar, readUserPlanes(json + "]", "here"), {}, {});
  EXPECT_EQ(sliced.stack.layerCount, n);
  for (const layers::Patch& patch : sliced.stack.patches)
    EXPECT_NEAR(geometry::area(patch.surface), 80.0, 0.1) << patch.layer;
  const double volume = geometry::volume(bar);
  EXPECT_NEAR(volumeOf(sliced), volume, 0.01 * volume);
  EXPECT_EQ(sliced.unsupportedPatches, 0u);
  // Thicker on the outside of the bend.
  const layers::Patch& middle = sliced.stack.patches[30];
  for (std::size_t v = 0; v < middle.surface.vertices.size(); ++v) {
    const Vector3d& p = middle.surface.vertices[v];
    EXPECT_NEAR(middle.thicknessMm[v], std::hypot(p.x() - centre, p.z()) * std::tan(step), 1e-3);
  }
  EXPECT_TRUE(sliced.findings.empty());
}

TEST(UserPlanes, AQuadrilateralCutsWithinItsCorners) {
  const TriangleMesh box = test::box({0, 0, 0}, {20, 10, 1.6});
  const std::string json = R"([{"corners": [[-1,-1,0.4],[8,-1,0.4],[8,11,0.4],[-1,11,0.4]]},
    {"corners": [[8,-1,0.4],[21,-1,0.4],[21,11,0.4],[8,11,0.4]]},
    {"point": [0,0,1.2], "normal": [0,0,2]},
    {"point": [0,0,5], "normal": [0,0,1]}])";
  const SliceResult sliced = sliceByPlanes(box, readUserPlanes(json, "here"), {}, {});
  ASSERT_EQ(sliced.stack.patches.size(), 3u);
  EXPECT_NEAR(geometry::area(sliced.stack.patches[0].surface), 80.0, 1e-6);
  EXPECT_NEAR(geometry::area(sliced.stack.patches[1].surface), 120.0, 1e-6);
  EXPECT_NEAR(volumeOf(sliced), 320.0, 1e-6);
  ASSERT_EQ(sliced.findings.size(), 1u);
  EXPECT_EQ(voluta::plan::reportId(sliced.findings[0]), "planeMisses");
}

} // namespace
} // namespace voluta::planar
