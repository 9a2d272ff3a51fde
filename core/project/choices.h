// What the user chose for a part.
#pragma once

#include "geometry/placement.h"

#include <map>
#include <string>
#include <vector>

namespace voluta::project {

// What the user chose; together with the mesh it decides every result.
struct Choices {
  std::string mode = "curved";
  std::string growth = "auto";
  std::string platform = "fit:0";
  std::string cell = "ur5-fixed";
  std::string process = "fdm-1.0";
  std::string scale = "1"; // a number or "fit"
  geometry::Placement placement;
  bool repair = true;               // false: the mesh as it was read
  std::vector<std::string> formats; // empty: the cell's controller, gcode-extended, csv
  std::map<std::string, std::string> parameters; // changed ones, as text
  int seed = 1;
};

// A number > 0, or "fit" (returns 0). Throws Error{Usage}.
double parsedScale(const std::string& scale);

} // namespace voluta::project
