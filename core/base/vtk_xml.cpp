#include "base/vtk_xml.h"

#include <bit>
#include <fmt/format.h>

namespace voluta::base {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie");

namespace {
template <typename T> constexpr std::string_view kTypeName = "";
template <> constexpr std::string_view kTypeName<float> = "Float32";
template <> constexpr std::string_view kTypeName<double> = "Float64";
template <> constexpr std::string_view kTypeName<std::uint8_t> = "UInt8";
template <> constexpr std::string_view kTypeName<std::int32_t> = "Int32";
template <> constexpr std::string_view kTypeName<std::int64_t> = "Int64";
} // namespace

VtkXml::VtkXml(std::string_view type, Attributes attributes)
    : head_(fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" "
                        "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n",
                        type)) {
  open(type, attributes);
}

void VtkXml::open(std::string_view element, Attributes attributes) {
  head_ += fmt::format("<{}", element);
  for (const auto& [key, value] : attributes)
    head_ += fmt::format(" {}=\"{}\"", key, value);
  head_ += ">\n";
  open_.emplace_back(element);
}

void VtkXml::close() {
  head_ += fmt::format("</{}>\n", open_.back());
  open_.pop_back();
}

template <typename T>
void VtkXml::array(std::string_view name, const std::vector<T>& values, int components) {
  declare(kTypeName<T>, name, components, nullptr, values.data(), values.size() * sizeof(T));
}

template <typename T>
void VtkXml::field(std::string_view name, const std::vector<T>& values, int components) {
  const std::size_t tuples = values.size() / static_cast<std::size_t>(components);
  declare(kTypeName<T>, name, components, &tuples, values.data(), values.size() * sizeof(T));
}

void VtkXml::declare(std::string_view type, std::string_view name, int components,
                     const std::size_t* tuples, const void* values, std::size_t bytes) {
  head_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", type, name,
                       components);
  if (tuples)
    head_ += fmt::format(" NumberOfTuples=\"{}\"", *tuples);
  head_ += fmt::format(" format=\"appended\" offset=\"{}\"/>\n", data_.size());
  const std::uint64_t size = bytes;
  data_.append(reinterpret_cast<const char*>(&size), sizeof size);
  if (bytes > 0)
    data_.append(static_cast<const char*>(values), bytes);
}

std::string VtkXml::finish() {
  while (!open_.empty())
    close();
  return std::move(head_) + "<AppendedData encoding=\"raw\">\n_" + data_ +
         "\n</AppendedData>\n</VTKFile>\n";
}

template void VtkXml::array(std::string_view, const std::vector<float>&, int);
template void VtkXml::array(std::string_view, const std::vector<double>&, int);
template void VtkXml::array(std::string_view, const std::vector<std::uint8_t>&, int);
template void VtkXml::array(std::string_view, const std::vector<std::int32_t>&, int);
template void VtkXml::array(std::string_view, const std::vector<std::int64_t>&, int);
template void VtkXml::field(std::string_view, const std::vector<float>&, int);
template void VtkXml::field(std::string_view, const std::vector<double>&, int);
template void VtkXml::field(std::string_view, const std::vector<std::uint8_t>&, int);
template void VtkXml::field(std::string_view, const std::vector<std::int32_t>&, int);
template void VtkXml::field(std::string_view, const std::vector<std::int64_t>&, int);

} // namespace voluta::base
