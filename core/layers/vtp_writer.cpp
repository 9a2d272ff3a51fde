#include "layers/vtp_writer.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace voluta::layers {

namespace {

static_assert(std::endian::native == std::endian::little, "VTP arrays are written as they lie");

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t v = 0;
    for (std::size_t k = 0; k < 3; ++k)
      v = v << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += k <= n ? digits[v >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

template <typename T>
void appendArray(std::string& xml, const char* type, const char* name, int components,
                 const std::vector<T>& values) {
  std::string bytes(sizeof(std::uint64_t) + values.size() * sizeof(T), '\0');
  const std::uint64_t size = values.size() * sizeof(T);
  std::memcpy(bytes.data(), &size, sizeof size);
  if (!values.empty())
    std::memcpy(bytes.data() + sizeof size, values.data(), size);
  xml += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">" +
         base64(bytes) + "</DataArray>\n";
}

} // namespace

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
  std::string xml = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece "
                    "NumberOfPoints=\"" +
                    std::to_string(points.size() / 3) + "\" NumberOfPolys=\"" +
                    std::to_string(offsets.size()) + "\">\n<PointData>\n";
  appendArray(xml, "Float32", "thickness", 1, thickness);
  appendArray(xml, "Float32", "direction", 3, direction);
  xml += "</PointData>\n<CellData>\n";
  appendArray(xml, "Int32", "layer", 1, layer);
  appendArray(xml, "Int32", "group", 1, group);
  appendArray(xml, "Int32", "patch", 1, patchIndex);
  xml += "</CellData>\n<Points>\n";
  appendArray(xml, "Float32", "Points", 3, points);
  xml += "</Points>\n<Polys>\n";
  appendArray(xml, "Int32", "connectivity", 1, connectivity);
  appendArray(xml, "Int32", "offsets", 1, offsets);
  xml += "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return xml;
}

} // namespace voluta::layers
