#include "milling/height_map.h"

#include "base/parallel.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <cmath>

namespace voluta::milling {

CellGrid gridOver(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double pitchMm) {
  const Eigen::Vector2d cells = ((high - low) / pitchMm).array().ceil();
  return {low, pitchMm, std::max(1, static_cast<int>(cells.x())),
          std::max(1, static_cast<int>(cells.y()))};
}

HeightMap heightMap(const geometry::TriangleMesh& part, const CellGrid& grid,
                    const base::RunContext& ctx) {
  constexpr double kBeyondMm = 1.0;
  HeightMap map{grid, std::vector<double>(grid.size(), HeightMap::kNone)};
  const geometry::MeshQuery query(part, geometry::MeshQuery::Of::Surface);
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const double high = box.max().z() + kBeyondMm, low = box.min().z() - kBeyondMm;
  base::parallelChunks(
      ctx, static_cast<std::size_t>(grid.countY), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row)
          for (int i = 0; i < grid.countX; ++i) {
            const int j = static_cast<int>(row);
            const Eigen::Vector2d at = grid.middle(i, j);
            const auto hit = query.firstHit({at.x(), at.y(), high}, {at.x(), at.y(), low});
            if (hit)
              map.top[grid.index(i, j)] = high + hit->t * (low - high);
          }
      });
  return map;
}

} // namespace voluta::milling
