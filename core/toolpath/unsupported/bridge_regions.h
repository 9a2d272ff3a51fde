// The parts of a plane layer that bridge gaps of the layer below.
#pragma once

#include "geometry/polygon_paths.h"
#include "process/process.h"

#include <vector>

namespace voluta::toolpath {

// A part of a layer whose lines run from hold to hold.
struct BridgeRegion {
  ClipperLib::Paths area;    // with its overlap onto the holds
  double directionRad = 0.0; // of its lines, from x towards y
  double longestMm = 0.0;    // its longest span
};

// [hatches] by which a bridge overlaps its holds: its lines turn there.
inline constexpr double kBridgeOverlap = 2.0;

// Returns the parts of `air`, with their corners, that are so wide that usual lines do not cross
// them.
ClipperLib::Paths wideGaps(const ClipperLib::Paths& air, const process::Process& process);

// Returns the bridges in `inside`, the area that infill fills, over the gaps of `below`, the
// material that the layer rests on. A gap is at least one and a half beads wide; gaps closer than
// twice the overlap are one. Its direction leaves least of the length of its lines without a hold
// at both ends; of equally good ones that in which its longest span is shortest. Where its lines
// have a hold at one end only, as on an overhang, it is no bridge. Regions do not overlap.
std::vector<BridgeRegion> bridgeRegions(const ClipperLib::Paths& inside,
                                        const ClipperLib::Paths& below,
                                        const process::Process& process);

} // namespace voluta::toolpath
