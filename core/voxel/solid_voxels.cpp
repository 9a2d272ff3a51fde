#include "voxel/solid_voxels.h"

#include "base/error.h"
#include "base/parallel.h"
#include "geometry/mesh_query.h"
#include "voxel/column_parity.h"
#include "voxel/triangle_box.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace voluta::voxel {

namespace {

VoxelGrid gridAround(const geometry::TriangleMesh& mesh, double pitch, std::size_t maxCells) {
  Eigen::Vector3d low = mesh.corner(0, 0), high = low;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      low = low.cwiseMin(mesh.corner(t, c));
      high = high.cwiseMax(mesh.corner(t, c));
    }
  base::require(low.allFinite() && high.allFinite(), "solidVoxels: finite coordinates");

  const Eigen::Array3d span = ((high - low) / pitch).array() + 3.0;
  if (span.prod() > static_cast<double>(maxCells) || span.maxCoeff() > 4000.0) {
    const double byCount = pitch * std::cbrt(span.prod() / static_cast<double>(maxCells));
    const double bySide = pitch * span.maxCoeff() / 4000.0;
    const double fits = std::ceil(100.0 * 1.02 * std::max(byCount, bySide)) / 100.0;
    throw base::Error(base::ErrorCode::Usage,
                      "the voxels are too small for a part of this size"_text, "voxelMm"_name,
                      base::message("use at least {least}"_text, base::mm(fits)));
  }

  VoxelGrid grid;
  grid.pitch = pitch;
  for (int a = 0; a < 2; ++a) {
    const int cells =
        std::max(1, static_cast<int>(std::ceil((high[a] - low[a]) / pitch - 2.0 * kGrazeShare)));
    grid.size[a] = cells + 2;
    grid.origin[a] = 0.5 * (low[a] + high[a]) - 0.5 * pitch * grid.size[a];
  }
  const int bottom = static_cast<int>(std::floor(low.z() / pitch + kGrazeShare));
  const int top = std::max(bottom + 1, static_cast<int>(std::ceil(high.z() / pitch - kGrazeShare)));
  grid.size.z() = top - bottom + 2;
  grid.origin.z() = (bottom - 1) * pitch;
  return grid;
}

void markCrossed(const geometry::TriangleMesh& mesh, const VoxelGrid& grid,
                 std::vector<std::uint8_t>& solid, const base::RunContext& ctx) {
  const double half = (0.5 - kGrazeShare) * grid.pitch;
  // Work is split by slabs of layers, so that no two threads write to the same cell.
  constexpr int kSlab = 16;
  const auto slabs = static_cast<std::size_t>((grid.size.z() + kSlab - 1) / kSlab);
  std::vector<std::vector<std::size_t>> ofSlab(slabs);
  const auto cellBounds = [&](std::size_t t, Eigen::Vector3i& first, Eigen::Vector3i& last) {
    const Eigen::Vector3d &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    first = grid.cellOf(a.cwiseMin(b).cwiseMin(c)).cwiseMax(1);
    last = grid.cellOf(a.cwiseMax(b).cwiseMax(c)).cwiseMin(grid.size - Eigen::Vector3i(2, 2, 2));
    first = first.cwiseMin(grid.size - Eigen::Vector3i(2, 2, 2));
    last = last.cwiseMax(1);
  };
  Eigen::Vector3i first, last;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    cellBounds(t, first, last);
    for (int s = first.z() / kSlab; s <= last.z() / kSlab; ++s)
      ofSlab[static_cast<std::size_t>(s)].push_back(t);
  }
  base::parallelChunks(ctx, slabs, 1, [&](std::size_t begin, std::size_t) {
    Eigen::Vector3i low, high;
    for (const std::size_t t : ofSlab[begin]) {
      if (ctx.cancelled())
        return;
      const TriangleBoxTest test(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), half);
      cellBounds(t, low, high);
      low.z() = std::max(low.z(), static_cast<int>(begin) * kSlab);
      high.z() = std::min(high.z(), (static_cast<int>(begin) + 1) * kSlab - 1);
      for (int k = low.z(); k <= high.z(); ++k)
        for (int j = low.y(); j <= high.y(); ++j)
          for (int i = low.x(); i <= high.x(); ++i) {
            std::uint8_t& cell = solid[grid.index(i, j, k)];
            if (!cell && test.overlaps(grid.centre(i, j, k)))
              cell = 1;
          }
    }
  });
}

// Fills by winding number the cell centres of a mesh with large gaps.
void fillSoup(const geometry::TriangleMesh& mesh, const VoxelGrid& grid,
              std::vector<std::uint8_t>& solid, const base::RunContext& ctx) {
  const geometry::MeshQuery query(mesh);
  const auto rows =
      static_cast<std::size_t>(grid.size.y()) * static_cast<std::size_t>(grid.size.z());
  base::parallelChunks(ctx, rows, 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end && !ctx.cancelled(); ++row) {
      const int j = static_cast<int>(row) % grid.size.y(),
                k = static_cast<int>(row) / grid.size.y();
      for (int i = 0; i < grid.size.x(); ++i)
        if (!solid[grid.index(i, j, k)] &&
            std::abs(query.windingNumber(grid.centre(i, j, k))) > 0.5)
          solid[grid.index(i, j, k)] = 1;
    }
  });
}

} // namespace

int SolidVoxels::plateLayer() const {
  return static_cast<int>(std::lround(-grid.origin.z() / grid.pitch));
}

SolidVoxels solidVoxels(const geometry::TriangleMesh& mesh, double pitch,
                        const base::RunContext& ctx, std::size_t maxCells) {
  base::require(pitch > 0.0, "solidVoxels: pitch > 0");
  if (mesh.empty())
    throw base::Error(base::ErrorCode::UnusableInput, "the mesh has no triangles"_text);
  ctx.report(0.0, "voxels"_text);
  SolidVoxels out;
  out.grid = gridAround(mesh, pitch, maxCells);
  out.solid.assign(out.grid.cellCount(), 0);
  markCrossed(mesh, out.grid, out.solid, ctx);
  ctx.report(0.4, "voxels"_text);
  const geometry::TriangleMesh caps = capsOf(mesh);
  if (caps.empty())
    fillClosed(mesh, out.grid, out.solid, ctx);
  else if (4 * caps.triangles.size() < mesh.triangles.size())
    fillOpen(mesh, caps, out.grid, out.solid, ctx);
  else
    fillSoup(mesh, out.grid, out.solid, ctx);
  for (const std::uint8_t s : out.solid)
    out.count += s;
  ctx.report(1.0, "voxels"_text);
  return out;
}

} // namespace voluta::voxel
