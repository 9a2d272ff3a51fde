// What the user chose for a part.
#pragma once

#include "curved/growth_scheme.h"
#include "geometry/placement.h"
#include "project/platform.h"

#include <map>
#include <string>
#include <vector>

namespace voluta::project {

// What the user chose; together with the mesh it decides every result.
struct Choices {
  // The way of building is looked for when it is planned; mode and platform are then those that
  // were taken last. What else is chosen stays.
  bool automatic = false;
  bool platformStays = false; // with automatic: the platform is the user's
  std::string automaticWay;   // with automatic: which way was taken last (pipeline/automatic.h)
  std::string mode = "curved";
  curved::GrowthScheme growth;
  Platform platform;
  std::string cell = "ur5-fixed";
  std::string process = "fdm-1.0";
  std::string scale = "1";  // a number or "fit"
  std::string units = "mm"; // of a mesh's file: length_unit.h
  geometry::Placement placement;
  bool repair = true;                            // false: the mesh as it was read
  std::vector<std::string> formats;              // empty: the cell's controller, gcode-extended
  std::map<std::string, std::string> parameters; // changed ones, as text
  int seed = 1;
};

// A number > 0, or "fit" (returns 0). Throws Error{Usage}.
double parsedScale(const std::string& scale);

} // namespace voluta::project
