// Walls: beads along the boundary of a region.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// [hatches] that a region has to extend inwards of a wall.
inline constexpr double kWallInwards = 0.4;

// Returns by how many hatches the region of the wall at `level` is closed.
double wallClosing(double level);

// Where `value`, per vertex, is at least `level`; without values: nowhere.
struct LevelSet {
  std::vector<double> value;
  double level = 0.0;
};
// Returns the region that the walls of wallAt() enclose, with `inwards` for kWallInwards.
LevelSet openedAt(const PatchSurface& surface, const std::vector<double>& depth,
                  const std::vector<double>& hatchMm, double beadScale, double level,
                  double inwards);
// Returns the walls around such a region, without rings that are no more than a blob.
std::vector<SurfaceCurve> wallsAround(const PatchSurface& surface, const LevelSet& region,
                                      double beadScale);

// Returns the centrelines at `level` hatches from the boundary, where the region extends at least
// kWallInwards further inwards. Elsewhere two such curves from opposite sides would nearly meet,
// and one bead on the medial line is better (gap_fill.h). This is the morphological opening of the
// offset region: corners are rounded by as much, and narrow parts vanish without open ends.
// depth: per vertex, distance from the boundary in hatches; hatchMm per vertex. beadScale as in
// bead_scale.h.
std::vector<SurfaceCurve> wallAt(const PatchSurface& surface, const std::vector<double>& depth,
                                 const std::vector<double>& hatchMm, double beadScale,
                                 double level);

// Removes outermost walls that are mere rings in a junction of thin walls: a bead along one of the
// thin walls passes through it. A pin, which no thin wall joins, keeps its ring. depth: per vertex,
// distance from the boundary in hatches.
void dropJunctionRings(const PatchSurface& surface, const std::vector<double>& depth,
                       double hatchMm, std::vector<SurfaceCurve>& walls);

// Removes the outermost walls of regions that are hardly wide enough for two beads, where they are
// dashes: one bead fills such a region up to `deepest` hatches from its boundary. depth: per
// vertex, distance from the boundary in hatches.
void dropDashes(const PatchSurface& surface, const std::vector<double>& depth, double deepest,
                std::vector<SurfaceCurve>& walls);

} // namespace voluta::toolpath
