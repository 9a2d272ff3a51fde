// Paint of slicers on the triangles of a 3MF model: supports, seams and colours. PrusaSlicer,
// OrcaSlicer and Bambu Studio write it as an attribute of a triangle, which codes how the triangle
// is divided and which state each piece has.
#pragma once

#include "base/text.h"
#include "geometry/formats/facet_soup.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::geometry {

// A kind of paint on triangles of an object.
struct ThreemfPaint {
  std::size_t triangles = 0;
  long long line = 0;                                          // of the first one
  std::vector<std::pair<std::size_t, std::string>> codes = {}; // index of the triangle, its code
};

// Returns the word for paint in that attribute of triangles; empty if it is none.
base::Text paintWord(std::string_view attribute);
// Returns the setting of a region that the paint in that attribute is: "paint_supports" and
// "paint_seam" with states 1 (enforcer) and 2 (blocker), "paint_color" with the extruder from 1;
// empty if it is none.
std::string_view paintSetting(std::string_view attribute);

struct PaintedFacet {
  int state = 0; // from 1
  Facet facet;
};
// Returns the painted pieces of a triangle. A code is hexadecimal and read from its end. Each digit
// is a piece: its two low bits count the sides that are divided, the high ones are the state, or
// the side from which the corners of a divided piece are counted, whose pieces follow, the last one
// first. State 3 and more: digits that follow, less 3, each 15 with another behind it. Returns
// nullopt if a code is damaged.
std::optional<std::vector<PaintedFacet>> paintedFacets(std::string_view code, const Facet& facet);

} // namespace voluta::geometry
