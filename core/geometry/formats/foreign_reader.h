// Mesh files in formats that this program has no reader of its own for: COLLADA, glTF and what else
// assimp takes. They are read by a program of its own that comes with this one, voluta-mesh-reader:
// a damaged file ends that program and not this one.
#pragma once

#include "geometry/formats/mesh_reader.h"

#include <chrono>
#include <filesystem>

namespace voluta::geometry {

// By the extension: dae, gltf, glb, fbx, 3ds.
bool isForeign(const std::filesystem::path& file);

enum class ForeignFrame {
  AsWritten, // lengths and axes as in the file, COLLADA's in metres: what a URDF refers to
  Upright    // z up, mm, where the format says what is up and how long: COLLADA and glTF
};

// Other files that the file refers to are looked for beside it. Takes as long as `limit`.
// Throws Error{UnreadableFile}: not there, not readable or damaged, longer than the limit, the
// program that reads it is missing. Error{UnusableInput}: no triangles.
MeshFile readForeign(const std::filesystem::path& file, ForeignFrame frame,
                     std::chrono::milliseconds limit = std::chrono::seconds(30));

} // namespace voluta::geometry
