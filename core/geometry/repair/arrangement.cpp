#include "geometry/repair/arrangement.h"

#include "geometry/edges.h"
#include "geometry/measures.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <boost/variant/get.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <variant>

namespace voluta::geometry {

namespace {

using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Exact::Point_3;
using Index = std::size_t;

// Returns what an intersection is, nullptr if it is none of that kind. CGAL holds it in a variant
// of Boost up to version 5, and in one of the standard library from 6 on.
template <typename T, typename Held> const T* heldAs(const Held& held) {
  if constexpr (requires { boost::get<T>(&held); })
    return boost::get<T>(&held);
  else
    return std::get_if<T>(&held);
}

Index index(int i) {
  return static_cast<Index>(i);
}

// Exact points, with one id for all equal ones.
class Points {
public:
  int idOf(const Point& p) {
    const auto [entry, isNew] = ids_.emplace(p, static_cast<int>(points_.size()));
    if (isNew)
      points_.push_back(p);
    return entry->second;
  }
  const Point& operator[](int id) const { return points_[index(id)]; }
  std::size_t size() const { return points_.size(); }

private:
  std::map<Point, int, Exact::Less_xyz_3> ids_;
  std::vector<Point> points_;
};

// An intersection segment given by its ends; equal ends: a point.
using Segment = std::pair<int, int>;

class Intersections {
public:
  Intersections(const TriangleMesh& mesh, Points& points) : mesh_(mesh), points_(points) {
    for (const auto& v : mesh.vertices) {
      filtered_.emplace_back(v.x(), v.y(), v.z());
      ids_.push_back(-1);
    }
  }

  // Returns the id of a vertex of the mesh.
  int idOf(int vertex) {
    int& id = ids_[index(vertex)];
    if (id < 0)
      id = points_.idOf(exact(vertex));
    return id;
  }
  // Returns the intersection of two triangles.
  std::vector<Segment> segments(int a, int b) {
    if (const std::optional<Segment> segment = crossing(a, b))
      return {*segment};
    return general(a, b);
  }
  bool coplanar(int a, int b) const {
    for (int k = 0; k < 3; ++k)
      if (CGAL::orientation(at(a, 0), at(a, 1), at(a, 2), at(b, k)) != CGAL::COPLANAR)
        return false;
    return true;
  }
  int vertex(int t, int k) const { return mesh_.triangles[index(t)][index(k % 3)]; }

private:
  const Filtered::Point_3& at(int t, int k) const { return filtered_[index(vertex(t, k))]; }
  Point exact(int v) const {
    const Filtered::Point_3& p = filtered_[index(v)];
    return {p.x(), p.y(), p.z()};
  }

  enum class Pierces { No, Yes, Touches };
  // Returns whether side k of t passes through the interior of `other`; any degenerate position
  // counts as Touches.
  Pierces pierces(int t, int k, int other) const {
    const Filtered::Point_3 &p = at(t, k), &q = at(t, k + 1);
    const auto side = [&](const Filtered::Point_3& x) {
      return CGAL::orientation(at(other, 0), at(other, 1), at(other, 2), x);
    };
    const CGAL::Orientation from = side(p), to = side(q);
    if (from == CGAL::COPLANAR || to == CGAL::COPLANAR)
      return Pierces::Touches;
    if (from == to)
      return Pierces::No;
    std::array<CGAL::Orientation, 3> sign{};
    for (int i = 0; i < 3; ++i) {
      sign[index(i)] = CGAL::orientation(p, q, at(other, i), at(other, i + 1));
      if (sign[index(i)] == CGAL::COPLANAR)
        return Pierces::Touches;
    }
    return sign[0] == sign[1] && sign[1] == sign[2] ? Pierces::Yes : Pierces::No;
  }

  int pierced(int t, int k, int other) {
    const int p = vertex(t, k), q = vertex(t, k + 1);
    const std::tuple<int, int, int> key{std::min(p, q), std::max(p, q), other};
    const auto known = pierced_.find(key);
    if (known != pierced_.end())
      return known->second;
    const Exact::Plane_3 plane(exact(vertex(other, 0)), exact(vertex(other, 1)),
                               exact(vertex(other, 2)));
    const auto cut =
        CGAL::intersection(plane, Exact::Line_3(exact(std::get<0>(key)), exact(std::get<1>(key))));
    return pierced_.emplace(key, points_.idOf(*heldAs<Point>(*cut))).first->second;
  }

  // Returns the common segment of triangles in general position; nullopt if they are not.
  std::optional<Segment> crossing(int a, int b) {
    std::vector<int> ends;
    for (const auto& [t, other] : {std::pair(a, b), std::pair(b, a)})
      for (int k = 0; k < 3; ++k) {
        const Pierces how = pierces(t, k, other);
        if (how == Pierces::Touches)
          return std::nullopt;
        if (how == Pierces::Yes)
          ends.push_back(pierced(t, k, other));
      }
    if (ends.size() != 2)
      return std::nullopt;
    return Segment{ends[0], ends[1]};
  }

  std::vector<Segment> general(int a, int b) {
    const auto triangle = [&](int t) {
      return Exact::Triangle_3(exact(vertex(t, 0)), exact(vertex(t, 1)), exact(vertex(t, 2)));
    };
    const auto common = CGAL::intersection(triangle(a), triangle(b));
    if (!common)
      return {};
    if (const auto* point = heldAs<Point>(*common)) {
      const int id = points_.idOf(*point);
      return {{id, id}};
    }
    if (const auto* segment = heldAs<Exact::Segment_3>(*common))
      return {{points_.idOf(segment->source()), points_.idOf(segment->target())}};
    std::vector<Point> polygon;
    if (const auto* whole = heldAs<Exact::Triangle_3>(*common))
      polygon = {whole->vertex(0), whole->vertex(1), whole->vertex(2)};
    else
      polygon = *heldAs<std::vector<Point>>(*common);
    std::vector<Segment> sides;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      sides.emplace_back(points_.idOf(polygon[i]), points_.idOf(polygon[(i + 1) % polygon.size()]));
    return sides;
  }

  const TriangleMesh& mesh_;
  Points& points_;
  std::vector<Filtered::Point_3> filtered_;
  std::vector<int> ids_;
  std::map<std::tuple<int, int, int>, int> pierced_;
};

// Overlapping coplanar triangles, with all segments that cross them.
struct Cluster {
  std::vector<int> triangles;
  std::vector<Segment> segments;
};

struct VertexInfo {
  int id = -1; // of the exact point; -1: created where constraints cross
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Exact>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Exact>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Exact, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::Exact_intersections_tag>;

// Splits the triangles of a cluster, projected along the axis nearest to their normal.
class Splitting {
public:
  Splitting(const TriangleMesh& mesh, Intersections& vertices, Points& points)
      : mesh_(mesh), vertices_(vertices), points_(points) {}

  void split(const Cluster& cluster, Arrangement& out) {
    choosePlane(cluster.triangles.front());
    Triangulation flat;
    handles_.clear();
    for (const int t : cluster.triangles)
      for (int k = 0; k < 3; ++k)
        constrain(flat, {corner(t, k), corner(t, k + 1)});
    for (const Segment& segment : cluster.segments)
      constrain(flat, segment);
    for (const auto face : flat.finite_face_handles())
      addFace(face, cluster, out);
  }

private:
  int corner(int t, int k) { return vertices_.idOf(vertices_.vertex(t, k)); }

  void choosePlane(int t) {
    // Do not use the largest component: coplanar triangles have to choose the same axis, and at 45
    // degrees rounding would make them differ. No common angle has this sine.
    constexpr double kFlatEnough = 0.4567;
    const Eigen::Vector3d normal = triangleNormal(mesh_, index(t));
    axis_ = 2;
    while (axis_ > 0 && std::abs(normal[axis_]) < kFlatEnough)
      --axis_;
    plane_ = Exact::Plane_3(points_[corner(t, 0)], points_[corner(t, 1)], points_[corner(t, 2)]);
  }
  Exact::Point_2 flattened(const Point& p) const {
    return {p[(axis_ + 1) % 3], p[(axis_ + 2) % 3]};
  }
  Point lifted(const Exact::Point_2& p) const {
    const std::array<Exact::FT, 3> n{plane_.a(), plane_.b(), plane_.c()};
    const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    std::array<Exact::FT, 3> x;
    x[index(i)] = p.x();
    x[index(j)] = p.y();
    x[index(axis_)] = -(n[index(i)] * p.x() + n[index(j)] * p.y() + plane_.d()) / n[index(axis_)];
    return {x[0], x[1], x[2]};
  }

  Triangulation::Vertex_handle handleOf(Triangulation& flat, int id) {
    const auto known = handles_.find(id);
    if (known != handles_.end())
      return known->second;
    const auto handle = flat.insert(flattened(points_[id]));
    handle->info().id = id;
    handles_.emplace(id, handle);
    return handle;
  }
  void constrain(Triangulation& flat, const Segment& segment) {
    const auto from = handleOf(flat, segment.first), to = handleOf(flat, segment.second);
    if (from != to)
      flat.insert_constraint(from, to);
  }

  void addFace(Triangulation::Face_handle face, const Cluster& cluster, Arrangement& out) {
    std::array<Exact::Point_2, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[index(k)] = face->vertex(k)->point();
    int layers = 0;
    if (cluster.triangles.size() == 1) {
      layers = signOf(cluster.triangles.front());
    } else {
      const Exact::Point_2 middle = CGAL::centroid(corners[0], corners[1], corners[2]);
      for (const int t : cluster.triangles)
        if (contains(t, middle))
          layers += signOf(t);
    }
    if (layers == 0)
      return;
    std::array<int, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
      const auto vertex = face->vertex(k);
      int& id = vertex->info().id;
      if (id < 0)
        id = points_.idOf(lifted(vertex->point()));
      triangle[index(k)] = id;
    }
    if (layers < 0)
      std::swap(triangle[1], triangle[2]);
    out.facets.triangles.push_back(triangle);
    out.layers.push_back(std::abs(layers));
  }

  // Returns 1 if the projected triangle is counter-clockwise, otherwise -1.
  int signOf(int t) {
    const auto at = [&](int k) { return flattened(points_[corner(t, k)]); };
    return CGAL::orientation(at(0), at(1), at(2)) == CGAL::LEFT_TURN ? 1 : -1;
  }
  // Returns whether no side of the triangle separates it from `p`.
  bool contains(int t, const Exact::Point_2& p) {
    const auto at = [&](int k) { return flattened(points_[corner(t, k)]); };
    const CGAL::Orientation sign = CGAL::orientation(at(0), at(1), at(2));
    for (int k = 0; k < 3; ++k)
      if (CGAL::orientation(at(k), at((k + 1) % 3), p) != sign)
        return false;
    return true;
  }

  const TriangleMesh& mesh_;
  Intersections& vertices_;
  Points& points_;
  int axis_ = 2; // projection axis
  Exact::Plane_3 plane_;
  std::unordered_map<int, Triangulation::Vertex_handle> handles_;
};

bool isDegenerate(const TriangleMesh& mesh, Index t) {
  const auto at = [&](int k) {
    const Eigen::Vector3d& p = mesh.corner(t, k);
    return Filtered::Point_3(p.x(), p.y(), p.z());
  };
  return CGAL::collinear(at(0), at(1), at(2));
}

// Rounds the vertices to double and merges those of equal coordinates.
void setVertices(const Points& points, Arrangement& arrangement) {
  std::map<std::array<double, 3>, int> known;
  std::vector<int> rounded(points.size(), -1);
  TriangleMesh& mesh = arrangement.facets;
  const auto vertexOf = [&](int id) {
    int& vertex = rounded[index(id)];
    if (vertex >= 0)
      return vertex;
    const auto& p = CGAL::exact(points[id]);
    const std::array<double, 3> at{CGAL::to_double(p.x()) + 0.0, CGAL::to_double(p.y()) + 0.0,
                                   CGAL::to_double(p.z()) + 0.0};
    const auto [entry, isNew] = known.emplace(at, static_cast<int>(mesh.vertices.size()));
    if (isNew)
      mesh.vertices.emplace_back(at[0], at[1], at[2]);
    return vertex = entry->second;
  };
  Index kept = 0;
  for (Index f = 0; f < mesh.triangles.size(); ++f) {
    std::array<int, 3> t = mesh.triangles[f];
    for (int& v : t)
      v = vertexOf(v);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      continue; // collapsed by rounding
    mesh.triangles[kept] = t;
    arrangement.layers[kept++] = arrangement.layers[f];
  }
  mesh.triangles.resize(kept);
  arrangement.layers.resize(kept);
}

} // namespace

Arrangement arrange(const TriangleMesh& mesh, const std::vector<std::pair<int, int>>& pairs,
                    const base::RunContext& ctx) {
  Points points;
  Intersections intersections(mesh, points);
  UnionFind planes(mesh.triangles.size());
  std::vector<std::vector<Segment>> segments(mesh.triangles.size());
  for (Index i = 0; i < pairs.size(); ++i) {
    if (i % 256 == 0)
      ctx.checkpoint();
    const auto& [a, b] = pairs[i];
    if (intersections.coplanar(a, b))
      planes.join(a, b);
    for (const Segment& segment : intersections.segments(a, b)) {
      segments[index(a)].push_back(segment);
      segments[index(b)].push_back(segment);
    }
  }
  std::map<int, Cluster> clusters;
  Arrangement out;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const int triangle = static_cast<int>(t);
    if (isDegenerate(mesh, t))
      continue;
    if (!segments[t].empty()) {
      Cluster& cluster = clusters[planes.find(triangle)];
      cluster.triangles.push_back(triangle);
      cluster.segments.insert(cluster.segments.end(), segments[t].begin(), segments[t].end());
      continue;
    }
    std::array<int, 3> whole{};
    for (int k = 0; k < 3; ++k)
      whole[index(k)] = intersections.idOf(intersections.vertex(triangle, k));
    out.facets.triangles.push_back(whole);
    out.layers.push_back(1);
  }
  Splitting splitting(mesh, intersections, points);
  std::size_t done = 0;
  for (const auto& [root, cluster] : clusters) {
    if (++done % 64 == 0)
      ctx.checkpoint();
    splitting.split(cluster, out);
  }
  setVertices(points, out);
  return out;
}

} // namespace voluta::geometry
