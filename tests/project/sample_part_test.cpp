#include "project/sample_part.h"

#include "geometry/measures.h"
#include "helpers/mesh_measures.h"

#include <gtest/gtest.h>

using namespace voluta;
using geometry::TriangleMesh;

TEST(SamplePart, IsAModestClosedPart) {
  const TriangleMesh m = project::samplePart();
  const auto box = geometry::bounds(m);
  EXPECT_LT(m.triangles.size(), 20000u);
  EXPECT_EQ(box.min().z(), 0.0);
  EXPECT_EQ(box.max().z(), 60.0);
  EXPECT_EQ(geometry::components(m).count, 1);
  // Euler's formula for a closed surface of genus 0.
  EXPECT_EQ(m.vertices.size() + m.triangles.size() - test::edgeCount(m), 2u);
  EXPECT_GT(geometry::volume(m), 40000.0);
}
