#include "placement/coarse_growth.h"

#include "base/parallel.h"
#include "curved/platform_polygon.h"
#include "curved/reverse_growth.h"
#include "geometry/measures.h"
#include "geometry/placement.h"

#include <algorithm>
#include <cmath>

namespace voluta::placement {

namespace {

voxel::SolidVoxels turnedVoxels(const geometry::TriangleMesh& mesh,
                                const Eigen::Quaterniond& rotation, const Eigen::Vector2d& centreMm,
                                double pitchMm, const base::RunContext& ctx) {
  geometry::Placement placement;
  placement.rotation = rotation;
  placement.centreMm = centreMm;
  return voxel::solidVoxels(geometry::place(mesh, 1.0, placement), pitchMm, ctx);
}

bool touchesPlate(const voxel::SolidVoxels& part) {
  const int k = part.plateLayer();
  if (!part.grid.contains(0, 0, k))
    return false;
  const auto first = part.solid.begin() + static_cast<std::ptrdiff_t>(part.grid.index(0, 0, k));
  return std::any_of(first, first + part.grid.size.x() * part.grid.size.y(),
                     [](std::uint8_t solid) { return solid != 0; });
}

CoarseGrowth grown(const voxel::SolidVoxels& part, const PlatformOf& platformOf,
                   const base::RunContext& ctx) {
  // Films too thin for a voxel do not touch the plate.
  if (!touchesPlate(part))
    return {part.count, part.count};
  const std::vector<Eigen::Vector2d> platform =
      platformOf ? platformOf(part) : curved::platformFit(part, 0.0);
  const curved::VoxelGraph graph =
      curved::voxelGraph(part.grid, part.solid, part.plateLayer(), platform);
  const std::vector<std::int32_t> rank = curved::peel(graph, {}, {}, ctx).rank;
  const auto printed = std::count_if(rank.begin(), rank.end(), [](auto r) { return r > 0; });
  return {part.count, part.count - static_cast<std::size_t>(printed)};
}

} // namespace

double coarseWidth(const geometry::TriangleMesh& mesh, const Eigen::Quaterniond& rotation,
                   double minMm, std::size_t wanted, const base::RunContext& ctx) {
  const auto count = static_cast<double>(wanted);
  double width = std::max(minMm, std::cbrt(std::abs(geometry::volume(mesh)) / count));
  for (int n = 0; n < 3; ++n) {
    const auto voxels = static_cast<double>(
        turnedVoxels(mesh, rotation, Eigen::Vector2d::Zero(), width, ctx.sub(0.0, 0.0)).count);
    width = std::max(minMm, width * std::cbrt(voxels / count));
  }
  return width;
}

std::vector<CoarseGrowth> coarseGrowths(const geometry::TriangleMesh& mesh,
                                        const std::vector<Eigen::Quaterniond>& turns,
                                        const CoarseGrid& grid, const base::RunContext& ctx) {
  constexpr std::size_t kAtOnce = 4; // limits the number of grids in memory
  std::vector<CoarseGrowth> growths(turns.size());
  for (std::size_t begin = 0; begin < turns.size(); begin += kAtOnce) {
    const double at = static_cast<double>(begin) / static_cast<double>(turns.size());
    const std::size_t count = std::min(kAtOnce, turns.size() - begin);
    std::vector<voxel::SolidVoxels> parts;
    for (std::size_t n = 0; n < count; ++n)
      parts.push_back(
          turnedVoxels(mesh, turns[begin + n], grid.centreMm, grid.pitchMm, ctx.sub(at, at)));
    const base::RunContext quiet = ctx.quiet();
    base::parallelChunks(ctx, count, 1, [&](std::size_t b, std::size_t e) {
      for (std::size_t n = b; n < e; ++n)
        growths[begin + n] = grown(parts[n], grid.platform, quiet);
    });
  }
  return growths;
}

} // namespace voluta::placement
