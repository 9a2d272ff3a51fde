#include "layers/support_rules.h"

#include "geometry/measures.h"

#include <algorithm>

namespace voluta::layers {

SupportRules::SupportRules(const std::vector<SupportPlace>& places, SupportRule otherwise)
    : otherwise_(otherwise) {
  for (const SupportPlace& place : places)
    places_.push_back({place.rule, geometry::bounds(place.body), geometry::MeshQuery(place.body)});
}

bool SupportRules::has(SupportRule rule) const {
  return std::ranges::find(places_, rule, &Ruled::rule) != places_.end();
}

SupportRule SupportRules::at(const Eigen::Vector3d& place) const {
  for (auto ruled = places_.rbegin(); ruled != places_.rend(); ++ruled)
    if (ruled->box.contains(place) && ruled->query.inside(place))
      return ruled->rule;
  return otherwise_;
}

} // namespace voluta::layers
