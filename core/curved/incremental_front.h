// A convex hull that grows point by point and reports, before a point is added, which guarded
// points the larger hull would swallow.
#pragma once

#include "curved/convex_hull.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// Whether the boundary of a hull counts as outside (definition 3 of the dissertation with epsilon =
// 0) or as inside (the thesis).
enum class Boundary { Outside, Inside };

// Exact, as convexHull(): signs of integers. Points are identified by their index.
//
// A guarded point that is outside has a facet with the point in front of it. Adding a corner
// replaces the facets that it sees by a cone of new ones. Only guarded points in front of a removed
// facet can come inside, and they do when they are behind the whole cone. So each guarded point is
// on the list of one facet, and the cost of a query depends on the facets that the corner sees, not
// on the whole hull.
class IncrementalFront {
public:
  // Keeps a reference to the points. There is no hull yet: every point is outside.
  IncrementalFront(const std::vector<LatticePoint>& points, Boundary boundary)
      : points_(&points), above_(boundary == Boundary::Outside ? -0.5 : 0.5) {}

  bool empty() const { return size_ == 0; }
  std::size_t facetCount() const { return size_; }

  // Builds the hull of these points from scratch, without guarded points. Stays empty if they are
  // in one plane.
  void build(const std::vector<std::int32_t>& corners);

  bool inside(std::int32_t p) const { return !empty() && facetBefore(p, above_) < 0; }
  // Returns whether one facet has the whole box in front of it. May return false for a box that is
  // outside only with respect to several facets together.
  bool boxOutside(const Eigen::Vector3d& centre, const Eigen::Vector3d& halfSize) const;

  // Extends the hull by p; nothing changes if p is inside it. Guarded points that come inside are
  // no longer guarded and are appended to `swallowed`. Precondition: not empty().
  void add(std::int32_t p, std::vector<std::int32_t>& swallowed);

  // Precondition: p is outside, not empty().
  void guard(std::int32_t p);
  void clearGuards();
  // Returns the number of guarded points that adding p would swallow; counting stops at `enough`.
  std::size_t wouldSwallow(std::int32_t p, std::size_t enough);

private:
  struct Facet {
    std::array<std::int32_t, 3> corner;
    std::array<std::int32_t, 3> neighbour; // Across the side corner[s] -> corner[s + 1]
    std::int32_t firstGuard = -1;
    std::uint32_t seen = 0;
  };
  struct Side {
    std::int32_t from, to, beyond;
  };
  struct Plane {
    Eigen::Vector3d normal;
    double offset;
  };
  struct Guard {
    std::int32_t point, next;
  };

  const LatticePoint& point(std::int32_t i) const {
    return (*points_)[static_cast<std::size_t>(i)];
  }
  double distance(std::int32_t f, const LatticePoint& p) const {
    const auto i = static_cast<std::size_t>(f);
    return nx_[i] * p.x() + ny_[i] * p.y() + nz_[i] * p.z() - offset_[i];
  }
  // Returns a facet with p further in front than `above`, or -1.
  std::int32_t facetBefore(std::int32_t p, double above) const;
  std::int32_t anyFacetBefore(const LatticePoint& at, double above) const;
  // Finds visible_, horizon_ and cone_ of p. Returns false if p sees no facet.
  bool look(std::int32_t p);
  bool behindCone(std::int32_t p) const;
  std::int32_t newFacet(const std::array<std::int32_t, 3>& corner, const Plane& plane);
  void link(std::int32_t guard, std::int32_t facet);

  const std::vector<LatticePoint>* points_;
  double above_; // A point is outside a facet if it is further in front than this
  std::vector<Facet> facets_;
  std::vector<double> nx_, ny_, nz_, offset_; // Per facet; a free slot has everything behind it
  std::vector<std::int32_t> free_;
  std::size_t size_ = 0;
  std::vector<Guard> guards_;
  LatticePoint heart_ = LatticePoint::Zero(); // Strictly inside, if such a point exists
  bool hasHeart_ = false;
  mutable std::int32_t hint_ = 0; // Last facet found; speeds up queries, does not change results
  std::uint32_t look_ = 0;
  std::vector<std::int32_t> visible_, made_;
  std::vector<Side> horizon_;
  std::vector<Plane> cone_;
};

} // namespace voluta::curved
