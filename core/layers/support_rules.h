// Queries of what the regions of a part say about its supports.
#pragma once

#include "geometry/mesh_query.h"
#include "layers/support_places.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace voluta::layers {

// Every query is const and safe from many threads.
class SupportRules {
public:
  // `otherwise`: the rule outside of the places.
  SupportRules(const std::vector<SupportPlace>& places, SupportRule otherwise);

  SupportRule otherwise() const { return otherwise_; }
  // Returns whether some place has that rule.
  bool has(SupportRule rule) const;
  SupportRule at(const Eigen::Vector3d& place) const;

private:
  struct Ruled {
    SupportRule rule;
    Eigen::AlignedBox3d box;
    geometry::MeshQuery query;
  };
  SupportRule otherwise_;
  std::vector<Ruled> places_;
};

} // namespace voluta::layers
