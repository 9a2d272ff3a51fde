// A convex hull that grows point by point and tells, before a point is added, which guarded points
// the larger hull would swallow.
#pragma once

#include "curved/convex_hull.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// What counts as inside a hull: its interior only (definition 3 of the dissertation with
// epsilon = 0), or its boundary too (the thesis).
enum class Boundary { Outside, Inside };

// Exact, as convexHull(): signs of integers. Points are named by their index.
//
// A guarded point that is outside has a facet with the point in front of it. Adding a corner
// replaces the facets that it sees by a cone of new ones; only guarded points in front of a facet
// that goes can come inside, and they do when they are behind the whole cone. So each guarded point
// waits on the list of one facet, and asking costs what the corner sees, not the whole hull.
class IncrementalFront {
public:
  // Keeps a reference to the points. No hull yet: everything is outside.
  IncrementalFront(const std::vector<LatticePoint>& points, Boundary boundary)
      : points_(&points), above_(boundary == Boundary::Outside ? -0.5 : 0.5) {}

  bool empty() const { return size_ == 0; }
  std::size_t facetCount() const { return size_; }

  // Hull of these points from scratch; nothing is guarded. Stays empty when they lie in one plane.
  void build(const std::vector<std::int32_t>& corners);

  bool inside(std::int32_t p) const { return !empty() && facetBefore(p, above_) < 0; }
  // Whether a box lies outside as a whole, by one facet that has it in front. May say false of a
  // box that only several facets keep out.
  bool boxOutside(const Eigen::Vector3d& centre, const Eigen::Vector3d& halfSize) const;

  // Extends the hull by p; nothing changes where p lies in it. Guarded points that come inside are
  // taken off guard and appended to `swallowed`. Precondition: not empty().
  void add(std::int32_t p, std::vector<std::int32_t>& swallowed);

  // Precondition: p is outside, not empty().
  void guard(std::int32_t p);
  void clearGuards();
  // Number of guarded points that adding p would swallow; counting stops at `enough`.
  std::size_t wouldSwallow(std::int32_t p, std::size_t enough);

private:
  struct Facet {
    std::array<std::int32_t, 3> corner;
    std::array<std::int32_t, 3> neighbour; // over the side corner[s] -> corner[s + 1]
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
  // A facet with p further in front than `above`, -1: none.
  std::int32_t facetBefore(std::int32_t p, double above) const;
  std::int32_t anyFacetBefore(const LatticePoint& at, double above) const;
  // Finds what p sees: visible_, horizon_, cone_. False where it sees nothing.
  bool look(std::int32_t p);
  bool behindCone(std::int32_t p) const;
  std::int32_t newFacet(const std::array<std::int32_t, 3>& corner, const Plane& plane);
  void link(std::int32_t guard, std::int32_t facet);

  const std::vector<LatticePoint>* points_;
  double above_; // a point is outside a facet when it is further in front than this
  std::vector<Facet> facets_;
  std::vector<double> nx_, ny_, nz_, offset_; // per facet; a free slot has everything behind it
  std::vector<std::int32_t> free_;
  std::size_t size_ = 0;
  std::vector<Guard> guards_;
  LatticePoint heart_ = LatticePoint::Zero(); // strictly inside, where there is such a point
  bool hasHeart_ = false;
  mutable std::int32_t hint_ = 0; // facet that answered last: makes asking faster, changes nothing
  std::uint32_t look_ = 0;
  std::vector<std::int32_t> visible_, made_;
  std::vector<Side> horizon_;
  std::vector<Plane> cone_;
};

} // namespace voluta::curved
