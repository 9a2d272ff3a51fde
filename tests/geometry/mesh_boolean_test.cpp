// Union and difference of closed meshes.
#include "geometry/mesh_boolean.h"

#include "geometry/measures.h"
#include "helpers/shapes.h"

#include <array>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;

namespace {

// CGAL's corefinement crashed on the triangle without area.
TEST(MeshBoolean, TakesTrianglesWithoutArea) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {10, 10, 10});
  std::array<int, 3>& first = mesh.triangles.front();
  const auto [a, b, c] = first;
  const int middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.5 * (mesh.vertices[static_cast<std::size_t>(a)] +
                                    mesh.vertices[static_cast<std::size_t>(b)]));
  first = {a, middle, c};
  mesh.triangles.push_back({middle, b, c});
  mesh.triangles.push_back({a, b, middle});
  for (const Vector3d& low : {Vector3d(-1, 4, -1), Vector3d(4, -1, -1), Vector3d(-1, -1, -1)}) {
    const geometry::TriangleMesh other = test::box(low, low + Vector3d(3.3, 3.1, 2.9));
    const auto sum = geometry::meshBoolean(geometry::BooleanOperation::Union, mesh, other, false);
    const auto rest =
        geometry::meshBoolean(geometry::BooleanOperation::Difference, mesh, other, false);
    ASSERT_TRUE(sum && rest);
    EXPECT_NEAR(geometry::volume(*sum), geometry::volume(*rest) + geometry::volume(other), 1e-6);
    EXPECT_LT(geometry::volume(*rest), 1000.0);
  }
}

} // namespace
