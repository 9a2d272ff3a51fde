// Nearest-point and segment queries on the patches of a stack.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "layers/layer_stack.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace voluta::layers {

// Patches are identified by index. Copies the required data, so later changes of the patches have
// no effect. Thread-safe after construction.
class StackQuery {
public:
  // Only patches within reachMm of one of the boxes `around` are included.
  StackQuery(const std::vector<Patch>& patches, const std::vector<Eigen::AlignedBox3d>& around,
             double reachMm, const base::RunContext& ctx);

  // Returns those in [first, end) whose box intersects this one, ascending.
  std::vector<int> near(const Eigen::AlignedBox3d& box, int first, int end) const;

  struct Place {
    int patch = -1, triangle = -1; // -1: none
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double distance = 0.0; // mm; for hits the distance from a
  };
  // Returns the nearest point of `patches` (ascending) within reachMm.
  Place closest(const std::vector<int>& patches, const Eigen::Vector3d& p, double reachMm) const;
  // Replaces `out` by the intersections of the segment a-b, sorted from a.
  void hits(const std::vector<int>& patches, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
            std::vector<Place>& out) const;

private:
  const geometry::MeshQuery& query(int patch) const {
    return *queries_[static_cast<std::size_t>(patch)];
  }
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<std::unique_ptr<const geometry::MeshQuery>> queries_; // null: not near
};

} // namespace voluta::layers
