#include "scene/line_groups.h"

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"
#include "scene/surface.h"

#include <cmath>
#include <vtkMapper.h>

namespace voluta::scene {

LineGroups::LineGroups(vtkRenderer* renderer) : actor_(addLines(renderer)) {
  actor_->GetMapper()->ScalarVisibilityOn(); // colours of the points
}

void LineGroups::show(const std::vector<const LineGroup*>& groups) {
  MeshBuffers buffers;
  for (const LineGroup* group : groups)
    for (const std::vector<Eigen::Vector3d>& line : group->lines)
      for (std::size_t i = 0; i < line.size(); ++i) {
        const std::int32_t point = buffers.addPoint(line[i]);
        if (i > 0)
          buffers.lineEnds.insert(buffers.lineEnds.end(), {point - 1, point});
        for (const double part : group->colour)
          buffers.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0 * part)));
      }
  setData(actor_, polyDataOf(buffers));
}

void LineGroups::pose(const Eigen::Isometry3d& world_T_lines) {
  setPose(actor_, world_T_lines);
}

std::shared_ptr<const PartDrawing> drawWithoutEdges(const geometry::TriangleMesh& solid) {
  constexpr double kFeatureAngleDeg = 45.0;
  auto drawing = std::make_shared<PartDrawing>();
  drawing->mesh = solid;
  for (const Eigen::Vector3d& v : solid.vertices)
    drawing->box.extend(v);
  drawing->surface = shadedSurface(plainSurface(solid), kFeatureAngleDeg);
  return drawing;
}

} // namespace voluta::scene
