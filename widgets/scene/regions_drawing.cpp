#include "geometry/triangle_mesh.h"
#include "scene/drawing_data.h"
#include "scene/feature_edges.h"
#include "scene/surface.h"

namespace voluta::scene {

namespace {
constexpr double kRimAngleDeg = 30.0; // round bodies consist of flat faces

RegionsDrawing::One draw(const RegionBody& region) {
  RegionsDrawing::One one;
  one.surface = plainSurface(region.body ? *region.body : geometry::TriangleMesh());
  one.edges = featureEdges(one.surface, kRimAngleDeg, false);
  one.look = region.look;
  return one;
}
} // namespace

std::shared_ptr<const RegionsDrawing> drawRegions(const std::vector<RegionBody>& bodies) {
  auto drawing = std::make_shared<RegionsDrawing>();
  for (const RegionBody& region : bodies)
    drawing->regions.push_back(draw(region));
  return drawing;
}

std::shared_ptr<const RegionsDrawing> withRegion(const RegionsDrawing& drawing, std::size_t region,
                                                 const RegionBody& body) {
  auto other = std::make_shared<RegionsDrawing>(drawing);
  while (other->regions.size() <= region)
    other->regions.push_back(draw({}));
  other->regions[region] = draw(body);
  return other;
}

} // namespace voluta::scene
