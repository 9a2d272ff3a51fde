// In which order pieces are printed, from what stands on what and what is in the head's way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace voluta::planar {

struct PieceOrder {
  std::vector<std::size_t> order;      // of indices
  std::vector<std::vector<int>> under; // of each piece those it stands on, by index
  std::size_t blocked = 0;             // pieces that come after what keeps the head off them
  std::vector<std::pair<std::size_t, std::size_t>> late; // those, and what comes before them
};

// `standsOnTag[i]`: the tag that piece i stands on; `holds[i]`: the tags of its other sections,
// sorted; inTheWay(i, j): j, printed before, would keep the head off i. The plate comes first.
PieceOrder orderOf(const std::vector<std::int32_t>& standsOnTag,
                   const std::vector<std::vector<std::int32_t>>& holds,
                   const std::function<bool(std::size_t i, std::size_t j)>& inTheWay);

} // namespace voluta::planar
