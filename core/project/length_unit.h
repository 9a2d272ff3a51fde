// What a length of 1 in a mesh's file may be: one row a unit. STL, OBJ and PLY do not say.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace voluta::project {

struct LengthUnit {
  std::string_view word; // "mm"
  double mm = 1.0;
};

std::span<const LengthUnit> lengthUnits();
// Throws Error{Usage} naming all.
const LengthUnit& lengthUnit(const std::string& word);

} // namespace voluta::project
