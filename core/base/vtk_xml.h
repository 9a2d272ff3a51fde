// Writes files in VTK's XML formats for other programs (ParaView), without VTK.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::base {

// A file being written: elements with their arrays, whose values are appended raw and little-endian
// at the end (https://docs.vtk.org, "VTK XML formats").
class VtkXml {
public:
  // `type`: of the data set, e.g. "PolyData"; its element is opened.
  using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;
  explicit VtkXml(std::string_view type, Attributes attributes = {});

  void open(std::string_view element, Attributes attributes = {});
  void close(); // Closes the element opened last

  // Adds an array to the open element; T: float, double, std::uint8_t, std::int32_t, std::int64_t.
  // `components` values form a tuple.
  template <typename T>
  void array(std::string_view name, const std::vector<T>& values, int components = 1);
  // As array(), for elements in which a reader cannot know the number of tuples (FieldData).
  template <typename T>
  void field(std::string_view name, const std::vector<T>& values, int components = 1);

  // Closes all elements and returns the bytes of the file.
  std::string finish();

private:
  void declare(std::string_view type, std::string_view name, int components,
               const std::size_t* tuples, const void* values, std::size_t bytes);

  std::string head_, data_;
  std::vector<std::string> open_;
};

} // namespace voluta::base
