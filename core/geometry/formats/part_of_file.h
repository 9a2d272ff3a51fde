// One of the parts that a file holds.
#pragma once

#include "geometry/formats/mesh_reader.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>

namespace voluta::geometry {

constexpr std::size_t kMaxPartsOfFile = 255;

struct PartOfFile {
  std::string name; // of its object or product; empty: none
  MeshFile file;
  Eigen::Vector3d placeMm{0.0, 0.0, 0.0}; // of the mesh's origin in the file
};

// Throws Error{UnusableInput} if the file holds more than kMaxPartsOfFile parts.
void requirePrintable(std::size_t parts, const std::string& file);

} // namespace voluta::geometry
