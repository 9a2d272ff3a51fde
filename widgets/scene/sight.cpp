#include "scene/sight.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace voluta::scene {

namespace {

using Eigen::Vector3d;

constexpr int kAround = 12;
// Checking all printed material is slow: try the nearest directions, then some all around.
constexpr std::size_t kNearest = 4, kAllAround = 6;

std::vector<Vector3d> directionsFrom(const Vector3d& own) {
  std::vector<Vector3d> all;
  for (const double elevation : {10.0, 25.0, 45.0, 65.0})
    for (int k = 0; k < kAround; ++k) {
      const double up = base::degreesToRadians(elevation), around = base::kTwoPi * k / kAround;
      all.emplace_back(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                       std::sin(up));
    }
  std::ranges::stable_sort(all, std::greater{}, [&](const Vector3d& d) { return d.dot(own); });
  all.insert(all.begin(), own);
  return all;
}

} // namespace

Sight clearSight(const Scene& scene, const Vector3d& placeInWork, double radiusMm) {
  const Vector3d own = scene.towardsEye();
  const auto sightFrom = [&](const Vector3d& towards, bool printed) {
    return Sight{towards, scene.directionInWork(towards),
                 scene.between(placeInWork, towards, radiusMm, printed)};
  };
  std::vector<Vector3d> clear;
  for (const Vector3d& towards : directionsFrom(own))
    if (!sightFrom(towards, false).hides.machine())
      clear.push_back(towards);
  const std::size_t step =
      clear.size() > kNearest + kAllAround ? (clear.size() - 1 - kNearest) / (kAllAround - 1) : 1;
  std::optional<Sight> nearest;
  for (std::size_t i = 0; i < clear.size(); i += i < kNearest ? 1 : step) {
    const Sight sight = sightFrom(clear[i], true);
    if (!sight.hides.printed)
      return sight;
    if (!nearest)
      nearest = sight;
  }
  return nearest ? *nearest : sightFrom(own, true);
}

} // namespace voluta::scene
