// The formats of mesh files, by the endings of their names.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace voluta::geometry {

struct MeshFormat {
  std::string_view ending; // lower case, with its dot
  std::string_view name;
  bool foreign = false; // has no reader in this program (geometry/formats/foreign_reader.h)
};

std::span<const MeshFormat> meshFormats();
// Returns nullptr if no format has the ending of that name.
const MeshFormat* meshFormatOf(const std::filesystem::path& file);

} // namespace voluta::geometry
