#include "toolpath/vtp_writer.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <vector>

namespace voluta::toolpath {

namespace {
static_assert(std::endian::native == std::endian::little);

// Arrays named in the head, their bytes behind it.
class Appended {
public:
  template <typename T>
  std::string array(const char* name, const char* type, int components, const std::vector<T>& v) {
    std::string tag = fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" "
                                  "format=\"appended\" offset=\"{}\"/>\n",
                                  type, name, components, bytes_.size());
    const std::uint64_t size = v.size() * sizeof(T);
    put(&size, sizeof size);
    put(v.data(), v.size() * sizeof(T));
    return tag;
  }
  const std::string& bytes() const { return bytes_; }

private:
  void put(const void* data, std::size_t size) {
    if (size > 0)
      bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

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
  Appended data;
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
  out += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" "
                     "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                     plan.waypointCount(), plan.paths.size());
  out += "<Points>\n" + data.array("Points", "Float32", 3, flat(plan.position)) + "</Points>\n";
  out += "<Lines>\n" + data.array("connectivity", "Int64", 1, connectivity);
  out += data.array("offsets", "Int64", 1, offsets) + "</Lines>\n";
  out += "<PointData>\n" + data.array("width", "Float32", 1, plan.widthMm);
  out += data.array("height", "Float32", 1, plan.heightMm);
  out += data.array("speed", "Float32", 1, plan.speedMmPerS);
  out += data.array("direction", "Float32", 3, flat(plan.direction)) + "</PointData>\n";
  out += "<CellData>\n" + data.array("layer", "Int32", 1, layer);
  out += data.array("patch", "Int32", 1, patch) + data.array("group", "Int32", 1, group);
  out += data.array("kind", "Int32", 1, kind) + "</CellData>\n";
  out += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_" + data.bytes() +
         "\n</AppendedData>\n</VTKFile>\n";
  return out;
}

} // namespace voluta::toolpath
