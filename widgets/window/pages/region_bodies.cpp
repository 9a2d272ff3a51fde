#include "window/pages/region_bodies.h"

#include "geometry/measures.h"
#include "regions/region_uses.h"

namespace voluta::window {

using Eigen::Vector3d;
using project::Region;

scene::RegionLook lookOf(const Region& region) {
  const regions::RegionUse& use = regions::findUse(region.use);
  return use.cuts             ? scene::RegionLook::Cut
         : use.hasLayers()    ? scene::RegionLook::Layers
         : !use.hasSettings() ? scene::RegionLook::Load
                              : scene::RegionLook::Settings;
}

geometry::TriangleMesh overPart(const geometry::TriangleMesh& painted,
                                const Eigen::Isometry3d& work_T_file, double scale) {
  constexpr double kOverMm = 0.05;
  geometry::TriangleMesh over;
  for (std::size_t t = 0; t < painted.triangles.size(); ++t) {
    const Vector3d normal = work_T_file.linear() * geometry::triangleNormal(painted, t);
    const int first = static_cast<int>(over.vertices.size());
    for (int k = 0; k < 3; ++k)
      over.vertices.push_back(work_T_file * (scale * painted.corner(t, k)) + kOverMm * normal);
    over.triangles.push_back({first, first + 1, first + 2});
  }
  return over;
}

} // namespace voluta::window
