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

// What the pieces found depend on of these: of the chosen scheme only.
std::string pieceSearchKey(const base::ParameterValues& values);

// "x,y,z" in mm, of the placed part; empty: none. Throws Error{Usage}.
std::optional<Eigen::Vector3d> pieceRoot(const std::string& text);
std::string pieceRootText(const Eigen::Vector3d& root);

// Pieces by the chosen scheme. Throws as beamDecompose and greedyDecompose; Error{Usage} for a root
// that is no point.
planar::PlanarDecomposition searchPieces(const geometry::TriangleMesh& part,
                                         const planar::PlanarOptions& options,
                                         const base::ParameterValues& values,
                                         const base::RunContext& ctx);

} // namespace voluta::modes
