// What the readers hand over: facets as they stand in a file, before vertices are shared.
#pragma once

#include "base/text.h"
#include "geometry/formats/mesh_reader.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

using Facet = std::array<Eigen::Vector3d, 3>;

struct FacetSoup {
  std::vector<Facet> facets;
  std::string format;
  std::vector<base::Message> repairs; // what was left out, a sentence each
};

// Whether the bytes are as many as the header of a binary STL says.
bool isBinaryStl(std::string_view bytes);
// Whether the bytes are an STL of either kind.
bool looksLikeStl(std::string_view bytes);
// Throws Error{UnreadableFile} with the line or the facet.
FacetSoup readStl(std::string_view bytes, const std::string& name);
// Throw Error{UnreadableFile} with the line or the byte.
FacetSoup readObj(std::string_view bytes, const std::string& name);
FacetSoup readOff(std::string_view bytes, const std::string& name);
FacetSoup readPly(std::string_view bytes, const std::string& name);
// All that is built, each object where it is used; lengths in mm. Throws Error{UnreadableFile} with
// the member of the package and the line.
FacetSoup read3mf(std::string_view bytes, const std::string& name);

// Appends the polygon's triangles.
void addPolygon(const std::vector<Eigen::Vector3d>& polygon, std::vector<Facet>& facets);

// One vertex for all corners of equal coordinates (-0 is 0), in order of first use.
TriangleMesh shareVertices(const std::vector<Facet>& facets);

// The mesh of a file's facets, bad ones left out; throws what readMesh does of them.
MeshFile meshOf(FacetSoup soup, const std::string& name);

} // namespace voluta::geometry
