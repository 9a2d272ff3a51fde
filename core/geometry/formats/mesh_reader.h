// Files that hold a mesh: STL, OBJ, PLY, OFF, 3MF. Others: geometry/formats/foreign_reader.h.
#pragma once

#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

struct MeshFile {
  TriangleMesh mesh;                  // points of equal coordinates are one vertex
  std::string format;                 // "STL (binary)", "STL (text)", "OBJ", "PLY", "OFF", "3MF"
  std::vector<base::Message> repairs; // what was left out while reading, a sentence each
};

// Reads the file of one mesh; all objects in it together are the mesh. Lengths are taken as mm;
// those of a 3MF are turned into mm from the unit that it names, which is told in `repairs`.
// Polygons are cut into triangles. The format is told by the content where it has a mark, else by
// the extension. A binary STL may begin with "solid". Text may be UTF-8 or UTF-16, with decimal
// points or commas, its lines end with LF or CR. Of a 3MF, what its build prints is read: supports,
// surfaces and items that are not printable are skipped, which is told in `repairs`; beams become
// round bars.
//
// Left out, and told in `repairs`: up to 1 % of facets (at least one) whose coordinates are not
// finite or beyond 1e9; the missing end of an STL that lacks at most 1 % of its facets.
//
// Throws Error{UnreadableFile}: missing, a directory, not a mesh, damaged (says where), cut short.
// Throws Error{UnusableInput}: no triangles, more bad facets than that (names the first), a 3MF
// with nothing to print, with sliced G-code instead of a model, or with an object in slices.
MeshFile readMesh(const std::filesystem::path& path);

// The same from bytes; `name` is used for the extension and in errors.
MeshFile readMesh(std::string_view bytes, const std::string& name);

// Binary STL of the mesh; coordinates rounded to float. Throws Error{CannotWrite} beyond 2^32 - 1
// triangles.
std::string writeStl(const TriangleMesh& mesh);

} // namespace voluta::geometry
