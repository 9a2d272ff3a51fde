// What the readers hand over: facets as they stand in a file, before vertices are shared.
#pragma once

#include "geometry/mesh_reader.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

using Facet = std::array<Eigen::Vector3d, 3>;

struct FacetSoup {
  std::vector<Facet> facets;
  std::string format;
  std::vector<std::string> repairs;
};

// Whether the bytes are an STL of either kind.
bool looksLikeStl(std::string_view bytes);
// Throws Error{UnreadableFile} with the line or the facet.
FacetSoup readStl(std::string_view bytes, const std::string& name);
// OBJ, PLY, OFF, 3MF by assimp; `extension` in lower case without the dot. Throws
// Error{UnreadableFile} with assimp's reason.
FacetSoup readByAssimp(std::string_view bytes, const std::string& extension,
                       const std::string& name);

// One vertex for all corners of equal coordinates (-0 is 0), in order of first use.
TriangleMesh shareVertices(const std::vector<Facet>& facets);

} // namespace voluta::geometry
