// Finds the item of a job that a place belongs to.
#pragma once

#include "geometry/mesh_query.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <vector>

namespace voluta::replay {

class ItemFinder {
public:
  // One item.
  ItemFinder() : boxes_(1) {}
  // `part`: all items as one mesh; `firstTriangle`: of each item, ascending from 0, or empty for
  // one item. Places up to `marginMm` outside an item's box may belong to it. Keeps references to
  // all but the mesh.
  ItemFinder(const geometry::TriangleMesh& part, const geometry::MeshQuery& query,
             std::span<const std::size_t> firstTriangle, double marginMm);

  std::size_t count() const { return boxes_.size(); }
  // Returns the item whose box alone contains the place, or else the one with the nearest surface.
  std::size_t at(const Eigen::Vector3d& place) const {
    return boxes_.size() == 1 ? 0 : amongSeveral(place);
  }

private:
  std::size_t amongSeveral(const Eigen::Vector3d& place) const;

  const geometry::MeshQuery* query_ = nullptr;
  std::span<const std::size_t> firstTriangle_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

} // namespace voluta::replay
