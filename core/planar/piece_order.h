// Print order of pieces, from their bases and from obstacles for the head.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace voluta::planar {

struct PieceOrder {
  std::vector<std::size_t> order;      // of indices
  std::vector<std::vector<int>> under; // per piece the indices of the pieces it is printed on
  std::size_t blocked = 0; // number of pieces that come after a piece that blocks the head
  // pairs of a blocked piece and the earlier piece that blocks it
  std::vector<std::pair<std::size_t, std::size_t>> late;
};

// `standsOnTag[i]`: the tag of the section that piece i is printed on; `holds[i]`: the tags of its
// other sections, sorted; isBlocking(i, j): returns whether j, if printed earlier, blocks the head
// at i. Pieces on the plate come first.
PieceOrder orderOf(const std::vector<std::int32_t>& standsOnTag,
                   const std::vector<std::vector<std::int32_t>>& holds,
                   const std::function<bool(std::size_t i, std::size_t j)>& isBlocking);

} // namespace voluta::planar
