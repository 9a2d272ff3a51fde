// What the regions of a part say about the seams of closed beads.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"
#include "toolpath/order/seam.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::toolpath {

enum class SeamRule : std::uint8_t {
  Never, // a blocker
  Auto,
  Always // an enforcer
};

// A place with a rule of its own.
struct SeamPlaceBody {
  SeamRule rule = SeamRule::Auto;
  geometry::TriangleMesh body; // closed, work frame
};

// The places of one part; where two overlap, the later one holds. Every query is const and safe
// from many threads.
class SeamPlaces {
public:
  explicit SeamPlaces(const std::vector<SeamPlaceBody>& places);

  SeamRule at(const Eigen::Vector3d& tip) const;
  // Returns where a closed bead begins: within a place with Always if it passes through one, else
  // outside of those with Never. `wanted`: taken if it is such a place; without it, or else, the
  // place that alignedSeam() would prefer of these. Returns nullopt if all of the bead, or nothing
  // of it, is such a place: it may begin anywhere, or where its kind of seam says.
  std::optional<SeamPlace> seamOf(const SeamInput& input,
                                  const std::optional<SeamPlace>& wanted) const;

private:
  struct Ruled {
    SeamRule rule;
    Eigen::AlignedBox3d box;
    geometry::MeshQuery query;
  };
  std::vector<Ruled> places_;
};

} // namespace voluta::toolpath
