#include "planar/slicing/region_mesh.h"

#include "base/index.h"
#include "layers/constrained_triangulation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace voluta::planar {

namespace {

using Eigen::Vector2d;

// Of the spacing: minimum distance of inner points from the boundary's
constexpr double kClear = 0.6;

using base::at;

// Returns for each point the smallest index of a point at the same place.
std::vector<int> firstAtPlace(const std::vector<Vector2d>& points) {
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const Vector2d &p = points[at(a)], &q = points[at(b)];
    return std::tie(p.x(), p.y(), a) < std::tie(q.x(), q.y(), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[at(order[i])] = i > 0 && points[at(order[i])] == points[at(order[i - 1])]
                              ? first[at(order[i - 1])]
                              : order[i];
  return first;
}

// Replaces the edges' ends by the smallest index at each place and drops edges of zero length.
std::vector<std::array<int, 2>> byPlace(const std::vector<Vector2d>& points,
                                        const std::vector<std::array<int, 2>>& edges) {
  const std::vector<int> first = firstAtPlace(points);
  std::vector<std::array<int, 2>> out;
  for (const auto& e : edges)
    if (first[at(e[0])] != first[at(e[1])])
      out.push_back({first[at(e[0])], first[at(e[1])]});
  return out;
}

// Occupied points, for finding free places.
class Places {
public:
  explicit Places(double clear) : clear_(clear) {}
  void add(const Vector2d& p) { cells_[key(cellOf(p.x()), cellOf(p.y()))].push_back(p); }
  bool isFree(const Vector2d& p) const {
    for (std::int32_t i = -1; i <= 1; ++i)
      for (std::int32_t j = -1; j <= 1; ++j) {
        const auto cell = cells_.find(key(cellOf(p.x()) + i, cellOf(p.y()) + j));
        if (cell == cells_.end())
          continue;
        for (const Vector2d& other : cell->second)
          if ((other - p).squaredNorm() < clear_ * clear_)
            return false;
      }
    return true;
  }

private:
  std::int32_t cellOf(double x) const { return static_cast<std::int32_t>(std::floor(x / clear_)); }
  static std::uint64_t key(std::int32_t i, std::int32_t j) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32U |
           static_cast<std::uint32_t>(j);
  }
  double clear_;
  std::unordered_map<std::uint64_t, std::vector<Vector2d>> cells_;
};

// Adds inner points of a triangular grid, row by row: between the first and the second crossing of
// a row with the edges, the third and the fourth and so on.
void addInside(RegionMesh& mesh, const std::vector<std::array<int, 2>>& edges, double spacing) {
  Places occupied(kClear * spacing);
  double low = 1e300, high = -1e300;
  for (const auto& e : edges)
    for (const int v : e) {
      occupied.add(mesh.points[at(v)]);
      low = std::min(low, mesh.points[at(v)].y());
      high = std::max(high, mesh.points[at(v)].y());
    }
  const double rise = spacing * std::sqrt(0.75);
  const auto firstRow = static_cast<long>(std::ceil(low / rise));
  const auto lastRow = static_cast<long>(std::floor(high / rise));
  if (lastRow < firstRow)
    return;
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(lastRow - firstRow + 1));
  for (const auto& e : edges) {
    Vector2d a = mesh.points[at(e[0])], b = mesh.points[at(e[1])];
    if (a.y() > b.y())
      std::swap(a, b);
    for (auto row = static_cast<long>(std::ceil(a.y() / rise)); row * rise < b.y(); ++row)
      if (row >= firstRow && row <= lastRow)
        crossings[static_cast<std::size_t>(row - firstRow)].push_back(
            a.x() + (b.x() - a.x()) * (static_cast<double>(row) * rise - a.y()) / (b.y() - a.y()));
  }
  for (long row = firstRow; row <= lastRow; ++row) {
    auto& xs = crossings[static_cast<std::size_t>(row - firstRow)];
    std::sort(xs.begin(), xs.end());
    const double shift = row % 2 == 0 ? 0.0 : 0.5;
    for (std::size_t k = 0; k + 1 < xs.size(); k += 2)
      for (auto i = static_cast<long>(std::ceil(xs[k] / spacing - shift));
           (static_cast<double>(i) + shift) * spacing < xs[k + 1]; ++i) {
        const Vector2d p((static_cast<double>(i) + shift) * spacing,
                         static_cast<double>(row) * rise);
        if (occupied.isFree(p))
          mesh.points.push_back(p);
      }
  }
}

} // namespace

std::optional<RegionMesh> meshRegion(const std::vector<Vector2d>& points,
                                     const std::vector<std::array<int, 2>>& edges, double edgeMm) {
  RegionMesh mesh;
  mesh.points = points;
  std::vector<std::array<int, 2>> pieces;
  for (const auto& e : layers::oddEdges(byPlace(points, edges))) {
    const Vector2d a = points[at(e[0])], b = points[at(e[1])];
    const int n = std::max(1, static_cast<int>(std::ceil((b - a).norm() / edgeMm)));
    int from = e[0];
    for (int k = 1; k <= n; ++k) {
      int to = e[1];
      if (k < n) {
        const double t = static_cast<double>(k) / n;
        to = static_cast<int>(mesh.points.size());
        mesh.points.push_back((1.0 - t) * a + t * b);
        mesh.splits.push_back({e[0], e[1], t});
      }
      pieces.push_back({from, to});
      from = to;
    }
  }
  if (pieces.empty())
    return mesh;
  const std::size_t boundary = mesh.points.size();
  addInside(mesh, pieces, edgeMm);

  layers::Triangulation t;
  std::vector<layers::Triangulation::Vertex_handle> vertex(boundary);
  layers::Triangulation::Vertex_handle last; // the next point is near it
  const auto insert = [&](int i) {
    const Vector2d& p = mesh.points[at(i)];
    const std::size_t before = t.number_of_vertices();
    const auto inserted =
        t.insert(layers::Kernel::Point_2(p.x(), p.y()),
                 last == nullptr ? layers::Triangulation::Face_handle() : last->face());
    if (t.number_of_vertices() > before)
      inserted->info() = i;
    last = inserted;
    return inserted;
  };
  const auto vertexOf = [&](int i) {
    auto& known = vertex[at(i)];
    if (known == nullptr)
      known = insert(i);
    return known;
  };
  try {
    for (const auto& e : pieces) {
      const auto a = vertexOf(e[0]), b = vertexOf(e[1]);
      if (a == b)
        return std::nullopt;
      t.insert_constraint(a, b);
    }
  } catch (const layers::Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  for (std::size_t i = boundary; i < mesh.points.size(); ++i)
    insert(static_cast<int>(i));
  mesh.triangles = layers::insideTriangles(t);
  return mesh;
}

} // namespace voluta::planar
