// One layer part: segments of points (Part II).
#pragma once

#include "build3mf/build_profiles.h"
#include "build3mf/build_reader.h"

#include <string>
#include <string_view>

namespace voluta::build3mf {

// What layer parts are read with.
struct LayerFrame {
  const Profiles& profiles;
  double unitMm = 1.0; // a unit of coordinates
  bool sixAxes = true; // else three
  int layer = 0;       // of paths that say none themselves
};

// Appends the segments of the layer part `text` to `into`. Throws Error{UnreadableFile,
// UnusableInput} as readBuild does; `where` names the part.
void readLayer(std::string_view text, const std::string& where, const LayerFrame& frame,
               ReadBuild& into);

} // namespace voluta::build3mf
