#include "curved/vti_writer.h"

#include "base/vtk_xml.h"

#include <cstdint>
#include <fmt/format.h>

namespace voluta::curved {

std::string voxelsVti(const Decomposition& d) {
  std::vector<double> platform;
  for (const Eigen::Vector2d& corner : d.platform)
    platform.insert(platform.end(), {corner.x(), corner.y()});
  const std::vector<std::uint8_t> none(d.rank.size(), 0);
  const Eigen::Vector3i n = d.grid.size;
  const Eigen::Vector3d o = d.grid.origin;
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", n.x(), n.y(), n.z());

  base::VtkXml vti("ImageData", {{"WholeExtent", extent},
                                 {"Origin", fmt::format("{} {} {}", o.x(), o.y(), o.z())},
                                 {"Spacing", fmt::format("{0} {0} {0}", d.grid.pitch)}});
  vti.open("FieldData");
  vti.field("platform", platform, 2);
  vti.field("epsilon", std::vector<double>{d.epsilonMm});
  vti.close();
  vti.open("Piece", {{"Extent", extent}});
  vti.open("CellData");
  vti.array("rank", d.rank);
  vti.array("kind", d.support.empty() ? none : d.support);
  vti.array("byHead", d.byHead.empty() ? none : d.byHead);
  if (!d.field.empty())
    vti.array("field", d.field);
  return vti.finish();
}

} // namespace voluta::curved
