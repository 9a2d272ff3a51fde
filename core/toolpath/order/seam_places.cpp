#include "toolpath/order/seam_places.h"

#include "geometry/measures.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
constexpr double kSpacingWidths = 0.25; // between places that are looked at [bead widths]

// Returns the places at which the bead may begin, close to each other.
std::vector<SeamPlace> placesOn(const Bead& bead) {
  std::vector<SeamPlace> places;
  for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
    const double length = (tipAt(bead, {i, 1.0}) - tipAt(bead, {i, 0.0})).norm();
    const double spacing = std::max(2.0 * kSameSeamMm, kSpacingWidths * bead.points[i].widthMm);
    const int count = std::max(1, static_cast<int>(length / spacing));
    for (int k = 0; k < count; ++k)
      places.push_back({i, static_cast<double>(k) / count});
  }
  return places;
}
} // namespace

SeamPlaces::SeamPlaces(const std::vector<SeamPlaceBody>& places) {
  for (const SeamPlaceBody& place : places)
    places_.push_back({place.rule, geometry::bounds(place.body), geometry::MeshQuery(place.body)});
}

SeamRule SeamPlaces::at(const Eigen::Vector3d& tip) const {
  for (auto place = places_.rbegin(); place != places_.rend(); ++place)
    if (place->box.contains(tip) && place->query.inside(tip))
      return place->rule;
  return SeamRule::Auto;
}

std::optional<SeamPlace> SeamPlaces::seamOf(const SeamInput& input,
                                            const std::optional<SeamPlace>& wanted) const {
  const std::vector<SeamPlace> all = placesOn(input.bead);
  std::vector<SeamRule> rules;
  for (const SeamPlace& place : all)
    rules.push_back(at(tipAt(input.bead, place)));
  const SeamRule best = std::ranges::max(rules);
  if (std::ranges::min(rules) == best)
    return std::nullopt;
  if (wanted && at(tipAt(input.bead, begunPlace(input.bead, *wanted))) == best)
    return wanted;
  std::vector<SeamPlace> suitable;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (rules[i] == best)
      suitable.push_back(all[i]);
  return preferredSeam(input, suitable);
}

} // namespace voluta::toolpath
