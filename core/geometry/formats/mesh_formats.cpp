#include "geometry/formats/mesh_formats.h"

#include "base/lower_case.h"
#include "geometry/formats/facet_soup.h"

#include <algorithm>
#include <iterator>

namespace voluta::geometry {

namespace {
constexpr MeshFormat kFormats[] = {{".stl", "STL", readStl},
                                   {".obj", "OBJ", readObj},
                                   {".ply", "PLY", readPly},
                                   {".off", "OFF", readOff},
                                   {".3mf", "3MF", read3mf},
                                   {".dae", "COLLADA"},
                                   {".gltf", "glTF"},
                                   {".glb", "glTF"},
                                   {".fbx", "FBX"},
                                   {".3ds", "3DS"},
                                   {".step", "STEP", nullptr, true},
                                   {".stp", "STEP", nullptr, true},
                                   {".iges", "IGES", nullptr, true},
                                   {".igs", "IGES", nullptr, true}};
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
