// Support columns below the overhangs of pieces, section by section.
#pragma once

#include "base/run_context.h"
#include "layers/support_places.h"
#include "planar/pieces.h"
#include "planar/slicing/section.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

struct ColumnOptions {
  double overhangRad = 0.7853981633974483; // maximum overhang of a layer without a column
  double beadWidthMm = 1.2;
  double gapMm = 0.3;                 // to walls beside a column
  std::vector<Eigen::Vector2d> plate; // convex polygon on z = 0 that may carry columns
  layers::SupportRule rule = layers::SupportRule::Auto; // outside of the places
  const layers::SupportPlaces* places = nullptr;        // of regions; may be null
};

struct SupportColumns {
  // One per level, at half its height; empty where nothing is carried
  std::vector<Section> sections;
  // Overhangs over places where a column would have no base.
  double unheldMm2 = 0.0;
  Eigen::Vector3d unheldAt = Eigen::Vector3d::Zero();
};

// Returns the columns below overhangs of pieces[piece]: places where a level protrudes over the one
// below by more than overhangRad and a quarter of a bead. Columns extend down to the piece itself,
// to the pieces before it in the list, or to the plate, and keep clear of pieces printed later.
// Wide columns, except for narrow arms, taper downwards by half of a layer's permitted overhang to
// trunks of four beads; where a wall cuts into a column, its rest continues along the wall. On
// slopes and edges columns start from their supported part and grow by half a bead per level. Areas
// narrower than half a bead are not printed and carry nothing.
// Regions say where every overhang is carried and where none is; columns of other places may pass
// through them. `sections`: of each piece,
// perpendicular to the normal of this one's base. `bounds`: layerBounds() of this piece [mm].
// Throws Cancelled.
SupportColumns supportColumns(const std::vector<Piece>& pieces, std::size_t piece,
                              const std::vector<Sections>& sections,
                              const std::vector<double>& bounds, const ColumnOptions& options,
                              const base::RunContext& ctx);

} // namespace voluta::planar
