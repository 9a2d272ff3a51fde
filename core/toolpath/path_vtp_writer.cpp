#include "toolpath/path_vtp_writer.h"

#include "base/vtk_xml.h"

#include <cstdint>
#include <vector>

namespace voluta::toolpath {

namespace {
std::vector<float> flat(const std::vector<Eigen::Vector3d>& v) {
  std::vector<float> out;
  out.reserve(3 * v.size());
  for (const auto& p : v)
    for (int k = 0; k < 3; ++k)
      out.push_back(static_cast<float>(p[k]));
  return out;
}
} // namespace

std::string writeToolpathVtp(const plan::ToolPlan& plan) {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::int32_t> layer, patch, group, kind;
  for (const plan::ToolPath& path : plan.paths) {
    for (std::size_t i = 0; i < path.count; ++i)
      connectivity.push_back(static_cast<std::int64_t>(path.first + i));
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    layer.push_back(path.layer);
    patch.push_back(path.patch);
    group.push_back(path.group);
    kind.push_back(static_cast<std::int32_t>(path.kind));
  }
  base::VtkXml vtp("PolyData");
  vtp.open("Piece", {{"NumberOfPoints", std::to_string(plan.waypointCount())},
                     {"NumberOfLines", std::to_string(plan.paths.size())}});
  vtp.open("Points");
  vtp.array("Points", flat(plan.position), 3);
  vtp.close();
  vtp.open("Lines");
  vtp.array("connectivity", connectivity);
  vtp.array("offsets", offsets);
  vtp.close();
  vtp.open("PointData");
  vtp.array("width", plan.widthMm);
  vtp.array("height", plan.heightMm);
  vtp.array("speed", plan.speedMmPerS);
  vtp.array("direction", flat(plan.direction), 3);
  vtp.close();
  vtp.open("CellData");
  vtp.array("layer", layer);
  vtp.array("patch", patch);
  vtp.array("group", group);
  vtp.array("kind", kind);
  return vtp.finish();
}

} // namespace voluta::toolpath
