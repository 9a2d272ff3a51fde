#include "curved/convex_hull.h"

#include "base/error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::curved {

namespace {

struct Facet {
  std::array<int, 3> corner;
  std::array<int, 3> neighbour{-1, -1, -1}; // Neighbour across the side corner[s] -> corner[s + 1]
  Eigen::Vector3d normal;
  double offset = 0.0;
  int firstOutside = -1; // First of the points in front of it, linked through next_
  int furthest = -1;
  double furthestDistance = 0.0;
  int visit = 0;
  bool alive = true;
};

class Quickhull {
public:
  explicit Quickhull(const std::vector<LatticePoint>& points)
      : points_(points), next_(points.size(), -1), facetFrom_(points.size(), -1) {}

  std::vector<HullFacet> run() {
    if (!startTetrahedron())
      return {};
    for (std::size_t f = 0; f < facets_.size(); ++f)
      if (facets_[f].alive && facets_[f].furthest >= 0)
        grow(static_cast<int>(f));
    std::vector<HullFacet> out;
    for (const Facet& f : facets_)
      if (f.alive)
        out.push_back({f.corner, f.normal, f.offset});
    return out;
  }

private:
  const LatticePoint& point(int i) const { return points_[static_cast<std::size_t>(i)]; }
  Facet& facet(int i) { return facets_[static_cast<std::size_t>(i)]; }

  double distance(const Facet& f, int p) const { return f.normal.dot(point(p)) - f.offset; }

  int addFacet(int a, int b, int c) {
    Facet f;
    f.corner = {a, b, c};
    f.normal = (point(b) - point(a)).cross(point(c) - point(a));
    f.offset = f.normal.dot(point(a));
    facets_.push_back(f);
    return static_cast<int>(facets_.size()) - 1;
  }

  // Adds p to the list of the first of the facets [first, end) that it is in front of.
  void assign(int p, std::size_t first) {
    for (std::size_t f = first; f < facets_.size(); ++f) {
      const double d = distance(facets_[f], p);
      if (d <= 0.0)
        continue;
      next_[static_cast<std::size_t>(p)] = facets_[f].firstOutside;
      facets_[f].firstOutside = p;
      if (d > facets_[f].furthestDistance) {
        facets_[f].furthestDistance = d;
        facets_[f].furthest = p;
      }
      return;
    }
  }

  bool startTetrahedron() {
    const int n = static_cast<int>(points_.size());
    if (n < 4)
      return false;
    int a = 0, b = 0, c = -1, d = -1;
    const auto before = [&](int p, int q) {
      return std::lexicographical_compare(point(p).data(), point(p).data() + 3, point(q).data(),
                                          point(q).data() + 3);
    };
    for (int i = 1; i < n; ++i) {
      if (before(i, a))
        a = i;
      if (before(b, i))
        b = i;
    }
    double best = 0.0;
    for (int i = 0; i < n; ++i) {
      const double s = (point(b) - point(a)).cross(point(i) - point(a)).squaredNorm();
      if (s > best) {
        best = s;
        c = i;
      }
    }
    if (c < 0)
      return false;
    const Eigen::Vector3d normal = (point(b) - point(a)).cross(point(c) - point(a));
    best = 0.0;
    for (int i = 0; i < n; ++i) {
      const double s = std::abs(normal.dot(point(i) - point(a)));
      if (s > best) {
        best = s;
        d = i;
      }
    }
    if (d < 0)
      return false;
    if (normal.dot(point(d) - point(a)) > 0.0)
      std::swap(b, c);
    // Outward: d is behind abc.
    addFacet(a, b, c);
    addFacet(a, d, b);
    addFacet(b, d, c);
    addFacet(c, d, a);
    for (int f = 0; f < 4; ++f)
      for (int s = 0; s < 3; ++s)
        for (int g = 0; g < 4; ++g)
          for (int t = 0; t < 3; ++t)
            if (corner(f, s) == corner(g, t + 1) && corner(f, s + 1) == corner(g, t))
              facet(f).neighbour[static_cast<std::size_t>(s)] = g;
    for (int i = 0; i < n; ++i)
      if (i != a && i != b && i != c && i != d)
        assign(i, 0);
    return true;
  }

  int corner(int f, int s) { return facet(f).corner[static_cast<std::size_t>(s % 3)]; }

  // Adds the point that is farthest in front of facet `start`.
  void grow(int start) {
    const int p = facet(start).furthest;
    ++visit_;
    visible_.assign(1, start);
    facet(start).visit = visit_;
    horizon_.clear();
    for (std::size_t v = 0; v < visible_.size(); ++v)
      for (int s = 0; s < 3; ++s) {
        const int f = visible_[v], g = facet(f).neighbour[static_cast<std::size_t>(s)];
        if (facet(g).visit == visit_)
          continue;
        if (distance(facet(g), p) > 0.0) {
          facet(g).visit = visit_;
          visible_.push_back(g);
        } else {
          horizon_.push_back({corner(f, s), corner(f, s + 1), g});
        }
      }

    // A side is added before its far facet is classified only if that facet is not visible, so the
    // horizon is final. It is one cycle: each corner starts exactly one side of it.
    const std::size_t firstNew = facets_.size();
    for (const Side& side : horizon_) {
      const int f = addFacet(side.from, side.to, p);
      facet(f).neighbour[0] = side.beyond;
      for (int s = 0; s < 3; ++s)
        if (corner(side.beyond, s) == side.to && corner(side.beyond, s + 1) == side.from)
          facet(side.beyond).neighbour[static_cast<std::size_t>(s)] = f;
      facetFrom_[static_cast<std::size_t>(side.from)] = f;
    }
    for (std::size_t i = 0; i < horizon_.size(); ++i) {
      const int f = static_cast<int>(firstNew + i);
      const int after = facetFrom_[static_cast<std::size_t>(horizon_[i].to)];
      facet(f).neighbour[1] = after;
      facet(after).neighbour[2] = f;
    }
    for (const int f : visible_) {
      facet(f).alive = false;
      for (int q = facet(f).firstOutside; q >= 0;) {
        const int following = next_[static_cast<std::size_t>(q)];
        if (q != p)
          assign(q, firstNew);
        q = following;
      }
    }
  }

  struct Side {
    int from, to, beyond;
  };

  const std::vector<LatticePoint>& points_;
  std::vector<Facet> facets_;
  std::vector<int> next_, facetFrom_, visible_;
  std::vector<Side> horizon_;
  int visit_ = 0;
};

} // namespace

std::vector<HullFacet> convexHull(const std::vector<LatticePoint>& points) {
  for (const LatticePoint& p : points)
    base::require(p.cwiseAbs().maxCoeff() <= kLatticeLimit && p == p.array().round().matrix(),
                  "convexHull: integer coordinates within the lattice");
  return Quickhull(points).run();
}

} // namespace voluta::curved
