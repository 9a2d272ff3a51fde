// What searches for cuts ask of each face of a piece, worked out once.
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
  std::vector<double> risky;           // the area where it needs support as things are, else 0
  std::vector<std::uint8_t> stands;    // what the piece stands on
  std::vector<std::uint8_t> laid;      // lies on what is printed before, however it is printed
  std::vector<std::array<int, 3>> neighbour; // across side k; -1: none
  double standsMm2 = 0.0;
};

FaceTable faceTable(const Piece& piece, const RiskRule& rule);

} // namespace voluta::planar
