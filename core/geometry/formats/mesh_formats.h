// The formats of mesh files, by the endings of their names.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace voluta::geometry {

struct FacetSoup;

struct MeshFormat {
  std::string_view ending; // lower case, with its dot
  std::string_view name;
  // Reads the content of a file (geometry/formats/facet_soup.h); `file` names it in errors.
  // nullptr: a separate program reads the format (geometry/formats/foreign_reader.h).
  FacetSoup (*read)(std::string_view bytes, const std::string& file) = nullptr;
  bool cad = false; // solids and surfaces (geometry/formats/cad_reader.h)

  bool foreign() const { return !read; }
};

std::span<const MeshFormat> meshFormats();
// Returns nullptr if no format has the ending of that name.
const MeshFormat* meshFormatOf(const std::filesystem::path& file);
// Returns the names of all formats, each once, "STL, OBJ".
std::string meshFormatNames();
// Returns whether a file without one of these endings is read as a mesh, by its content.
bool looksLikeMesh(std::string_view bytes);

} // namespace voluta::geometry
