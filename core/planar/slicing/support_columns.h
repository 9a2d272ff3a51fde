// Columns under what pieces leave hanging, section by section.
#pragma once

#include "base/run_context.h"
#include "planar/pieces.h"
#include "planar/slicing/section.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::planar {

struct ColumnOptions {
  double overhangRad = 0.7853981633974483; // how far a layer may reach out without a column
  double beadWidthMm = 1.2;
  double gapMm = 0.3;                 // kept to walls beside a column
  std::vector<Eigen::Vector2d> plate; // convex polygon on z = 0 that columns may stand on
};

struct SupportColumns {
  std::vector<Section> sections; // one a level, at half its height; empty where nothing is carried
  // What hangs over places where a column would have nothing to stand on.
  double unheldMm2 = 0.0;
  Eigen::Vector3d unheldAt = Eigen::Vector3d::Zero();
};

// The columns that carry pieces[piece] where a level reaches out over the one under it by more than
// overhangRad and a quarter of a bead. They go down to the piece itself, to what is printed before
// it (pieces before it in the list), or to the plate, and keep out of what is printed later. Wide
// ones taper downwards, by half of what a layer may reach out, to trunks of four beads, but for
// their narrow arms; what a wall leaves of one goes on along the wall. On slopes and edges they
// begin with what stands there, and grow out by half a bead a level. What is narrower than half a
// bead is not laid and carries nothing. `sections`: of each piece across the normal of this one's
// base. `bounds`: as layerBounds of this piece gives them. mm. Throws Cancelled.
SupportColumns supportColumns(const std::vector<Piece>& pieces, std::size_t piece,
                              const std::vector<Sections>& sections,
                              const std::vector<double>& bounds, const ColumnOptions& options,
                              const base::RunContext& ctx);

} // namespace voluta::planar
