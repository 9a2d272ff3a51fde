// The user's choices for a part.
#pragma once

#include "curved/growth_scheme.h"
#include "geometry/placement.h"
#include "project/platform.h"

#include <map>
#include <string>
#include <vector>

namespace voluta::project {

// The user's choices; together with the mesh they determine every result.
struct Choices {
  // True: planning searches for the way of building and sets mode and platform to the chosen way's.
  // All other choices stay.
  bool automatic = false;
  bool platformStays = false; // with automatic: keep the user's platform
  std::string automaticWay;   // with automatic: the way chosen last (pipeline/automatic.h)
  std::string mode = "curved";
  curved::GrowthScheme growth;
  Platform platform;
  std::string cell = "ur5-fixed";
  std::string process = "fdm-1.0";
  std::string scale = "1";  // a number or "fit"
  std::string units = "mm"; // of the mesh's file, see length_unit.h
  geometry::Placement placement;
  bool repair = true;                            // false: use the mesh as read
  std::vector<std::string> formats;              // empty: the cell's controller, gcode-extended
  std::map<std::string, std::string> parameters; // non-default values as text
  int seed = 1;
};

// Returns the number, which is > 0, or 0 for "fit". Throws Error{Usage}.
double parsedScale(const std::string& scale);

} // namespace voluta::project
