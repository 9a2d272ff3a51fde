// Files in formats without a reader in this program: COLLADA, glTF and others that assimp reads,
// and CAD files (geometry/formats/cad_reader.h). Separate programs read them, so that a damaged
// file can only crash these.
#pragma once

#include "geometry/formats/mesh_reader.h"

#include <chrono>
#include <filesystem>

namespace voluta::geometry {

// Returns whether the file's format is foreign (geometry/formats/mesh_formats.h).
bool isForeign(const std::filesystem::path& file);

enum class ForeignFrame {
  AsWritten, // axes and lengths as in the file, COLLADA's and CAD's in metres: for a URDF
  Upright    // z up, mm, if the format states up axis and unit: COLLADA, glTF and CAD
};

// Files that the file refers to are read from its folder. Takes at most `limit`. Throws
// Error{UnreadableFile} if the file is missing, unreadable or damaged, takes longer than the limit,
// or the reader program is missing; Error{UnusableInput} if there are no triangles.
MeshFile readForeign(const std::filesystem::path& file, ForeignFrame frame,
                     std::chrono::milliseconds limit = std::chrono::seconds(120));

// Reads a mesh of any format. `frame` matters to foreign ones. Throws as readMesh() and
// readForeign().
MeshFile readMeshOf(const std::filesystem::path& file, ForeignFrame frame);

} // namespace voluta::geometry
