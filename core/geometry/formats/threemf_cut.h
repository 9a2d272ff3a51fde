// Negative volumes of a 3MF: what a slicer cuts out of the other volumes of their build item.
#pragma once

#include "geometry/formats/threemf_build.h"
#include "geometry/triangle_mesh.h"

#include <vector>

namespace voluta::geometry {

// Returns the mesh of the facets that a mesh can have: finite, and not too far away.
TriangleMesh soundMesh(const std::vector<Facet>& facets);

// Cuts the negative pieces out of the solid ones of their items, exactly, and removes all pieces
// that are not solid or of which nothing is left. Meshes that the cut does not accept are repaired
// first. `name`: of the file, for errors. Throws Error{UnusableInput} with the names of the volumes
// if they cannot be cut even then.
void cutNegatives(std::vector<ThreemfPiece>& pieces, const std::string& name);

} // namespace voluta::geometry
