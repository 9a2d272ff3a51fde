#include "regions/region_figures.h"

#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "layers/stair_steps.h"
#include "regions/region_kinds.h"
#include "substrate/skin.h"

#include <array>

namespace voluta::regions {

namespace {
constexpr double kOnSurfaceMm = 0.02;

double volumeOf(const layers::Patch& patch) {
  double mm3 = 0.0;
  for (std::size_t t = 0; t < patch.surface.triangles.size(); ++t) {
    double thickness = 0.0;
    for (const int v : patch.surface.triangles[t])
      thickness += patch.thicknessMm[static_cast<std::size_t>(v)] / 3.0;
    mm3 += thickness * geometry::triangleArea(patch.surface, t);
  }
  return mm3;
}

// Returns per face of the part whether it is in the region.
std::vector<char> facesIn(const project::Region& region, const geometry::TriangleMesh& part,
                          const geometry::TriangleMesh& body) {
  const Shape shape = parsedShape(region.shape);
  if (shape.kind->frame == ShapeFrame::Part)
    return substrate::upperFaces(part, base::degreesToRadians(shape.numbers[1]));
  std::vector<char> isIn(part.triangles.size(), 0);
  if (body.empty())
    return isIn;
  const geometry::MeshQuery query(body);
  for (std::size_t t = 0; t < isIn.size(); ++t) {
    const Eigen::Vector3d middle =
        (part.corner(t, 0) + part.corner(t, 1) + part.corner(t, 2)) / 3.0;
    isIn[t] = query.closest(middle).distance < kOnSurfaceMm || query.inside(middle) ? 1 : 0;
  }
  return isIn;
}
} // namespace

std::vector<plan::RegionStatistics>
figuresOf(const layers::LayerStack& whole, const layers::LayerStack& stack,
          const geometry::TriangleMesh& part, std::span<const project::Region> all,
          std::span<const geometry::TriangleMesh> bodies, const base::RunContext& ctx) {
  std::vector<plan::RegionStatistics> figures;
  for (std::size_t i = 0; i < all.size(); ++i) {
    plan::RegionStatistics& own = figures.emplace_back();
    own.region = all[i].shape;
    own.use = all[i].use;
    const layers::StepFigures steps =
        layers::stepsOn(whole, part, facesIn(all[i], part, bodies[i]), ctx);
    own.stepMeanMm = steps.meanMm;
    own.stepMaxMm = steps.maxMm;
  }
  for (const layers::Patch& patch : stack.patches)
    if (patch.region > 0) {
      plan::RegionStatistics& own = figures[static_cast<std::size_t>(patch.region) - 1];
      ++own.patches;
      own.volumeMm3 += volumeOf(patch);
    }
  return figures;
}

} // namespace voluta::regions
