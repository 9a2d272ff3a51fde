// Arrays of a VTK XML file, found by its header.
#pragma once

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace voluta::test {

// The values of the array of this name; a failure and none where there is no such array.
template <typename T> std::vector<T> vtkArray(const std::string& file, const std::string& name) {
  const std::string start = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t data = file.find(start), array = file.find("Name=\"" + name + "\"");
  if (data == std::string::npos || array == std::string::npos) {
    ADD_FAILURE() << "no array " << name;
    return {};
  }
  const std::size_t offset = file.find("offset=\"", array) + 8;
  const std::size_t at = data + start.size() + std::stoul(file.substr(offset));
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, file.data() + at, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  if (bytes > 0)
    std::memcpy(values.data(), file.data() + at + sizeof bytes, bytes);
  return values;
}

} // namespace voluta::test
