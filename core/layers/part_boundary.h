// The part's surface as something to cut with.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace voluta::layers {

// A closed (or nearly closed) mesh, facing outward. Safe from many threads once made.
class PartBoundary {
public:
  // cellMm > 0: width of the cells that tell at once where the surface is far.
  PartBoundary(const geometry::TriangleMesh& part, double cellMm, const base::RunContext& ctx);

  // False only where the segment certainly meets no facet. Cheap.
  bool mayCross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  // Where a segment goes in or out; entering and leaving alternate.
  struct Crossing {
    double t = 0.0; // in [0,1] from a to b
    int triangle = -1;
    bool entering = false;
  };
  // All of them, sorted by t, replacing `out`. Pairs less than minGapMm apart are left out: a
  // graze.
  void crossings(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double minGapMm,
                 std::vector<Crossing>& out) const;

  bool inside(const Eigen::Vector3d& p) const { return query_.inside(p); }
  const geometry::MeshQuery& query() const { return query_; }
  // Unit normal of a facet; zero for a degenerate one.
  const Eigen::Vector3d& normal(int triangle) const {
    return normal_[static_cast<std::size_t>(triangle)];
  }
  const Eigen::Vector3d& pointOf(int triangle) const {
    return point_[static_cast<std::size_t>(triangle)];
  }

private:
  geometry::MeshQuery query_;
  std::vector<Eigen::Vector3d> normal_, point_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  double cell_ = 1.0;
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> near_;
};

} // namespace voluta::layers
