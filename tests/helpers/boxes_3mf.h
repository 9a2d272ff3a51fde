// The text of 3MF models of boxes.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace voluta::test {

inline std::string boxMesh(const Eigen::Vector3d& size) {
  std::string xml = "<mesh><vertices>";
  for (int i = 0; i < 8; ++i)
    xml += fmt::format(R"(<vertex x="{}" y="{}" z="{}"/>)", i & 1 ? size.x() : 0.0,
                       i & 2 ? size.y() : 0.0, i & 4 ? size.z() : 0.0);
  xml += "</vertices><triangles>";
  for (const auto& t : std::vector<std::array<int, 3>>{{0, 2, 1},
                                                       {1, 2, 3},
                                                       {4, 5, 6},
                                                       {5, 7, 6},
                                                       {0, 1, 4},
                                                       {1, 5, 4},
                                                       {2, 6, 3},
                                                       {3, 6, 7},
                                                       {0, 4, 2},
                                                       {2, 4, 6},
                                                       {1, 3, 5},
                                                       {3, 7, 5}})
    xml += fmt::format(R"(<triangle v1="{}" v2="{}" v3="{}"/>)", t[0], t[1], t[2]);
  return xml + "</triangles></mesh>";
}

inline std::string object3mf(int id, const std::string& name, const std::string& content) {
  return fmt::format(R"(<object id="{}" name="{}">{}</object>)", id, name, content);
}

// `element`: item or component.
inline std::string use3mf(const char* element, int id, const Eigen::Affine3d& at) {
  std::string numbers;
  for (Eigen::Index i = 0; i < 12; ++i)
    numbers += fmt::format("{} ", at.matrix()(i % 3, i / 3));
  return fmt::format(R"(<{} objectid="{}" transform="{}"/>)", element, id, numbers);
}

inline Eigen::Affine3d moved(double x, double y, double z = 0.0) {
  return Eigen::Affine3d(Eigen::Translation3d(x, y, z));
}

inline std::string model3mf(const std::string& resources, const std::string& build,
                            const std::string& unit = "millimeter") {
  return "<model unit=\"" + unit +
         "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

} // namespace voluta::test
