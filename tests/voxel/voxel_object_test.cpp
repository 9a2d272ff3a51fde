#include "voxel/voxel_object.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "voxel/voxel_text.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace voluta::voxel {
namespace {

VoxelObject randomObject(unsigned seed, int side, unsigned ofTen) {
  std::mt19937 random(seed);
  VoxelObject o;
  o.size = {side, side, side};
  o.solid.resize(static_cast<std::size_t>(o.size.prod()));
  for (auto& s : o.solid)
    s = random() % 10 < ofTen;
  o.solid[0] = 1;
  o.platform = {{0, 0}};
  return o;
}

std::size_t countOf(const VoxelObject& o) {
  std::size_t n = 0;
  for (const auto s : o.solid)
    n += s;
  return n;
}

// Every edge once each way; the triangles about each vertex form one ring.
void expectManifold(const geometry::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  std::map<int, std::map<int, int>> next; // of a vertex: from a neighbour to the one after it
  for (const auto& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      ++edges[{t[c], t[(c + 1) % 3]}];
      next[t[c]][t[(c + 1) % 3]] = t[(c + 2) % 3];
    }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  for (const auto& [vertex, ring] : next) {
    std::size_t steps = 0;
    int at = ring.begin()->first;
    do {
      at = ring.at(at);
      ++steps;
    } while (at != ring.begin()->first && steps <= ring.size());
    ASSERT_EQ(steps, ring.size()) << "vertex " << vertex;
  }
  ASSERT_EQ(next.size(), mesh.vertices.size()) << "no vertex without triangles";
}

TEST(VoxelSurface, OneCellIsACube) {
  const geometry::TriangleMesh mesh = surfaceOf(readVoxelText("1\n-\n", "c.txt"));
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(geometry::volume(mesh), 1.0);
  expectManifold(mesh);
}

TEST(VoxelSurface, CellsThatTouchKeepApart) {
  const geometry::TriangleMesh edge = surfaceOf(readVoxelText("10\n01\n--\n", "e.txt"));
  EXPECT_EQ(edge.vertices.size(), 16u);
  expectManifold(edge);
  const geometry::TriangleMesh corner =
      surfaceOf(readVoxelText("10\n00\n--\n\n00\n01\n--\n", "k.txt"));
  EXPECT_EQ(corner.vertices.size(), 16u);
  expectManifold(corner);
}

// Two diagonal pillars between plates that join them: both ends of their common edge are shared.
TEST(VoxelSurface, SheetsThatShareBothEndsOfAnEdgeGetTheirOwnMiddles) {
  const VoxelObject o = readVoxelText("11\n10\n11\n--\n\n11\n01\n11\n--\n", "d.txt");
  const geometry::TriangleMesh mesh = surfaceOf(o);
  expectManifold(mesh);
  std::set<std::array<double, 3>> halves;
  for (const auto& v : mesh.vertices)
    if (v.z() == 1.5 && v.x() == 1.0 && v.y() == 1.0)
      halves.insert({v.x(), v.y(), v.z()});
  EXPECT_EQ(halves.size(), 1u);
  EXPECT_DOUBLE_EQ(geometry::volume(mesh), 10.0);
}

TEST(VoxelSurface, AnyObjectGetsAManifoldOfItsVolume) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const VoxelObject o = randomObject(seed, 5, 1 + seed % 9);
    const geometry::TriangleMesh mesh = surfaceOf(o);
    expectManifold(mesh);
    EXPECT_NEAR(geometry::volume(mesh), static_cast<double>(countOf(o)), 1e-9) << seed;
    if (testing::Test::HasFatalFailure())
      FAIL() << seed;
  }
}

TEST(VoxelSurface, DiagnosisFindsItClosed) {
  const geometry::Diagnosis d = geometry::diagnose(surfaceOf(randomObject(5, 6, 5)));
  EXPECT_TRUE(d.watertight);
  EXPECT_EQ(d.boundaryEdges.count + d.nonManifoldEdges.count + d.misorientedEdges.count +
                d.duplicateFaces.count + d.degenerateFaces.count,
            0u);
}

TEST(VoxelObject, GridHasTheCellsAndAnEmptyBorder) {
  const VoxelObject o = readVoxelText("0000\n0110\n0100\n----\n", "l.txt");
  const SolidVoxels v = solidVoxels(o, Eigen::Matrix3i::Identity(), 0.5, {2.0, 3.0}, 0);
  EXPECT_EQ(v.grid.size, Eigen::Vector3i(4, 3, 4));
  EXPECT_EQ(v.count, 3u);
  EXPECT_EQ(v.plateLayer(), 1);
  EXPECT_EQ(v.solid[v.grid.index(1, 1, 1)], 1);
  EXPECT_EQ(v.solid[v.grid.index(1, 1, 2)], 1);
  EXPECT_EQ(v.solid[v.grid.index(2, 1, 2)], 1);
  // Two cells wide about x = 2, one deep about y = 3.
  EXPECT_DOUBLE_EQ(v.grid.centre(1, 1, 1).x(), 1.75);
  EXPECT_DOUBLE_EQ(v.grid.centre(1, 1, 1).y(), 3.0);
  EXPECT_DOUBLE_EQ(v.grid.centre(1, 1, 1).z(), 0.25);
}

TEST(VoxelObject, QuarterTurnsMoveCellsAsTheyMoveTheSurface) {
  const VoxelObject o = randomObject(9, 4, 4);
  const geometry::TriangleMesh surface = surfaceOf(o);
  const Eigen::Vector3i axes[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  int turns = 0;
  for (const Eigen::Vector3i& x : axes)
    for (const Eigen::Vector3i& y : axes) {
      if (x.dot(y) != 0)
        continue;
      ++turns;
      Eigen::Matrix3i rotation;
      rotation << x, y, x.cross(y);
      const SolidVoxels v = solidVoxels(o, rotation, 2.0, {1.0, -1.0}, 3);
      EXPECT_EQ(v.count, countOf(o));
      EXPECT_DOUBLE_EQ(v.grid.origin.z(), 4.0);
      // The same by voxelising the turned surface.
      geometry::TriangleMesh turned = surface;
      Eigen::AlignedBox3d box;
      for (auto& p : turned.vertices) {
        p = 2.0 * (rotation.cast<double>() * p);
        box.extend(p);
      }
      const Eigen::Vector3d shift(1.0 - box.center().x(), -1.0 - box.center().y(),
                                  6.0 - box.min().z());
      for (auto& p : turned.vertices)
        p += shift;
      const SolidVoxels again = solidVoxels(turned, 2.0, base::RunContext{});
      ASSERT_EQ(again.grid.size, v.grid.size);
      EXPECT_NEAR((again.grid.origin - v.grid.origin).norm(), 0.0, 1e-9);
      EXPECT_EQ(again.solid, v.solid);
    }
  EXPECT_EQ(turns, 24);
}

TEST(VoxelObject, RefusesMatricesThatAreNotRotations) {
  const VoxelObject o = readVoxelText("1\n-\n", "c.txt");
  EXPECT_THROW(solidVoxels(o, 2 * Eigen::Matrix3i::Identity(), 1.0, {0, 0}, 0), base::Error);
  EXPECT_THROW(solidVoxels(o, -Eigen::Matrix3i::Identity(), 1.0, {0, 0}, 0), base::Error);
  EXPECT_THROW(solidVoxels(o, Eigen::Matrix3i::Identity(), 0.0, {0, 0}, 0), base::Error);
}

} // namespace
} // namespace voluta::voxel
