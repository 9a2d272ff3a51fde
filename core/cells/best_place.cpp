#include "cells/best_place.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace voluta::cells {

namespace {

using Eigen::Vector2d;

constexpr double kSame = 1e-9;

// Returns whether a convex, counter-clockwise polygon contains a disc.
bool holdsDisc(const std::vector<Vector2d>& polygon, const Vector2d& at, double radius) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Vector2d along = (b - a).normalized();
    if (along.x() * (at - a).y() - along.y() * (at - a).x() < radius - kSame)
      return false;
  }
  return polygon.size() >= 3;
}

std::vector<std::size_t> pointsWithin(const ReachMap& map, const Vector2d& at, double radius) {
  std::vector<std::size_t> within;
  std::size_t nearest = 0;
  for (std::size_t n = 0; n < map.points().size(); ++n) {
    if ((map.points()[n] - at).norm() <= radius + kSame)
      within.push_back(n);
    if ((map.points()[n] - at).norm() < (map.points()[nearest] - at).norm())
      nearest = n;
  }
  if (within.empty() && !map.points().empty())
    within.push_back(nearest);
  return within;
}

} // namespace

Place placeAt(const ReachMap& map, const Standing& part, const Vector2d& at) {
  base::require(part.radiusMm > 0.0 && part.heightMm > 0.0, "a part with a size");
  Place place;
  place.at = at;
  place.onPlate = holdsDisc(map.plate(), at, part.radiusMm);
  const std::vector<std::size_t> within = pointsWithin(map, at, part.radiusMm);
  // The same number of poses is tried at every point, so the mean is the share.
  double all = 0.0, upright = 0.0;
  for (const std::size_t point : within) {
    all += map.share(point, part.heightMm, part.tiltRad);
    upright += map.share(point, part.heightMm, 0.0);
  }
  const double count = std::max(1.0, static_cast<double>(within.size()));
  place.share = all / count;
  place.uprightShare = upright / count;
  return place;
}

Place bestPlace(const ReachMap& map, const Standing& part) {
  base::require(!map.points().empty(), "a map with points");
  const auto steps = [](double value) { return std::llround(value / kSame); };
  const auto rank = [&](const Place& p) {
    return std::tuple(p.onPlate, steps(p.uprightShare), steps(p.share), -steps(p.at.norm()));
  };
  Place best = placeAt(map, part, map.points().front());
  for (const Vector2d& at : map.points())
    if (const Place place = placeAt(map, part, at); rank(place) > rank(best))
      best = place;
  return best;
}

} // namespace voluta::cells
