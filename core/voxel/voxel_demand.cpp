#include "voxel/voxel_demand.h"

#include "base/error.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace voluta::voxel {

namespace {
struct Measures {
  Eigen::Vector3d sides;
  double volume = 0.0, shell = 0.0; // shell: projected area, summed over the three axes

  VoxelDemand demand(double pitch) const {
    VoxelDemand demand;
    demand.cells = ((sides / pitch).array() + 2.5).prod();
    demand.voxels =
        std::min(demand.cells, volume / std::pow(pitch, 3) + 0.5 * shell / (pitch * pitch));
    return demand;
  }
};

Measures measuresOf(const geometry::TriangleMesh& mesh) {
  Measures m;
  m.sides = geometry::bounds(mesh).sizes();
  m.volume = std::abs(geometry::volume(mesh));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    m.shell += geometry::triangleArea(mesh, t) * geometry::triangleNormal(mesh, t).lpNorm<1>();
  return m;
}

base::Message readable(double bytes) {
  return bytes >= 1e9
             ? base::message("{size:.1f}"_text, base::Quantity{bytes / 1e9, base::Unit::Gigabyte})
             : base::message("{size:.0f}"_text, base::Quantity{bytes / 1e6, base::Unit::Megabyte});
}
} // namespace

VoxelDemand voxelDemand(const geometry::TriangleMesh& mesh, double pitch) {
  base::require(pitch > 0.0 && !mesh.empty(), "voxelDemand: pitch > 0, a mesh");
  return measuresOf(mesh).demand(pitch);
}

void checkVoxelDemand(const geometry::TriangleMesh& mesh, double pitch,
                      std::uint64_t availableBytes) {
  base::require(pitch > 0.0 && !mesh.empty(), "checkVoxelDemand: pitch > 0, a mesh");
  const Measures measures = measuresOf(mesh);
  const auto available = static_cast<double>(availableBytes);
  const double needed = measures.demand(pitch).bytes();
  if (needed <= available)
    return;
  double low = pitch, high = 2.0 * std::max(pitch, measures.sides.maxCoeff());
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (measures.demand(middle).bytes() <= available ? high : low) = middle;
  }
  throw base::Error(
      base::ErrorCode::Usage,
      base::message("voxels of {width} need about {needed} of memory; {available} are free"_text,
                    base::mm(pitch), readable(needed), readable(available)),
      "voxelMm"_name,
      base::message("use at least {least}"_text, base::mm(std::ceil(100.0 * high) / 100.0)));
}

void checkVoxelDemand(const SolidVoxels& voxels, std::uint64_t availableBytes) {
  const VoxelDemand demand{static_cast<double>(voxels.grid.cellCount()),
                           static_cast<double>(voxels.count)};
  const auto available = static_cast<double>(availableBytes);
  if (demand.bytes() > available)
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message(
            "{voxels} voxels in a grid of {cells} cells need about {needed} of memory; {available} are free"_text,
            voxels.count, voxels.grid.cellCount(), readable(demand.bytes()), readable(available)),
        {}, "make the object from fewer and larger cells"_text);
}

} // namespace voluta::voxel
