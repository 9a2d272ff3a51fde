// Conversion between sections and Clipper polygons.
#pragma once

#include "geometry/polygon_paths.h"
#include "planar/plane.h"
#include "planar/slicing/section.h"

namespace voluta::planar {

using geometry::kPathUnits;
inline constexpr double kCleanMm = 0.02; // size of details that polygons may lose at each step

// Returns the paths without small details and without paths of no area.
ClipperLib::Paths cleaned(ClipperLib::Paths paths);

// Returns the loops of a section in a frame of its plane, with their orientation.
ClipperLib::Paths loopsOf(const Section& section, const PlaneFrame& frame);
Section sectionOf(const ClipperLib::Paths& paths, const Plane& plane, const PlaneFrame& frame);

// Fills a section with crossing edges by its winding, as slicers do: points enclosed any number of
// times are inside. The returned section has no crossing edges.
Section filledByWinding(const Section& section);

} // namespace voluta::planar
