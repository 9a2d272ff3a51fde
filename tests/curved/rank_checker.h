// An order of growth judged by code that shares nothing with the growers: a hull by CGAL from the
// corners of the hull before and the new voxels of each rank.
#pragma once

#include "curved/decomposition.h"

#include <cstddef>

namespace voluta::test {

struct RankVerdict {
  std::size_t printed = 0, missed = 0;
  std::size_t unsupported = 0; // no AM-stable neighbour of lower rank, not on the platform
  std::size_t inside = 0;      // strictly inside the hull of the platform and all lower ranks
  double deepest = 0.0;        // of those, cells
  std::size_t wrongCells = 0;  // solid without a rank, or a rank where nothing is
};

RankVerdict checkRanks(const curved::Decomposition& decomposition,
                       const std::vector<std::uint8_t>& solid);

struct FieldVerdict {
  double within = 0.0; // share of the voxels whose thickness is within the limits
  double mean = 0.0, deviation = 0.0, p01 = 0.0, p99 = 0.0; // thickness, mm
  double inaccessible = 0.0; // share deeper than half a cell inside the hull of earlier levels
  double deepest = 0.0;      // cells
  int levels = 0;
  std::size_t patches = 0;      // connected pieces of levels (faces of cells)
  std::size_t islandVoxels = 0; // in pieces without an AM-stable neighbour of a lower level
  std::size_t islands = 0;
};

// thickness = height / |grad field|, the gradient by least squares over the 26 cells around.
FieldVerdict checkField(const curved::Decomposition& decomposition, double heightMm, double minMm,
                        double maxMm);

} // namespace voluta::test
