// User options of the tool-paths.
#pragma once

#include "base/parameters.h"
#include "platform/platform_solid.h"

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::toolpath {

// Returns the dyad of a direction at a place in the work frame [mm], times its weight: the sign of
// directions does not matter.
using StrandDyads = std::function<Eigen::Matrix3d(const Eigen::Vector3d&)>;

// How beads get the time to cool before others cover them.
struct CoolingOptions {
  double minLayerTimeS = 0.0; // plan::LayerTimes
  double slowestMmPerS = 0.0; // beads are printed slower for it, down to this; 0: never
};

// Which layers get tapes of continuous fibre, and along which paths.
struct FibreOptions {
  int everyLayers = 0;             // after every n-th layer but the last; 0: none
  int firstLayer = 1;              // from this layer on, counted from 1
  int maxPerLayer = 0;             // the longest ones in the middle; 0: as many as fit
  std::string paths = "direction"; // id in tapeKinds()
  double angleDeg = 0.0;           // direction, from x towards y
  double rotationDeg = 0.0;        // rotation per layer with tapes
  double endMm = 0.0;              // least distance of the ends of tapes from the outline
  std::string curves = {};         // points of the paths `curves`
  std::string field = {};          // samples of the paths `field`
};

// How the pockets of a part are filled.
struct StitchOptions {
  double excess = 0.15; // volume beyond the pocket's, as a share of it (Castelli 6.3.1)
  double depthMm = 0.0; // of the nozzle below the pocket's top
};

// Id of the infill along a field.
inline constexpr std::string_view kFieldInfill = "field";

struct ToolpathOptions {
  int walls = 2;                 // beads along the boundary of each patch
  std::string infill = "zigzag"; // id in infillKinds()
  // Share of the interior that is filled, [0, 1]; 1: solid. Below 1, sparsePattern fills it, an id
  // in sparsePatterns().
  double infillDensity = 1.0;
  std::string sparsePattern = "gyroid";
  // Of the infill along a field: its directions as text (strand_text.h), and as a function; without
  // a text, the principal stresses of the part's loads. Neither is part of the other's key.
  std::string infillField = {};
  StrandDyads strands = {};
  // Solid layers above and below the interior, at least skinMm thick.
  int topLayers = 3, bottomLayers = 3;
  double skinMm = 0.0;
  // Walls narrower than the narrowest bead: "bead" prints them with that bead, "omit" leaves them
  // out.
  std::string thinWalls = "bead";
  // Direction of straight lines on the first layer, from x to y, and their rotation per layer.
  double infillAngleDeg = 135.0, infillRotationDeg = 90.0;
  double windingAngleDeg = 45.0; // of helical infill: 0 around the axis, 90 along it
  double stepMm = 1.0;           // maximum spacing of waypoints
  double edgeMm = 0.6;           // patches are refined to edges of this length for planning
  double maxBendDeg = 5.0;       // steps with a larger change of direction are subdivided
  double smoothBeyondDeg = 10.0; // Dai 3.5.2
  bool rimSupports = true;       // support beads under low rims (rim_supports.h)
  std::string prime = "none";    // line, skirt or none (prime_path.h)
  double primeLengthMm = 30.0;
  double brimWidthMm = 0.0;     // 0: none (brim.h)
  std::string seam = "nearest"; // id in seamKinds()
  // Of a region: whether closed beads begin there ("always", "never", or else "auto").
  std::string seamHere = "auto";
  double speedFactor = 1.0; // of all beads but supports and waste
  bool orderIslands = true; // short travel between islands of one flat layer (islands.h)
  bool spiral = false;      // one bead with rising height (spiral.h)
  bool spiralOuter = false; // of the outer contour of each layer alone
  // Cell and programs can state nozzle directions other than the plate's normal. Otherwise beads
  // keep the directions of their layers, and supports under rims are printed upright.
  bool canTilt = true;
  // Skins may sag a little between lines of sparse infill (process::saggingBridgeMm).
  bool bridgesMaySag = false;
  CoolingOptions cooling;
  FibreOptions fibre;
  StitchOptions stitches;
  // Index in the job's tooling of the tool that fills the interior within walls and skins;
  // negative: the tool of the patch. That interior is `walls` beads and `topLayers`, `bottomLayers`
  // inside.
  int infillTool = -1;
  // Bodies and rods that exist before the part, work frame; a plate is the cell's.
  platform::PlatformSolid platform;
};

// Returns the parameters walls, infill, infillDensity, sparsePattern, topLayers, bottomLayers,
// skinMm, infillAngle, infillRotation, windingAngle, rimSupports, prime, primeLengthMm,
// brimWidthMm, seam, seamHere, speedFactor, islandOrder, thinWalls, spiral, spiralOuter and
// coolingSpeedMmPerS; those of FibreOptions, and stitchExcess and stitchDepth.
base::ParameterTable toolpathParameters();
// Precondition: the table contains the keys above. The other fields keep their defaults; stepMm is
// the process's.
ToolpathOptions toolpathOptions(const base::ParameterValues& values);
// Returns the options as text, for the key of the tool-paths' stage: without the platform, which
// the keys of earlier stages determine.
std::string optionsKey(const ToolpathOptions& options);

} // namespace voluta::toolpath
