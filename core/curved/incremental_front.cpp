#include "curved/incremental_front.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace voluta::curved {

namespace {

constexpr std::size_t kBlock = 8;
constexpr double kNowhere = std::numeric_limits<double>::max();

// Returns the lattice point nearest to the middle of the bounding box of the points.
LatticePoint between(const std::vector<LatticePoint>& points) {
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(),
      [](const LatticePoint& a, const LatticePoint& b) { return a.z() < b.z(); });
  LatticePoint middle = LatticePoint::Zero();
  for (const double z : {low->z(), high->z()}) {
    LatticePoint sum = LatticePoint::Zero();
    double n = 0.0;
    for (const LatticePoint& p : points)
      if (p.z() == z) {
        sum += p;
        n += 1.0;
      }
    middle += 0.5 / n * sum;
  }
  return middle.array().round();
}

} // namespace

std::int32_t IncrementalFront::newFacet(const std::array<std::int32_t, 3>& corner,
                                        const Plane& plane) {
  if (free_.empty()) {
    const std::size_t first = facets_.size();
    facets_.resize(first + kBlock);
    for (std::vector<double>* a : {&nx_, &ny_, &nz_})
      a->resize(first + kBlock, 0.0);
    offset_.resize(first + kBlock, kNowhere);
    for (std::size_t i = kBlock; i-- > 0;)
      free_.push_back(static_cast<std::int32_t>(first + i));
  }
  const std::int32_t f = free_.back();
  free_.pop_back();
  const auto i = static_cast<std::size_t>(f);
  facets_[i].corner = corner;
  facets_[i].firstGuard = -1;
  nx_[i] = plane.normal.x();
  ny_[i] = plane.normal.y();
  nz_[i] = plane.normal.z();
  offset_[i] = plane.offset;
  ++size_;
  return f;
}

void IncrementalFront::build(const std::vector<std::int32_t>& corners) {
  facets_.clear();
  free_.clear();
  for (std::vector<double>* a : {&nx_, &ny_, &nz_, &offset_})
    a->clear();
  size_ = 0;
  guards_.clear();
  std::vector<LatticePoint> at;
  for (const std::int32_t c : corners)
    at.push_back(point(c));
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> facetOfSide;
  for (const HullFacet& h : convexHull(at)) {
    std::array<std::int32_t, 3> c;
    for (std::size_t s = 0; s < 3; ++s)
      c[s] = corners[static_cast<std::size_t>(h.corner[s])];
    const std::int32_t f = newFacet(c, {h.normal, h.offset});
    for (std::size_t s = 0; s < 3; ++s)
      facetOfSide[{c[s], c[(s + 1) % 3]}] = f;
  }
  hint_ = 0;
  // The hull only grows, so a point inside stays inside.
  if (!empty())
    heart_ = between(at);
  hasHeart_ = !empty();
  for (std::size_t f = 0; f < facets_.size() && hasHeart_; ++f)
    hasHeart_ = distance(static_cast<std::int32_t>(f), heart_) < 0.0;
  for (const auto& [side, f] : facetOfSide) {
    Facet& facet = facets_[static_cast<std::size_t>(f)];
    for (std::size_t s = 0; s < 3; ++s)
      if (facet.corner[s] == side.first)
        facet.neighbour[s] = facetOfSide.at({side.second, side.first});
  }
}

// The ray from the heart through p leaves the hull through one facet (or an edge of two), and p is
// outside if it is in front of that facet. The walk from facet to facet, always over a side that
// has p beyond it, takes a few steps from the facet of the previous point.
std::int32_t IncrementalFront::facetBefore(std::int32_t p, double above) const {
  constexpr int kMaxSteps = 300;
  const LatticePoint& at = point(p);
  std::int32_t f = hint_, from = -1;
  for (int step = 0; hasHeart_ && step < kMaxSteps; ++step) {
    if (distance(f, at) > above) {
      hint_ = f;
      return f;
    }
    const Facet& facet = facets_[static_cast<std::size_t>(f)];
    std::int32_t next = -1;
    for (std::size_t i = 0; i < 3 && next < 0; ++i) {
      const std::size_t s = (i + static_cast<std::size_t>(step)) % 3;
      if (facet.neighbour[s] == from)
        continue;
      const Eigen::Vector3d a = point(facet.corner[s]) - heart_;
      const Eigen::Vector3d b = point(facet.corner[(s + 1) % 3]) - heart_;
      if (a.cross(b).dot(at - heart_) < 0.0)
        next = facet.neighbour[s];
    }
    if (next < 0) {
      hint_ = f;
      return -1;
    }
    from = f;
    f = next;
  }
  return anyFacetBefore(at, above);
}

std::int32_t IncrementalFront::anyFacetBefore(const LatticePoint& at, double above) const {
  for (std::size_t f = 0; f < nx_.size(); ++f)
    if (distance(static_cast<std::int32_t>(f), at) > above) {
      hint_ = static_cast<std::int32_t>(f);
      return hint_;
    }
  return -1;
}

bool IncrementalFront::boxOutside(const Eigen::Vector3d& centre,
                                  const Eigen::Vector3d& halfSize) const {
  for (std::size_t f = 0; f < nx_.size(); ++f) {
    const double nearest = nx_[f] * centre.x() + ny_[f] * centre.y() + nz_[f] * centre.z() -
                           offset_[f] - std::abs(nx_[f]) * halfSize.x() -
                           std::abs(ny_[f]) * halfSize.y() - std::abs(nz_[f]) * halfSize.z();
    if (nearest > above_)
      return true;
  }
  return empty();
}

bool IncrementalFront::look(std::int32_t p) {
  const std::int32_t start = facetBefore(p, 0.5);
  if (start < 0)
    return false;
  const LatticePoint at = point(p);
  ++look_;
  visible_.assign(1, start);
  facets_[static_cast<std::size_t>(start)].seen = look_;
  horizon_.clear();
  for (std::size_t i = 0; i < visible_.size(); ++i)
    for (std::size_t s = 0; s < 3; ++s) {
      const Facet& f = facets_[static_cast<std::size_t>(visible_[i])];
      const std::int32_t g = f.neighbour[s];
      Facet& beyond = facets_[static_cast<std::size_t>(g)];
      if (beyond.seen == look_)
        continue;
      if (distance(g, at) > 0.5) {
        beyond.seen = look_;
        visible_.push_back(g);
      } else {
        horizon_.push_back({f.corner[s], f.corner[(s + 1) % 3], g});
      }
    }
  cone_.clear();
  for (const Side& side : horizon_) {
    const LatticePoint& from = point(side.from);
    const Eigen::Vector3d normal = (point(side.to) - from).cross(at - from);
    cone_.push_back({normal, normal.dot(from)});
  }
  return true;
}

bool IncrementalFront::behindCone(std::int32_t p) const {
  const LatticePoint& at = point(p);
  return std::none_of(cone_.begin(), cone_.end(), [&](const Plane& plane) {
    return plane.normal.dot(at) - plane.offset > above_;
  });
}

std::size_t IncrementalFront::wouldSwallow(std::int32_t p, std::size_t enough) {
  if (guards_.empty() || !look(p))
    return 0;
  std::size_t n = 0;
  for (const std::int32_t f : visible_)
    for (std::int32_t g = facets_[static_cast<std::size_t>(f)].firstGuard; g >= 0 && n < enough;
         g = guards_[static_cast<std::size_t>(g)].next)
      n += behindCone(guards_[static_cast<std::size_t>(g)].point);
  return n;
}

void IncrementalFront::link(std::int32_t guard, std::int32_t facet) {
  Facet& f = facets_[static_cast<std::size_t>(facet)];
  guards_[static_cast<std::size_t>(guard)].next = f.firstGuard;
  f.firstGuard = guard;
}

void IncrementalFront::guard(std::int32_t p) {
  const std::int32_t f = facetBefore(p, above_);
  guards_.push_back({p, -1});
  link(static_cast<std::int32_t>(guards_.size()) - 1, f);
}

void IncrementalFront::clearGuards() {
  guards_.clear();
  for (Facet& f : facets_)
    f.firstGuard = -1;
}

void IncrementalFront::add(std::int32_t p, std::vector<std::int32_t>& swallowed) {
  if (!look(p))
    return;
  std::sort(horizon_.begin(), horizon_.end(),
            [](const Side& a, const Side& b) { return a.from < b.from; });
  cone_.clear();
  made_.clear();
  const LatticePoint at = point(p);
  for (const Side& side : horizon_) {
    const LatticePoint& from = point(side.from);
    const Eigen::Vector3d normal = (point(side.to) - from).cross(at - from);
    cone_.push_back({normal, normal.dot(from)});
    made_.push_back(newFacet({side.from, side.to, p}, cone_.back()));
  }
  for (std::size_t i = 0; i < horizon_.size(); ++i) {
    const Side& side = horizon_[i];
    // The horizon is one cycle: each corner starts exactly one side of it.
    const auto after =
        std::lower_bound(horizon_.begin(), horizon_.end(), side.to,
                         [](const Side& s, std::int32_t corner) { return s.from < corner; });
    const std::int32_t next = made_[static_cast<std::size_t>(after - horizon_.begin())];
    Facet& f = facets_[static_cast<std::size_t>(made_[i])];
    f.neighbour[0] = side.beyond;
    f.neighbour[1] = next;
    facets_[static_cast<std::size_t>(next)].neighbour[2] = made_[i];
    Facet& beyond = facets_[static_cast<std::size_t>(side.beyond)];
    for (std::size_t s = 0; s < 3; ++s)
      if (beyond.corner[s] == side.to)
        beyond.neighbour[s] = made_[i];
  }
  hint_ = made_.front();
  for (const std::int32_t f : visible_) {
    const auto slot = static_cast<std::size_t>(f);
    for (std::int32_t g = facets_[slot].firstGuard; g >= 0;) {
      const std::int32_t following = guards_[static_cast<std::size_t>(g)].next;
      const std::int32_t guarded = guards_[static_cast<std::size_t>(g)].point;
      const LatticePoint& there = point(guarded);
      std::size_t c = 0;
      while (c < cone_.size() && cone_[c].normal.dot(there) - cone_[c].offset <= above_)
        ++c;
      if (c < cone_.size())
        link(g, made_[c]);
      else
        swallowed.push_back(guarded);
      g = following;
    }
    facets_[slot].firstGuard = -1;
    nx_[slot] = ny_[slot] = nz_[slot] = 0.0;
    offset_[slot] = kNowhere;
    free_.push_back(f);
    --size_;
  }
}

} // namespace voluta::curved
