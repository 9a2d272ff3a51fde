#include "geometry/formats/mesh_formats.h"

#include "base/lower_case.h"

#include <algorithm>
#include <iterator>

namespace voluta::geometry {

namespace {
constexpr MeshFormat kFormats[] = {{".stl", "STL"},         {".obj", "OBJ"},
                                   {".ply", "PLY"},         {".off", "OFF"},
                                   {".3mf", "3MF"},         {".dae", "COLLADA", true},
                                   {".gltf", "glTF", true}, {".glb", "glTF", true},
                                   {".fbx", "FBX", true},   {".3ds", "3DS", true}};
} // namespace

std::span<const MeshFormat> meshFormats() {
  return kFormats;
}

std::string meshFormatNames() {
  std::string names;
  std::string_view last;
  for (const MeshFormat& format : kFormats) {
    if (format.name != last)
      names += (names.empty() ? "" : ", ") + std::string(format.name);
    last = format.name;
  }
  return names;
}

const MeshFormat* meshFormatOf(const std::filesystem::path& file) {
  const std::string ending = base::lowerCase(file.extension().string());
  const auto* format = std::ranges::find(kFormats, ending, &MeshFormat::ending);
  return format == std::end(kFormats) ? nullptr : format;
}

} // namespace voluta::geometry
