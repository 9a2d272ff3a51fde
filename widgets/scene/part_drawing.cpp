#include "scene/drawing_data.h"
#include "scene/feature_edges.h"
#include "scene/surface.h"

namespace voluta::scene {

namespace {
constexpr double kFeatureAngleDeg = 45.0;
}

std::shared_ptr<const PartDrawing> drawPart(const geometry::TriangleMesh& part) {
  auto drawing = std::make_shared<PartDrawing>();
  drawing->mesh = part;
  for (const Eigen::Vector3d& v : part.vertices)
    drawing->box.extend(v);
  const auto plain = plainSurface(part);
  drawing->surface = shadedSurface(plain, kFeatureAngleDeg);
  drawing->edges = featureEdges(plain, kFeatureAngleDeg, true);
  return drawing;
}

} // namespace voluta::scene
