// Reads one layer part: segments of points (Part II).
#pragma once

#include "build3mf/build_profiles.h"
#include "build3mf/build_reader.h"

#include <string>
#include <string_view>

namespace voluta::build3mf {

// The coordinates of points: x and y, in a layer with its own height; also z; also the tool's
// frame.
enum class PathAxes { Planar, Three, Six };

// The context for reading layer parts.
struct LayerFrame {
  const Profiles& profiles;
  double unitMm = 1.0; // Size of a coordinate unit
  PathAxes axes = PathAxes::Six;
  int layer = 0; // Of paths without a layer number
  // Planar: height of the nozzle, and thickness of beads that give none.
  double topMm = 0.0, thicknessMm = 0.0;
};

// Appends the segments of the layer part `text` to `into`. Throws Error{UnreadableFile,
// UnusableInput} as readBuild does; `where` names the part.
void readLayer(std::string_view text, const std::string& where, const LayerFrame& frame,
               ReadBuild& into);

} // namespace voluta::build3mf
