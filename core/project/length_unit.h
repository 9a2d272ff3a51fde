// Units of length for mesh files, one row per unit; STL, OBJ and PLY do not state their unit.
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
// Throws Error{Usage} that names all units.
const LengthUnit& lengthUnit(const std::string& word);

} // namespace voluta::project
