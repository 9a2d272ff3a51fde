// Per-face data of a piece, precomputed for the searches for cuts.
#pragma once

#include "planar/pieces.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace voluta::planar {

struct FaceTable {
  std::vector<Eigen::Vector3d> normal; // unit, outward
  std::vector<double> area;            // mm2
  std::vector<double> risky;           // its area if it needs support in the current piece, else 0
  std::vector<std::uint8_t> stands;    // 1: the piece stands on this face
  // 1: the face is on earlier material, whatever the print direction
  std::vector<std::uint8_t> onPrinted;
  std::vector<std::array<int, 3>> neighbour; // across side k; -1: none
  double standsMm2 = 0.0;
};

FaceTable faceTable(const Piece& piece, const RiskRule& rule);

} // namespace voluta::planar
