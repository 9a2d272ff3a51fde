// Packages are read back as written: positions within 1 um, directions within 1e-6, sections within
// 0.1 %.
#include "base/error.h"
#include "base/run_context.h"
#include "build3mf/build_reader.h"
#include "build3mf/build_writer.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/formats/zip_package.h"
#include "geometry/measures.h"
#include "sample_beads.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

const base::RunContext kCtx;

std::string packageOf(const plan::ToolPlan& plan) {
  return build3mf::writeBuild(plan, test::box({0, 0, 0}, {10, 20, 30}), "a <b> & \"c\".stl", kCtx);
}

void expectSame(const plan::ToolPlan& a, const plan::ToolPlan& b) {
  ASSERT_EQ(a.paths.size(), b.paths.size());
  ASSERT_EQ(a.waypointCount(), b.waypointCount());
  for (std::size_t p = 0; p < a.paths.size(); ++p) {
    const plan::ToolPath &x = a.paths[p], &y = b.paths[p];
    EXPECT_EQ(x.first, y.first);
    EXPECT_EQ(x.count, y.count);
    EXPECT_EQ(x.kind, y.kind);
    EXPECT_EQ(x.layer, y.layer);
    EXPECT_EQ(x.patch, y.patch);
    EXPECT_EQ(x.group, y.group);
    EXPECT_EQ(x.closed, y.closed);
    for (std::size_t i = x.first; i < x.first + x.count; ++i) {
      EXPECT_LE((a.position[i] - b.position[i]).norm(), 1e-4);
      EXPECT_LE((a.direction[i] - b.direction[i]).norm(), 1e-8);
      EXPECT_NEAR(a.widthMm[i] / b.widthMm[i], 1.0, 1e-5);
      EXPECT_NEAR(a.heightMm[i] / b.heightMm[i], 1.0, 1e-5);
      if (i > x.first) {
        EXPECT_NEAR(a.speedMmPerS[i] / b.speedMmPerS[i], 1.0, 1e-5);
      }
    }
  }
}

TEST(RoundTrip, RandomBeadsAreReadBack) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const plan::ToolPlan plan = test::randomBeads(seed, 1 + static_cast<int>(seed));
    const std::string bytes = packageOf(plan);
    ASSERT_TRUE(build3mf::holdsToolpaths(bytes));
    const build3mf::ReadBuild read = build3mf::readBuild(bytes, "a.build.3mf", kCtx);
    EXPECT_TRUE(read.workFrame);
    EXPECT_TRUE(read.hasObject);
    EXPECT_TRUE(read.notes.empty());
    EXPECT_TRUE(geometry::readMesh(bytes, "a.build.3mf").repairs.empty());
    expectSame(plan, read.plan);
  }
}

TEST(RoundTrip, OneSectionAndOneSpeedNeedNoModifier) {
  plan::ToolPlan plan = test::randomBeads(3, 2);
  std::fill(plan.widthMm.begin(), plan.widthMm.end(), 1.3f);
  std::fill(plan.heightMm.begin(), plan.heightMm.end(), 0.7f);
  std::fill(plan.speedMmPerS.begin(), plan.speedMmPerS.end(), 17.0f);
  const std::string bytes = packageOf(plan), name;
  EXPECT_EQ(geometry::ZipPackage(bytes, name).member("3D/3dmodel.model").find("modifier"),
            std::string::npos);
  expectSame(plan, build3mf::readBuild(bytes, "a", kCtx).plan);
}

TEST(RoundTrip, OppositeDirectionsAreReadBack) {
  plan::ToolPlan plan = test::randomBeads(5, 1);
  for (std::size_t i = 0; i < plan.waypointCount(); ++i)
    plan.direction[i] =
        i % 2 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(-Eigen::Vector3d::UnitZ());
  expectSame(plan, build3mf::readBuild(packageOf(plan), "a", kCtx).plan);
}

TEST(RoundTrip, TheSamePlanGivesTheSameBytes) {
  const plan::ToolPlan plan = test::randomBeads(7, 5);
  EXPECT_EQ(packageOf(plan), packageOf(plan));
}

TEST(RoundTrip, TheObjectIsAMeshThatAnyReaderTakes) {
  const std::string bytes = packageOf(test::randomBeads(7, 5));
  const geometry::MeshFile file = geometry::readMesh(bytes, "a.build.3mf");
  EXPECT_EQ(file.format, "3MF");
  EXPECT_NEAR(geometry::volume(file.mesh), 6000.0, 1e-6);
}

TEST(RoundTrip, ALayerPartForEachStretchOfALayer) {
  const plan::ToolPlan plan = test::randomBeads(9, 8); // two stretches share a layer
  const std::string bytes = packageOf(plan), name;
  const geometry::ZipPackage package(bytes, name);
  EXPECT_TRUE(package.has("Toolpath/Layers/layer00004.xml"));
  EXPECT_FALSE(package.has("Toolpath/Layers/layer00005.xml"));
}

TEST(RoundTrip, CoordinatesBeyondThirtyTwoBitsAreRefused) {
  plan::ToolPlan plan = test::randomBeads(9, 1);
  plan.position[0].x() = 3e5;
  EXPECT_THROW(packageOf(plan), base::Error);
}

TEST(RoundTrip, AMeshIsNoBuildFile) {
  EXPECT_FALSE(build3mf::holdsToolpaths("solid nothing"));
  EXPECT_FALSE(build3mf::holdsToolpaths("PK, but no zip"));
}

} // namespace
