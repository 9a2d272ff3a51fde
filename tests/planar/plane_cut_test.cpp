// Cuts by planes: closed sides with the volume of the solid before.
#include "planar/plane_cut.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/models.h"
#include "helpers/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace voluta::planar {
namespace {

using Eigen::Vector3d;
using geometry::TriangleMesh;

using test::append;

// Invariants of any cut. Returns it.
PlaneCut cutAndCheck(const TaggedMesh& in, const Plane& plane, std::int32_t tag = 0) {
  const PlaneCut cut = cutByPlane(in, plane, tag);
  EXPECT_TRUE(isClosed(cut.below.mesh));
  double above = 0.0;
  for (const TaggedMesh& solid : cut.above) {
    EXPECT_TRUE(isClosed(solid.mesh));
    EXPECT_GT(geometry::volume(solid.mesh), 0.0);
    above += geometry::volume(solid.mesh);
  }
  const double all = geometry::volume(in.mesh);
  const double below = cut.below.mesh.empty() ? 0.0 : geometry::volume(cut.below.mesh);
  EXPECT_NEAR(below + above, all, 1e-9 * std::abs(all));
  const double slack = 1e-8 * geometry::bounds(in.mesh).diagonal().norm() + 1e-12;
  const Plane used{plane.normal, cut.offsetMm};
  for (const Vector3d& v : cut.below.mesh.vertices)
    EXPECT_LE(used.heightOf(v), slack);
  for (const TaggedMesh& solid : cut.above)
    for (const Vector3d& v : solid.mesh.vertices)
      EXPECT_GE(used.heightOf(v), -slack);
  double capBelow = 0.0, capAbove = 0.0;
  for (std::size_t t = 0; t < cut.below.tag.size(); ++t)
    if (cut.below.tag[t] >= tag)
      capBelow += geometry::triangleArea(cut.below.mesh, t);
  for (const TaggedMesh& solid : cut.above)
    for (std::size_t t = 0; t < solid.tag.size(); ++t)
      if (solid.tag[t] >= tag)
        capAbove += geometry::triangleArea(solid.mesh, t);
  EXPECT_NEAR(capBelow, cut.sectionMm2, 1e-9 * (1.0 + cut.sectionMm2));
  EXPECT_NEAR(capAbove, cut.sectionMm2, 1e-9 * (1.0 + cut.sectionMm2));
  return cut;
}

TEST(PlaneCut, ABoxInTwo) {
  const PlaneCut cut =
      cutAndCheck(tagged(test::box({0, 0, 0}, {4, 5, 6})), {Vector3d::UnitZ(), 2.0});
  EXPECT_NEAR(geometry::volume(cut.below.mesh), 40.0, 1e-12);
  EXPECT_NEAR(geometry::volume(cut.above.front().mesh), 80.0, 1e-12);
  EXPECT_NEAR(cut.sectionMm2, 20.0, 1e-12);
  EXPECT_EQ(cut.offsetMm, 2.0);
}

TEST(PlaneCut, AlongAFaceNothingIsLeftOnOneSide) {
  const TaggedMesh box = tagged(test::box({0, 0, 0}, {4, 5, 6}));
  const PlaneCut top = cutAndCheck(box, {Vector3d::UnitZ(), 6.0});
  EXPECT_TRUE(top.above.empty());
  EXPECT_EQ(top.sectionMm2, 0.0);
  const PlaneCut bottom = cutAndCheck(box, {Vector3d::UnitZ(), 0.0});
  EXPECT_TRUE(bottom.below.mesh.empty());
  const PlaneCut away = cutAndCheck(box, {Vector3d::UnitZ(), 9.0});
  EXPECT_EQ(away.below.mesh.triangles.size(), 12u);
}

TEST(PlaneCut, ThroughCornersAndEdges) {
  const TaggedMesh box = tagged(test::box({0, 0, 0}, {4, 4, 4}));
  const PlaneCut diagonal =
      cutAndCheck(box, {Vector3d(1, 1, 0).normalized(), 4.0 / std::sqrt(2.0)});
  EXPECT_NEAR(diagonal.sectionMm2, 16.0 * std::sqrt(2.0), 1e-9);
  const PlaneCut corners = cutAndCheck(box, {Vector3d(1, 1, 1).normalized(), 6.0 / std::sqrt(3.0)});
  EXPECT_NEAR(corners.sectionMm2, 12.0 * std::sqrt(3.0), 1e-9); // regular hexagon of side 2 sqrt 2
}

// A step: the plane runs along the tread and cuts the riser's block.
TEST(PlaneCut, AlongATreadOnlyTheBlockAboveIsCutOff) {
  TriangleMesh step; // profile in x z, extruded along y
  const std::vector<Eigen::Vector2d> profile{{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}};
  const int n = static_cast<int>(profile.size());
  for (const double y : {0.0, 4.0})
    for (const auto& p : profile)
      step.vertices.emplace_back(p.x(), y, p.y());
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    step.triangles.push_back({i, j, n + j});
    step.triangles.push_back({i, n + j, n + i});
  }
  for (const auto& t :
       std::vector<std::array<int, 3>>{{0, 3, 1}, {1, 3, 2}, {0, 5, 3}, {3, 5, 4}}) {
    step.triangles.push_back({t[0], t[1], t[2]});
    step.triangles.push_back({n + t[0], n + t[2], n + t[1]});
  }
  if (geometry::volume(step) < 0.0)
    for (auto& t : step.triangles)
      std::swap(t[1], t[2]);
  ASSERT_TRUE(isClosed(step));
  const PlaneCut cut = cutAndCheck(tagged(step), {Vector3d::UnitZ(), 2.0});
  EXPECT_NEAR(geometry::volume(cut.below.mesh), 48.0, 1e-9);
  EXPECT_NEAR(geometry::volume(cut.above.front().mesh), 36.0, 1e-9);
  EXPECT_NEAR(cut.sectionMm2, 12.0, 1e-9); // the tread itself is no section
}

TEST(PlaneCut, ASectionWithAHoleAndACavity) {
  TriangleMesh shell = test::sphere({0, 0, 0}, 10.0);
  append(shell, test::sphere({0, 0, 1}, 6.0), true);
  const TaggedMesh in = tagged(shell);
  EXPECT_EQ(solids(in).size(), 1u);
  const PlaneCut cut = cutAndCheck(in, {Vector3d(0.1, -0.2, 1.0).normalized(), 0.3});
  EXPECT_NEAR(cut.sectionMm2, base::kPi * (100.0 - 36.0), 4.0);
  EXPECT_EQ(solids(cut.below).size(), 1u);
  // Above the cavity only a cap is left; below it a ball with a cavity.
  const PlaneCut high = cutAndCheck(in, {Vector3d::UnitZ(), 8.0});
  EXPECT_EQ(geometry::components(high.below.mesh).count, 2);
  ASSERT_EQ(solids(high.below).size(), 1u);
  EXPECT_NEAR(geometry::volume(solids(high.below).front().mesh), geometry::volume(high.below.mesh),
              1e-9);
}

TEST(PlaneCut, SeveralPiecesAbove) {
  const PlaneCut cut = [&] {
    TriangleMesh prongs;
    append(prongs, test::box({0, 0, 0}, {2, 4, 9}));
    append(prongs, test::box({4, 0, 0}, {6, 4, 9}));
    append(prongs, test::box({8, 0, 0}, {10, 4, 9}));
    return cutAndCheck(tagged(prongs), {Vector3d::UnitZ(), 3.0});
  }();
  EXPECT_EQ(cut.above.size(), 3u);
  EXPECT_EQ(solids(cut.below).size(), 3u);
}

TEST(PlaneCut, OnlyTheSelectedSolidIsCutOff) {
  TriangleMesh comb = test::box({0, 0, 0}, {2, 4, 9});
  append(comb, test::box({4, 0, 0}, {6, 4, 7}));
  const PlaneCut cut =
      cutByPlane(tagged(comb), {Vector3d::UnitZ(), 3.0}, 4, [](const TaggedMesh& solid) {
        return geometry::bounds(solid.mesh).max().z() > 8.0;
      });
  ASSERT_EQ(cut.above.size(), 1u);
  EXPECT_NEAR(geometry::volume(cut.above.front().mesh), 48.0, 1e-9);
  EXPECT_TRUE(isClosed(cut.below.mesh));
  EXPECT_NEAR(geometry::volume(cut.below.mesh), 24.0 + 56.0, 1e-9);
  EXPECT_NEAR(cut.sectionMm2, 8.0, 1e-12);
  for (std::size_t t = 0; t < cut.below.tag.size(); ++t)
    if (cut.below.tag[t] == 4) {
      EXPECT_LE(cut.below.mesh.corner(t, 0).x(), 2.0);
    }
}

TEST(PlaneCut, RandomPlanesOneAfterAnother) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  TriangleMesh part = test::sphere({0, 0, 0}, 10.0, 20);
  append(part, test::sphere({0, 0, 0}, 5.0, 12), true);
  std::vector<TaggedMesh> pieces{tagged(part)};
  const double all = geometry::volume(part);
  for (int k = 0; k < 8; ++k) {
    const Plane plane{Vector3d(unit(random), unit(random), unit(random)).normalized(),
                      4.0 * unit(random)};
    std::vector<TaggedMesh> next;
    for (const TaggedMesh& piece : pieces) {
      PlaneCut cut = cutAndCheck(piece, plane, 1000 * k);
      if (!cut.below.mesh.empty())
        next.push_back(std::move(cut.below));
      for (TaggedMesh& solid : cut.above)
        next.push_back(std::move(solid));
    }
    pieces = std::move(next);
  }
  double sum = 0.0;
  for (const TaggedMesh& piece : pieces)
    sum += geometry::volume(piece.mesh);
  EXPECT_GT(pieces.size(), 40u);
  EXPECT_NEAR(sum, all, 1e-9 * all);
}

class PlaneCutModels : public testing::TestWithParam<const char*> {};

TEST_P(PlaneCutModels, AnyPlaneLeavesClosedSides) {
  VOLUTA_MODEL_OR_SKIP(file, GetParam());
  const TaggedMesh part = tagged(geometry::readMesh(file).mesh);
  ASSERT_TRUE(isClosed(part.mesh));
  const Eigen::AlignedBox3d box = geometry::bounds(part.mesh);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int k = 0; k < 20; ++k) {
    Vector3d normal = Vector3d(unit(random), unit(random), unit(random)).normalized();
    if (k < 3)
      normal = Vector3d::Unit(k);
    cutAndCheck(part,
                {normal, normal.dot(box.center()) + 0.3 * box.diagonal().norm() * unit(random)});
  }
}

INSTANTIATE_TEST_SUITE_P(Models, PlaneCutModels,
                         testing::Values("bunny_7k.stl", "fertility_9k.stl", "chair.stl",
                                         "hollow_kitten_3mm.stl", "fandisk.stl"));

} // namespace
} // namespace voluta::planar
