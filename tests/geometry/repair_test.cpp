#include "geometry/repair/repair.h"

#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/models.h"
#include "helpers/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;
using geometry::diagnose;
using geometry::repair;
using geometry::TriangleMesh;
using testing::ElementsAre;
using testing::HasSubstr;

using test::append;

namespace {

TriangleMesh unitBox() {
  return test::box({0, 0, 0}, {10, 10, 10});
}

TriangleMesh reversed(TriangleMesh mesh) {
  for (auto& t : mesh.triangles)
    std::swap(t[1], t[2]);
  return mesh;
}

} // namespace

TEST(Diagnosis, CleanShapes) {
  const auto d = diagnose(test::sphere({0, 0, 0}, 10.0));
  EXPECT_TRUE(d.clean());
  EXPECT_TRUE(d.watertight);
  EXPECT_EQ(d.genus, 0);
  EXPECT_EQ(d.components, 1);
  EXPECT_TRUE(d.sentences().empty());
}

TEST(Diagnosis, EachDefectIsCountedWhereItIs) {
  TriangleMesh m = unitBox();
  m.triangles.pop_back();
  auto d = diagnose(m);
  EXPECT_FALSE(d.watertight);
  EXPECT_EQ(d.boundaryEdges.count, 3u);
  EXPECT_EQ(d.boundaryLoops, 1u);
  EXPECT_DOUBLE_EQ(d.boundaryEdges.at.x(), 10.0); // the last triangle is in x = 10

  m = unitBox();
  m.triangles.push_back(m.triangles[0]);
  m.triangles.push_back({0, 0, 1});
  d = diagnose(m);
  EXPECT_EQ(d.duplicateFaces.count, 1u);
  EXPECT_EQ(d.degenerateFaces.count, 1u);

  m = unitBox();
  std::swap(m.triangles[4][0], m.triangles[4][1]);
  EXPECT_EQ(diagnose(m).misorientedEdges.count, 3u);

  EXPECT_EQ(diagnose(reversed(unitBox())).insideOutComponents.count, 1u);
  EXPECT_FALSE(diagnose(TriangleMesh{}).watertight);
}

TEST(Repair, CleanMeshIsUnchanged) {
  TriangleMesh m = unitBox();
  append(m, test::box({2, 2, 2}, {5, 5, 5}), true); // a cavity
  const auto r = repair(m);
  EXPECT_EQ(r.mesh.vertices, m.vertices);
  EXPECT_EQ(r.mesh.triangles, m.triangles);
  EXPECT_TRUE(r.repairs.empty());
  EXPECT_NEAR(r.diagnosis.volumeMm3, 1000 - 27, 1e-9);
}

TEST(Repair, TurnsShellsAndKeepsCavities) {
  TriangleMesh m = unitBox();
  append(m, test::box({2, 2, 2}, {5, 5, 5}), true);
  append(m, test::box({3, 3, 3}, {4, 4, 4})); // something loose in the cavity
  const auto r = repair(reversed(m));
  EXPECT_TRUE(r.diagnosis.clean());
  EXPECT_NEAR(r.diagnosis.volumeMm3, 1000 - 27 + 1, 1e-9);
}

TEST(Repair, ClosesAHoleAndTurnsTriangles) {
  TriangleMesh m = unitBox();
  m.triangles.pop_back();
  std::swap(m.triangles[3][0], m.triangles[3][1]);
  m.triangles.push_back(m.triangles[6]);
  const auto r = repair(m);
  EXPECT_TRUE(r.diagnosis.clean());
  EXPECT_NEAR(r.diagnosis.volumeMm3, 1000, 1e-9);
  EXPECT_THAT(voluta::base::english(r.repairs),
              ElementsAre(HasSubstr("1 duplicate triangle"), HasSubstr("flipped 1"),
                          HasSubstr("closed 1 hole")));
}

TEST(Repair, MergesJitteredCorners) {
  const TriangleMesh sphere = test::sphere({0, 0, 0}, 50.0, 16);
  std::mt19937 random(1);
  std::normal_distribution<double> jitter(0.0, 0.002);
  TriangleMesh m;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k)
      m.vertices.push_back(sphere.corner(t, k) +
                           Vector3d(jitter(random), jitter(random), jitter(random)));
    const int first = static_cast<int>(3 * t);
    m.triangles.push_back({first, first + 1, first + 2});
  }
  const auto r = repair(m);
  EXPECT_TRUE(r.diagnosis.clean());
  EXPECT_EQ(r.mesh.vertices.size(), sphere.vertices.size());
  EXPECT_NEAR(r.diagnosis.volumeMm3 / geometry::volume(sphere), 1.0, 1e-4);
}

TEST(Repair, UnitesOverlappingBoxes) {
  TriangleMesh m = unitBox();
  append(m, test::box({5, 5.5, 6}, {15, 15, 15}));
  const auto r = repair(m);
  EXPECT_TRUE(r.diagnosis.clean());
  EXPECT_EQ(r.diagnosis.components, 1);
  EXPECT_NEAR(r.diagnosis.volumeMm3, 1000 + 10 * 9.5 * 9 - 5 * 4.5 * 4, 1e-6);
}

// 140 bars across 140 others: more crossings than a union takes in reasonable time.
TEST(Repair, TooManyCrossingsAreNamedAndLeftUnrepaired) {
  TriangleMesh bars;
  constexpr int kBars = 140;
  for (int i = 0; i < kBars; ++i) {
    const double at = 3.0 * i, end = 3.0 * kBars;
    test::append(bars, test::box({at, -1.0, 0.0}, {at + 1.0, end, 1.0}));
    test::append(bars, test::box({-1.0, at, 0.3}, {end, at + 1.0, 1.3}));
  }
  const geometry::RepairResult result = repair(bars);
  EXPECT_EQ(result.mesh.triangles.size(), bars.triangles.size());
  ASSERT_FALSE(result.remains.empty());
  EXPECT_NE(base::english(result.remains.back()).find("too many intersecting triangles"),
            std::string::npos)
      << base::english(result.remains.back());
}

TEST(Repair, SplitsTJunctions) {
  TriangleMesh m = unitBox();
  // Edge 0-1 is left whole on one side and has a vertex in its middle on the other.
  m.vertices.emplace_back(5, 0, 0);
  m.triangles.erase(m.triangles.begin() + 1); // {0, 3, 1}
  m.triangles.push_back({0, 3, 8});
  m.triangles.push_back({8, 3, 1});
  EXPECT_FALSE(diagnose(m).watertight);
  const auto r = repair(m);
  EXPECT_TRUE(r.diagnosis.clean());
  EXPECT_NEAR(r.diagnosis.volumeMm3, 1000, 1e-9);
}

TEST(Repair, StopsWhenCancelled) {
  base::CancelToken token;
  token.cancel();
  EXPECT_THROW(repair(unitBox(), base::RunContext(token, 1)), base::Cancelled);
}

struct BrokenModel {
  const char* file;
  double volume;
};

class RepairOfModels : public testing::TestWithParam<BrokenModel> {};

TEST_P(RepairOfModels, IsWatertightWithTheRightVolume) {
  VOLUTA_MODEL_OR_SKIP(path, std::filesystem::path("broken") / GetParam().file);
  const auto r = repair(geometry::readMesh(path).mesh);
  EXPECT_TRUE(r.diagnosis.watertight);
  EXPECT_NEAR(r.diagnosis.volumeMm3 / GetParam().volume, 1.0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Broken, RepairOfModels,
                         testing::Values(BrokenModel{"broken_duplicated_faces_kitten.stl", 125075},
                                         BrokenModel{"broken_holes3_kitten.stl", 125075},
                                         BrokenModel{"broken_nan_kitten.stl", 125075},
                                         BrokenModel{"broken_overlapping_cubes.stl", 235000},
                                         BrokenModel{"broken_real_engine_bracket_insideout.stl",
                                                     81673},
                                         BrokenModel{"broken_tjunction_box.stl", 500000},
                                         BrokenModel{"broken_unwelded_jitter_kitten.stl", 125075}));
