// The part's surface, prepared for trimming.
#pragma once

#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace voluta::layers {

// A closed (or nearly closed) mesh, facing outward. Thread-safe after construction.
class PartBoundary {
public:
  // cellMm > 0: width of the cells that exclude places far from the surface.
  PartBoundary(const geometry::TriangleMesh& part, double cellMm, const base::RunContext& ctx);

  // Returns false only if the segment certainly intersects no facet. Fast.
  bool mayCross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  // A point where a segment enters or leaves the part; entering and leaving alternate.
  struct Crossing {
    double t = 0.0; // in [0,1] from a to b
    int triangle = -1;
    bool entering = false;
  };
  // Replaces `out` by all crossings, sorted by t. Pairs less than minGapMm apart are left out, as
  // the segment only grazes the surface.
  void crossings(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double minGapMm,
                 std::vector<Crossing>& out) const;

  bool inside(const Eigen::Vector3d& p) const { return query_.inside(p); }
  const geometry::MeshQuery& query() const { return query_; }
  // Returns the unit normal of a facet; zero if it is degenerate.
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
