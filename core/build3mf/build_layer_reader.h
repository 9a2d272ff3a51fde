// One layer part: segments of points (Part II).
#pragma once

#include "build3mf/build_profiles.h"
#include "build3mf/build_reader.h"

#include <string>
#include <string_view>

namespace voluta::build3mf {

// What points say: x and y, of a layer at its own height; z too; the tool's frame besides.
enum class PathAxes { Planar, Three, Six };

// What layer parts are read with.
struct LayerFrame {
  const Profiles& profiles;
  double unitMm = 1.0; // a unit of coordinates
  PathAxes axes = PathAxes::Six;
  int layer = 0; // of paths that say none themselves
  // Planar: where the nozzle goes, and how thick beads are that say nothing of it.
  double topMm = 0.0, thicknessMm = 0.0;
};

// Appends the segments of the layer part `text` to `into`. Throws Error{UnreadableFile,
// UnusableInput} as readBuild does; `where` names the part.
void readLayer(std::string_view text, const std::string& where, const LayerFrame& frame,
               ReadBuild& into);

} // namespace voluta::build3mf
