#include "planar/plane_cut.h"

#include "base/error.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "layers/region_fill.h"
#include "planar/nudged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace voluta::planar {

using Eigen::Vector3d;
using geometry::TriangleMesh;

namespace {

struct Solids {
  std::size_t count = 0;
  std::vector<std::size_t> ofTriangle;
};

Solids solidsOf(const TriangleMesh& mesh) {
  const geometry::Components parts = geometry::components(mesh);
  const auto count = static_cast<std::size_t>(parts.count);
  std::vector<TriangleMesh> shell(count);
  std::vector<double> volume(count, 0.0);
  const Vector3d middle = mesh.vertices.empty() ? Vector3d::Zero() : mesh.vertices.front();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    volume[static_cast<std::size_t>(parts.ofTriangle[t])] +=
        (mesh.corner(t, 0) - middle)
            .dot((mesh.corner(t, 1) - middle).cross(mesh.corner(t, 2) - middle)) /
        6.0;
  const auto shellOf = [&](std::size_t c) -> const TriangleMesh& {
    if (shell[c].empty()) {
      std::vector<bool> keep(mesh.triangles.size());
      for (std::size_t t = 0; t < keep.size(); ++t)
        keep[t] = parts.ofTriangle[t] == static_cast<int>(c);
      shell[c] = geometry::subMesh(mesh, keep);
    }
    return shell[c];
  };
  // A cavity belongs to the smallest solid that contains a point of it.
  std::vector<std::size_t> owner(count);
  for (std::size_t c = 0; c < count; ++c) {
    owner[c] = c;
    if (volume[c] >= 0.0)
      continue;
    std::optional<std::size_t> best;
    for (std::size_t o = 0; o < count; ++o)
      if (volume[o] > -volume[c] && (!best || volume[o] < volume[*best]) &&
          geometry::MeshQuery(shellOf(o)).inside(shellOf(c).vertices.front()))
        best = o;
    if (best)
      owner[c] = *best;
  }
  Solids out;
  std::vector<std::size_t> index(count, count);
  for (std::size_t c = 0; c < count; ++c)
    if (owner[c] == c)
      index[c] = out.count++;
  out.ofTriangle.reserve(mesh.triangles.size());
  for (const int c : parts.ofTriangle)
    out.ofTriangle.push_back(index[owner[static_cast<std::size_t>(c)]]);
  return out;
}

TaggedMesh pick(const TaggedMesh& mesh, const Solids& parts, std::size_t solid) {
  TaggedMesh out;
  std::vector<bool> keep(mesh.mesh.triangles.size());
  for (std::size_t t = 0; t < keep.size(); ++t) {
    keep[t] = parts.ofTriangle[t] == solid;
    if (keep[t])
      out.tag.push_back(mesh.tag[t]);
  }
  out.mesh = geometry::subMesh(mesh.mesh, keep);
  return out;
}

constexpr double kOnPlane = 1e-9; // relative to the mesh's size

// One attempt at a cut; all sides share one set of vertices.
class Cutter {
public:
  Cutter(const TaggedMesh& in, const Plane& plane, std::int32_t tag)
      : in_(in), plane_(plane), tag_(tag), vertices_(in.mesh.vertices) {
    const Eigen::AlignedBox3d box = geometry::bounds(in.mesh);
    const double slack = kOnPlane * (box.isEmpty() ? 1.0 : box.diagonal().norm());
    height_.reserve(vertices_.size());
    for (const Vector3d& v : vertices_) {
      const double h = plane.heightOf(v);
      height_.push_back(std::abs(h) <= slack ? 0.0 : h);
    }
  }

  // Returns nullopt if the section does not close.
  std::optional<PlaneCut> run(const Wanted& wanted) {
    split();
    const auto cap = capTriangles();
    if (!cap)
      return std::nullopt;
    const std::size_t skin = above_.size();
    for (const auto& t : *cap) {
      above_.push_back({t[0], t[2], t[1]});
      aboveTag_.push_back(tag_);
    }
    const TaggedMesh above = side(above_, aboveTag_);
    if (!isClosed(above.mesh))
      return std::nullopt;
    PlaneCut out;
    out.offsetMm = plane_.offsetMm;
    const Solids parts = solidsOf(above.mesh);
    constexpr std::int32_t kStays = -1;
    std::vector<std::int32_t> cutOff(parts.count, kStays); // index among the cut-off solids
    for (std::size_t s = 0; s < parts.count; ++s) {
      TaggedMesh solid = pick(above, parts, s);
      if (wanted && !wanted(solid))
        continue;
      cutOff[s] = static_cast<std::int32_t>(out.above.size());
      for (std::int32_t& tag : solid.tag)
        tag += tag == tag_ ? cutOff[s] : 0;
      out.above.push_back(std::move(solid));
    }
    for (std::size_t t = 0; t < above_.size(); ++t) {
      const std::int32_t place = cutOff[parts.ofTriangle[t]];
      const bool isCutOff = place != kStays;
      if (t < skin) {
        if (!isCutOff)
          give(false, above_[t], aboveTag_[t]);
      } else if (isCutOff) {
        const auto& c = (*cap)[t - skin];
        give(false, c, tag_ + place);
        out.sectionMm2 += 0.5 * (point(c[1]) - point(c[0])).cross(point(c[2]) - point(c[0])).norm();
      }
    }
    out.below = side(below_, belowTag_);
    if (!isClosed(out.below.mesh))
      return std::nullopt;
    return out;
  }

  TaggedMesh splitOnly() {
    split();
    below_.insert(below_.end(), above_.begin(), above_.end());
    belowTag_.insert(belowTag_.end(), aboveTag_.begin(), aboveTag_.end());
    return side(below_, belowTag_);
  }

private:
  using Triangle = std::array<int, 3>;

  const Vector3d& point(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
  double heightAt(int v) const {
    return static_cast<std::size_t>(v) < height_.size() ? height_[static_cast<std::size_t>(v)]
                                                        : 0.0;
  }

  // Returns the intersection point of edge a b with the plane: the same for both triangles at the
  // edge.
  int crossing(int a, int b) {
    if (a > b)
      std::swap(a, b);
    const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U |
                              static_cast<std::uint32_t>(b);
    const auto [at, fresh] = crossings_.try_emplace(key, static_cast<int>(vertices_.size()));
    if (fresh) {
      const double ha = heightAt(a), hb = heightAt(b);
      const double t = ha / (ha - hb);
      vertices_.push_back(point(a) + t * (point(b) - point(a)));
    }
    return at->second;
  }

  void give(bool above, const Triangle& t, std::int32_t tag) {
    (above ? above_ : below_).push_back(t);
    (above ? aboveTag_ : belowTag_).push_back(tag);
  }

  void split() {
    for (std::size_t i = 0; i < in_.mesh.triangles.size(); ++i) {
      Triangle t = in_.mesh.triangles[i];
      const std::int32_t tag = in_.tag[i];
      int ups = 0, downs = 0;
      for (const int v : t) {
        ups += heightAt(v) > 0.0;
        downs += heightAt(v) < 0.0;
      }
      if (ups == 0 && downs == 0) {
        // The triangle's solid is behind it.
        const Vector3d n = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
        give(n.dot(plane_.normal) < 0.0, t, tag);
      } else if (downs == 0 || ups == 0) {
        give(ups > 0, t, tag);
      } else if (ups == 1 && downs == 1) {
        while (heightAt(t[0]) != 0.0)
          t = {t[1], t[2], t[0]};
        const int cut = crossing(t[1], t[2]);
        give(heightAt(t[1]) > 0.0, {t[0], t[1], cut}, tag);
        give(heightAt(t[2]) > 0.0, {t[0], cut, t[2]}, tag);
      } else {
        const bool lonelyIsUp = ups == 1;
        while ((heightAt(t[0]) > 0.0) != lonelyIsUp || heightAt(t[0]) == 0.0)
          t = {t[1], t[2], t[0]};
        const int p = crossing(t[0], t[1]), q = crossing(t[2], t[0]);
        give(lonelyIsUp, {t[0], p, q}, tag);
        give(!lonelyIsUp, {p, t[1], t[2]}, tag);
        give(!lonelyIsUp, {p, t[2], q}, tag);
      }
    }
  }

  // Returns the triangles that close the side below, facing up.
  std::optional<std::vector<Triangle>> capTriangles() const {
    // Sides without a partner among the triangles below.
    std::unordered_map<std::uint64_t, int> surplus;
    const auto key = [](int a, int b) {
      return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U |
             static_cast<std::uint32_t>(b);
    };
    for (const Triangle& t : below_)
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if (a < b)
          ++surplus[key(a, b)];
        else
          --surplus[key(b, a)];
      }
    std::vector<std::array<int, 2>> rim;
    for (const auto& [edge, count] : surplus)
      if (count != 0) {
        const int a = static_cast<int>(edge >> 32U), b = static_cast<int>(edge & 0xffffffffU);
        if (std::abs(count) > 1 || heightAt(a) != 0.0 || heightAt(b) != 0.0)
          return std::nullopt;
        rim.push_back({a, b});
      }
    std::sort(rim.begin(), rim.end());
    const PlaneFrame frame = frameOf(plane_.normal);
    std::unordered_map<int, int> local;
    std::vector<Eigen::Vector2d> points;
    std::vector<int> vertexOf;
    const auto localOf = [&](int v) {
      const auto [at, fresh] = local.try_emplace(v, static_cast<int>(points.size()));
      if (fresh) {
        points.emplace_back(frame.across.dot(point(v)), frame.along.dot(point(v)));
        vertexOf.push_back(v);
      }
      return at->second;
    };
    std::vector<std::array<int, 2>> edges;
    for (const auto& e : rim)
      edges.push_back({localOf(e[0]), localOf(e[1])});
    auto filled = layers::fillRegion(points, edges);
    if (!filled)
      return std::nullopt;
    for (auto& t : *filled)
      for (int& v : t)
        v = vertexOf[static_cast<std::size_t>(v)];
    return filled;
  }

  TaggedMesh side(const std::vector<Triangle>& triangles, const std::vector<std::int32_t>& tags) {
    TaggedMesh out;
    std::vector<int> index(vertices_.size(), -1);
    for (Triangle t : triangles) {
      for (int& v : t) {
        int& known = index[static_cast<std::size_t>(v)];
        if (known < 0) {
          known = static_cast<int>(out.mesh.vertices.size());
          out.mesh.vertices.push_back(point(v));
        }
        v = known;
      }
      out.mesh.triangles.push_back(t);
    }
    out.tag = tags;
    return out;
  }

  const TaggedMesh& in_;
  const Plane& plane_;
  std::int32_t tag_;
  // vertices of the mesh, then intersection points of edges with the plane
  std::vector<Vector3d> vertices_;
  std::vector<double> height_; // of the mesh's vertices
  std::unordered_map<std::uint64_t, int> crossings_;
  std::vector<Triangle> below_, above_;
  std::vector<std::int32_t> belowTag_, aboveTag_;
};

} // namespace

TaggedMesh tagged(const TriangleMesh& mesh) {
  return {mesh, std::vector<std::int32_t>(mesh.triangles.size(), kSkin)};
}

bool isClosed(const TriangleMesh& mesh) {
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(mesh);
  bool closed = true;
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    int balance = 0;
    for (std::size_t i = begin; i < end; ++i)
      balance += sides[i].forward ? 1 : -1;
    closed = closed && balance == 0;
  });
  return closed;
}

PlaneCut cutByPlane(const TaggedMesh& mesh, const Plane& plane, std::int32_t tag,
                    const Wanted& wanted) {
  base::require(mesh.tag.size() == mesh.mesh.triangles.size() && isClosed(mesh.mesh),
                "cutByPlane: a closed mesh, a tag a triangle");
  return atOrNear(plane.offsetMm, [&](double offsetMm) {
    return Cutter(mesh, {plane.normal, offsetMm}, tag).run(wanted);
  });
}

TaggedMesh splitAlong(const TaggedMesh& mesh, const Plane& plane) {
  base::require(mesh.tag.size() == mesh.mesh.triangles.size(), "splitAlong: a tag a triangle");
  return Cutter(mesh, plane, 0).splitOnly();
}

std::vector<TaggedMesh> solids(const TaggedMesh& mesh) {
  const Solids parts = solidsOf(mesh.mesh);
  std::vector<TaggedMesh> out;
  for (std::size_t s = 0; s < parts.count; ++s)
    out.push_back(pick(mesh, parts, s));
  return out;
}

} // namespace voluta::planar
