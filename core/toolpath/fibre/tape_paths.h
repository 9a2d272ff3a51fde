// Paths of tapes on a patch of a layer (Dai 5.3): continuous fibre, ironed on normal to the
// surface.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "process/process.h"
#include "toolpath/fibre/tape_curves.h"
#include "toolpath/patch_surface.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::toolpath {

struct TapeChoice {
  std::string paths = "direction"; // id in tapeKinds()
  double directionRad = 0.0;       // of the kind `direction`, from x towards y
  int maxCount = 0;                // the longest ones are kept; 0: as many as fit
  double endMm = 0.0;              // least distance of a tape's ends from the outline
  std::vector<std::vector<Eigen::Vector3d>> curves = {}; // of the kind `curves`; work frame [mm]
  std::vector<FieldSample> field = {};                   // of the kind `field`
};

// Tapes on one patch. Their centrelines neither cross nor touch each other, are at least half a
// width inside the patch, as long as the tape demands and bend no more than it allows.
struct TapePaths {
  std::vector<SurfaceCurve> paths; // points at most `stepMm` apart
  // The region that tapes of this kind can cover at all: its area, and of it the area under the
  // tapes and the area under two or more of them [mm2].
  double regionMm2 = 0.0, coveredMm2 = 0.0, overlapMm2 = 0.0;
  // Length left out because it bends too much, and because the pieces are too short [mm].
  double bentMm = 0.0, shortMm = 0.0;
};

// Returns the tapes of the kind that covers most, evenly spaced by their width. Throws Cancelled;
// Error{Usage} for an unknown kind.
// Example: tapePaths(PatchSurface::refine(patch, 1.0), *process.tape, {.maxCount = 1}, 2.0, ctx)
TapePaths tapePaths(const PatchSurface& surface, const process::Tape& tape,
                    const TapeChoice& choice, double stepMm, const base::RunContext& ctx);

// Centrelines of tapes that lie beside each other, one width apart.
struct TapeLine {
  SurfaceCurve curve;
  double offsetMm = 0.0; // distance from the middle of the region
};
using TapeFamily = std::vector<TapeLine>;

struct TapeKind {
  std::string_view id;
  base::Text label;
  // Returns families of centrelines that cover the patch, beyond its boundary if need be. The best
  // one is chosen; together they cover the region that tapes of this kind can cover.
  std::vector<TapeFamily> (*families)(const PatchSurface&, const process::Tape&, const TapeChoice&,
                                      const base::RunContext&);
  bool isInOrder = false; // the first family is the one to choose
  bool mayCross = false;  // lines of a family may meet: later ones give way to earlier ones
};
// Returns all kinds; the first is the default.
std::span<const TapeKind> tapeKinds();
// Throws Error{Usage} for an unknown id, suggesting the nearest.
const TapeKind& tapeKind(std::string_view id);

// Returns the radius of the circle through three points of a curve on a surface with that normal,
// in the surface: that of its geodesic curvature [mm]; infinite if it is straight.
double bendRadius(const Eigen::Vector3d& before, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& after, const Eigen::Vector3d& normal);

} // namespace voluta::toolpath
