// Reads mesh files of the formats in geometry/formats/mesh_formats.h that have a reader in this
// program. For others see geometry/formats/foreign_reader.h.
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
  std::string format;                 // "STL (binary)", "STL (text)", "OBJ"
  std::vector<base::Message> repairs; // omitted content, a sentence each
};

// Reads the file of one mesh, which all objects in it form together. Lengths are taken as mm; those
// of a 3MF are converted from its unit, as reported in `repairs`. Polygons are triangulated. The
// format is detected by the content if it has a signature, else by the extension. A binary STL may
// begin with "solid". Text may be UTF-8 or UTF-16, with decimal points or commas and lines ending
// with LF or CR. Of a 3MF, the printed items of its build are read: supports, surfaces and
// unprintable items are skipped, as reported in `repairs`; beams become round bars.
//
// Omitted, and reported in `repairs`: up to 1 % of the facets (at least one) whose coordinates are
// not finite or beyond 1e9; the missing end of an STL that lacks at most 1 % of its facets.
//
// Throws Error{UnreadableFile} if the file is missing, a directory, not a mesh, damaged (with the
// place) or truncated. Throws Error{UnusableInput} if it has no triangles, more invalid facets than
// that (naming the first), or if it is a 3MF with nothing to print, with sliced G-code instead of a
// model, or with an object in slices.
MeshFile readMesh(const std::filesystem::path& path);

// Same from bytes; `name` is used for the extension and in errors.
MeshFile readMesh(std::string_view bytes, const std::string& name);

// Returns a binary STL of the mesh; coordinates are rounded to float. Throws Error{CannotWrite}
// beyond 2^32 - 1 triangles.
std::string writeStl(const TriangleMesh& mesh);

} // namespace voluta::geometry
