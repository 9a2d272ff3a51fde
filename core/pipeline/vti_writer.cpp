#include "pipeline/vti_writer.h"

#include <cstdint>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {
// A block of VTK's appended data: its length in bytes, then the bytes.
template <typename T> std::size_t append(std::string& data, const std::vector<T>& values) {
  const std::size_t offset = data.size();
  const std::uint64_t bytes = values.size() * sizeof(T);
  data.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
  data.append(reinterpret_cast<const char*>(values.data()), bytes);
  return offset;
}
} // namespace

std::string voxelsVti(const curved::Decomposition& d) {
  std::vector<double> platform;
  for (const Eigen::Vector2d& corner : d.platform)
    platform.insert(platform.end(), {corner.x(), corner.y()});
  const std::vector<double> epsilon{d.epsilonMm};
  const std::vector<std::uint8_t> none(d.rank.size(), 0);
  const std::vector<std::uint8_t>& kind = d.support.empty() ? none : d.support;
  const std::vector<std::uint8_t>& byHead = d.byHead.empty() ? none : d.byHead;

  std::string data = "_";
  const auto offsetOf = [&](const auto& values) { return append(data, values) - 1; };
  const std::size_t platformAt = offsetOf(platform), epsilonAt = offsetOf(epsilon),
                    rankAt = offsetOf(d.rank), kindAt = offsetOf(kind), byHeadAt = offsetOf(byHead),
                    fieldAt = d.field.empty() ? 0 : offsetOf(d.field);
  const Eigen::Vector3i n = d.grid.size;
  const Eigen::Vector3d o = d.grid.origin;
  const std::string extent = fmt::format("0 {} 0 {} 0 {}", n.x(), n.y(), n.z());
  std::string text = fmt::format(
      R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{0}" Origin="{1} {2} {3}" Spacing="{4} {4} {4}">
<FieldData>
<DataArray type="Float64" Name="platform" NumberOfComponents="2" NumberOfTuples="{5}" format="appended" offset="{6}"/>
<DataArray type="Float64" Name="epsilon" NumberOfTuples="1" format="appended" offset="{7}"/>
</FieldData>
<Piece Extent="{0}">
<CellData>
<DataArray type="Int32" Name="rank" format="appended" offset="{8}"/>
<DataArray type="UInt8" Name="kind" format="appended" offset="{9}"/>
<DataArray type="UInt8" Name="byHead" format="appended" offset="{10}"/>
{11}</CellData>
</Piece>
</ImageData>
<AppendedData encoding="raw">
)",
      extent, o.x(), o.y(), o.z(), d.grid.pitch, d.platform.size(), platformAt, epsilonAt, rankAt,
      kindAt, byHeadAt,
      d.field.empty()
          ? std::string()
          : fmt::format(
                "<DataArray type=\"Float32\" Name=\"field\" format=\"appended\" offset=\"{}\"/>\n",
                fieldAt));
  text += data;
  text += "\n</AppendedData>\n</VTKFile>\n";
  return text;
}

} // namespace voluta::pipeline
