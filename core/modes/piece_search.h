// Mode planar's search for pieces: the schemes and their parameters.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/planar_decomposition.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace voluta::modes {

// Parameters planarScheme, pieceClusters, pieceRoot.
base::ParameterTable pieceSearchParameters();

// Search options; only those of the chosen scheme are set.
struct PieceSearch {
  bool greedy = false;
  int clusters = 0;
  std::string root; // value of the parameter pieceRoot
};
PieceSearch pieceSearch(const base::ParameterValues& values);

// Parses "x,y,z" [mm, coordinates of the placed part]; returns nullopt for a blank text. Throws
// Error{Usage} if the text is not a point.
std::optional<Eigen::Vector3d> pieceRoot(const std::string& text);
std::string pieceRootText(const Eigen::Vector3d& root);

// Decomposes the part into pieces by the chosen scheme. Throws as beamDecompose and
// greedyDecompose, and Error{Usage} if the root is not a point.
planar::PlanarDecomposition searchPieces(const geometry::TriangleMesh& part,
                                         const planar::PlanarOptions& options,
                                         const PieceSearch& search, const base::RunContext& ctx);

} // namespace voluta::modes
