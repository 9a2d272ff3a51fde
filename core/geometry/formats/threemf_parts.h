// The parts of a 3MF file, each as a mesh of its own.
#pragma once

#include "geometry/formats/part_of_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// Returns everything that is built as one part, at the origin. Throws as readMesh().
PartOfFile read3mfWhole(std::string_view bytes, const std::string& name);

// Returns a part for each printed build item. An item that is an assembly is divided into its
// components if they are apart and begin at the same height; else it is one part. Uses of an object
// that differ by a translation only have equal meshes. A file of one part: read3mfWhole(). Notes
// about the file are among the repairs of the first part. Throws as readMesh().
std::vector<PartOfFile> read3mfParts(std::string_view bytes, const std::string& name);

// Returns whether two meshes intersect or are at most 0.01 mm apart where they are closest.
bool touch(const TriangleMesh& a, const TriangleMesh& b);

} // namespace voluta::geometry
