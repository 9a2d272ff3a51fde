// Result of the readers: facets as in a file, before vertices are shared.
#pragma once

#include "base/text.h"

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

struct MeshFile;
struct TriangleMesh;

using Facet = std::array<Eigen::Vector3d, 3>;

struct FacetSoup {
  std::vector<Facet> facets;
  std::string format;
  std::vector<base::Message> repairs; // omitted content, a sentence each
};

// Returns whether the size matches the header of a binary STL.
bool isBinaryStl(std::string_view bytes);
// Returns whether the bytes are an STL, binary or text.
bool looksLikeStl(std::string_view bytes);
// Throws Error{UnreadableFile} with the line or the facet.
FacetSoup readStl(std::string_view bytes, const std::string& name);
// These throw Error{UnreadableFile} with the line or the byte.
FacetSoup readObj(std::string_view bytes, const std::string& name);
FacetSoup readOff(std::string_view bytes, const std::string& name);
FacetSoup readPly(std::string_view bytes, const std::string& name);
// Returns everything that is built, each object at every use; lengths in mm. Throws
// Error{UnreadableFile} with the member of the package and the line.
FacetSoup read3mf(std::string_view bytes, const std::string& name);

// Appends the polygon's triangles.
void addPolygon(const std::vector<Eigen::Vector3d>& polygon, std::vector<Facet>& facets);

// Merges corners of equal coordinates (-0 is 0) into one vertex, in order of first use.
TriangleMesh shareVertices(const std::vector<Facet>& facets);

// Returns the mesh of a file's facets without invalid ones; throws as readMesh.
MeshFile meshOf(FacetSoup soup, const std::string& name);

} // namespace voluta::geometry
