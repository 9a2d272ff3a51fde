// How mode planar looks for pieces: the schemes and their parameters.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "planar/decomposition.h"

#include <Eigen/Core>
#include <optional>
#include <string>

namespace voluta::modes {

// planarScheme, pieceClusters, pieceRoot.
base::ParameterTable pieceSearchParameters();

// How pieces are searched for; of the scheme that is chosen only.
struct PieceSearch {
  bool greedy = false;
  int clusters = 0;
  std::string root; // pieceRoot
};
PieceSearch pieceSearch(const base::ParameterValues& values);

// "x,y,z" in mm, of the placed part; empty: none. Throws Error{Usage}.
std::optional<Eigen::Vector3d> pieceRoot(const std::string& text);
std::string pieceRootText(const Eigen::Vector3d& root);

// Pieces by the chosen scheme. Throws as beamDecompose and greedyDecompose; Error{Usage} for a root
// that is no point.
planar::PlanarDecomposition searchPieces(const geometry::TriangleMesh& part,
                                         const planar::PlanarOptions& options,
                                         const PieceSearch& search, const base::RunContext& ctx);

} // namespace voluta::modes
