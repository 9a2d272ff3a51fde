#include "cells/best_place.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

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

// Removes the places whose value is less than the greatest by more than `same`.
template <typename Value>
void keepGreatest(std::vector<Place>& places, const Value& value, double same) {
  const auto of = [&](const Place& place) { return std::invoke(value, place); };
  const double greatest = of(*std::ranges::max_element(places, {}, of));
  std::erase_if(places, [&](const Place& place) { return of(place) < greatest - same; });
}

} // namespace

bool isBetter(const Place& a, const Place& b) {
  if (a.onPlate != b.onPlate)
    return a.onPlate;
  const bool whole = (a.uprightShare == 1.0) != (b.uprightShare == 1.0);
  if (whole || std::abs(a.uprightShare - b.uprightShare) > kSameShare)
    return a.uprightShare > b.uprightShare;
  return a.share > b.share + kSameShare;
}

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
  std::vector<Place> places;
  for (const Vector2d& at : map.points())
    places.push_back(placeAt(map, part, at));
  keepGreatest(
      places, [](const Place& p) { return p.onPlate ? 1.0 : 0.0; }, 0.0);
  const bool all =
      std::ranges::any_of(places, [](const Place& p) { return p.uprightShare == 1.0; });
  keepGreatest(places, &Place::uprightShare, all ? 0.0 : kSameShare);
  keepGreatest(places, &Place::share, kSameShare);
  return *std::ranges::min_element(
      places, {}, [](const Place& p) { return std::llround(p.at.norm() / kSame); });
}

} // namespace voluta::cells
