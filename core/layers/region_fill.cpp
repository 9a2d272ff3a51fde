#include "layers/region_fill.h"

#include "layers/constrained_triangulation.h"

namespace voluta::layers {

std::optional<std::vector<std::array<int, 3>>>
fillRegion(const std::vector<Eigen::Vector2d>& points,
           const std::vector<std::array<int, 2>>& edges) {
  Triangulation t;
  std::vector<Triangulation::Vertex_handle> vertex(points.size());
  const auto vertexOf = [&](int i) {
    auto& known = vertex[static_cast<std::size_t>(i)];
    if (known == nullptr) {
      const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
      const std::size_t before = t.number_of_vertices();
      const auto inserted = t.insert(Kernel::Point_2(p.x(), p.y()));
      if (t.number_of_vertices() == before)
        return Triangulation::Vertex_handle{};
      inserted->info() = i;
      known = inserted;
    }
    return known;
  };
  try {
    for (const auto& e : oddEdges(edges)) {
      const auto a = vertexOf(e[0]), b = vertexOf(e[1]);
      if (a == nullptr || b == nullptr)
        return std::nullopt;
      t.insert_constraint(a, b);
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  return insideTriangles(t);
}

} // namespace voluta::layers
