// Where points and segments meet the patches of a stack.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "layers/layer_stack.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace voluta::layers {

// Patches are named by their index. Copies what it needs: what becomes of the patches later does
// not matter to it. Safe from many threads once made.
class StackQuery {
public:
  // Of the patches that come within reachMm of one of `around`.
  StackQuery(const std::vector<Patch>& patches, const std::vector<Eigen::AlignedBox3d>& around,
             double reachMm, const base::RunContext& ctx);

  // Those whose box meets this one, ascending, from `first` up to but without `end`.
  std::vector<int> near(const Eigen::AlignedBox3d& box, int first, int end) const;

  struct Place {
    int patch = -1, triangle = -1; // -1: none
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double distance = 0.0; // mm; from a, of hits
  };
  // The nearest point of `patches` (ascending) within reachMm.
  Place closest(const std::vector<int>& patches, const Eigen::Vector3d& p, double reachMm) const;
  // Where the segment a-b meets them, from a on; replaces `out`.
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
