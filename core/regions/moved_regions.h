// The regions of a part that is cut, or divided into its bodies.
#pragma once

#include "project/region.h"

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace voluta::regions {

// A piece of a part where the part was printed: its mesh is in the part's work frame.
struct PieceOfPart {
  Eigen::Isometry3d work_T_file =
      Eigen::Isometry3d::Identity(); // the part's, of scaled coordinates
  double scale = 1.0;                // from its file's lengths to mm
  Eigen::AlignedBox3d partBox, box;  // of the part and the piece [mm]
  bool keepsHeight = true;           // the piece stays as high over the plate as it was
};

// Returns the regions for the file of the piece, at the same places of the material. A shape that
// cannot be turned becomes a body, a range of heights a box if the piece gets another height.
// Regions that cut, which the piece already has, and those beside it are left out.
std::vector<project::Region> regionsOfPiece(std::span<const project::Region> all,
                                            const PieceOfPart& piece);

} // namespace voluta::regions
