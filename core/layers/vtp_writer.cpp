#include "layers/vtp_writer.h"

#include "base/vtk_xml.h"

#include <cstdint>

namespace voluta::layers {

std::string writeLayersVtp(const LayerStack& stack) {
  std::vector<float> points, thickness, direction;
  std::vector<std::int32_t> connectivity, offsets, layer, group, patchIndex;
  for (std::size_t index = 0; index < stack.patches.size(); ++index) {
    const Patch& patch = stack.patches[index];
    const auto base = static_cast<std::int32_t>(points.size() / 3);
    for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        points.push_back(static_cast<float>(patch.surface.vertices[v][axis]));
        direction.push_back(static_cast<float>(patch.direction[v][axis]));
      }
      thickness.push_back(static_cast<float>(patch.thicknessMm[v]));
    }
    for (const auto& t : patch.surface.triangles) {
      for (int v : t)
        connectivity.push_back(base + v);
      offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
      layer.push_back(patch.layer);
      group.push_back(patch.group);
      patchIndex.push_back(static_cast<std::int32_t>(index));
    }
  }
  base::VtkXml vtp("PolyData");
  vtp.open("Piece", {{"NumberOfPoints", std::to_string(points.size() / 3)},
                     {"NumberOfPolys", std::to_string(offsets.size())}});
  vtp.open("PointData");
  vtp.array("thickness", thickness);
  vtp.array("direction", direction, 3);
  vtp.close();
  vtp.open("CellData");
  vtp.array("layer", layer);
  vtp.array("group", group);
  vtp.array("patch", patchIndex);
  vtp.close();
  vtp.open("Points");
  vtp.array("Points", points, 3);
  vtp.close();
  vtp.open("Polys");
  vtp.array("connectivity", connectivity);
  vtp.array("offsets", offsets);
  return vtp.finish();
}

} // namespace voluta::layers
