// Sections as the polygons of Clipper, and back.
#pragma once

#include "planar/plane.h"
#include "planar/slicing/section.h"

#include <polyclipping/clipper.hpp>

namespace voluta::planar {

inline constexpr double kPathUnits = 1e4; // of the polygons' integers, a mm
inline constexpr double kCleanMm = 0.02;  // details that polygons may lose at each step

// Without details and what has no area.
ClipperLib::Paths cleaned(ClipperLib::Paths paths);

// The loops of a section in a frame of its plane, as they run.
ClipperLib::Paths loopsOf(const Section& section, const PlaneFrame& frame);
Section sectionOf(const ClipperLib::Paths& paths, const Plane& plane, const PlaneFrame& frame);

// A section whose edges cross each other, by its winding, as slicers fill it: what loops go round
// is inside however often they do. Its edges cross nowhere.
Section filledByWinding(const Section& section);

} // namespace voluta::planar
