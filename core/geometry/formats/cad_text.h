// CAD files before a CAD kernel reads them, and the facets that it returns.
#pragma once

#include "geometry/formats/facet_soup.h"

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

enum class CadKind { Step, Iges };

// Returns the kind by the content, whatever the name's ending. Throws Error{UnreadableFile} if the
// file is empty, of another kind, or lacks its end: a kernel reads part of a truncated file without
// a word.
CadKind cadKindOf(std::string_view bytes, const std::string& name);

struct CadBody {
  std::string name; // of its product; empty: none
  std::vector<Facet> facets;
  Eigen::Vector3d placeMm{0.0, 0.0, 0.0}; // of the facets' origin in the file
};

struct CadFacets {
  std::vector<CadBody> bodies;
  std::size_t missingFaces = 0; // which could not be divided into facets
  std::size_t curves = 0;       // of no face
};

// Reads the output of voluta-cad-reader: "VCAD0001", the numbers of missing faces, curves and
// bodies; for each body the length of its name, the name, its place, its number of facets, and nine
// coordinates for each. Numbers are unsigned of 64 bits, coordinates doubles. Throws
// Error{UnreadableFile} if it has not this form. `name`: of the CAD file, for errors.
CadFacets readCadFacets(std::string_view output, const std::string& name);

} // namespace voluta::geometry
