// Figures that stages measure and that a plan's report states (docs/design.md, Report).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace voluta::plan {

// Of one region of a part.
struct RegionStatistics {
  std::string region, use;
  std::size_t patches = 0;
  double volumeMm3 = 0.0; // of its layers
  // Steps on the part's surface in the region, as in LayerStatistics.
  double stepMeanMm = 0.0, stepMaxMm = 0.0;
};

// Of layers. Area-weighted, so that areaMm2 * thicknessMeanMm is the volume. Without supports,
// unless noted.
struct LayerStatistics {
  int count = 0; // layers, including those that only contain supports
  std::size_t patches = 0;
  double areaMm2 = 0.0;
  double thicknessMeanMm = 0.0, thicknessStdMm = 0.0, thicknessP01Mm = 0.0, thicknessP99Mm = 0.0;
  double withinLimitsFraction = 0.0; // share of the area whose thickness is within the limits
  // Height of the steps between the layers' edges and the part's surface: mean over the whole
  // surface, which has none where it follows a layer, and the greatest
  double stepMeanMm = 0.0, stepMaxMm = 0.0;
  std::vector<RegionStatistics> regions; // as the item's

  double volumeMm3() const { return areaMm2 * thicknessMeanMm; }
};

// Of the tool-paths of one item among several.
struct ItemToolpaths {
  std::size_t paths = 0;
  double lengthMm = 0.0, materialMm3 = 0.0;
};

// Of the printed part under a load in one direction; all 0 without a load. Sections are
// perpendicular to the load; their interface share is the share of their area that interfaces of
// layers carry, seen along the load: 1 if layers are stacked along the load, 0 if they run along
// it. The ends of the part, a tenth of its length each, have no sections.
struct StrengthStatistics {
  double angleMeanDeg = 0.0;      // Between beads and load, by volume
  double alignedFraction = 0.0;   // Share of the beads' volume within 30 degrees of the load
  double interfaceMm2 = 0.0;      // Area of all interfaces of layers, seen along the load
  double interfaceFraction = 0.0; // Mean interface share of the sections, by area
  // The smallest section, the one with the greatest interface share, and their places: distance
  // from the part's end along the load
  double minSectionMm2 = 0.0, minSectionAtMm = 0.0;
  double maxInterfaceFraction = 0.0, maxInterfaceAtMm = 0.0;
};

// Of the printed part between its holds and loads (docs/algorithms/loads.md); all 0 without any.
struct LoadStatistics {
  double forceN = 0.0;       // sum of the forces; NaN in the others: unknown
  double angleMeanDeg = 0.0; // between beads and the strongest principal stress, by length
  // Share of the length within 30 degrees of it: of all beads, and of those inside walls
  double alignedFraction = 0.0, infillAlignedFraction = 0.0;
  // Of the deposited beads, for which the material's elasticity is needed
  double stiffnessNPerMm = 0.0; // force by the displacement of its places along it
  // Tension that the bonds carry, exceeded in a hundredth of the volume: between beads of a layer,
  // and between layers [MPa]
  double acrossBeadsMPa = 0.0, acrossLayersMPa = 0.0;
};

// Of tool-paths.
struct ToolpathStatistics {
  std::size_t paths = 0, waypoints = 0;
  // of beads; straight-line distances between consecutive paths
  double lengthMm = 0.0, travelMm = 0.0;
  std::size_t starts = 0;                              // extruder starts, one per path
  std::size_t simpleRegions = 0;                       // patches with one boundary loop
  double coveredFraction = 0.0, overlapFraction = 0.0; // of the patches' area
  std::size_t gouges = 0;
  double maxRotationDeg = 0.0, materialMm3 = 0.0;
  double rimSupportMm3 = 0.0;  // of support beads under low rims, included in materialMm3
  double layerVolumeMm3 = 0.0; // area x thickness of all solid parts of patches
  // Of the parts that sparse infill fills: area x thickness, and its beads. The target of
  // materialMm3 is the sum of layerVolumeMm3 and sparseBeadMm3.
  double sparseMm3 = 0.0, sparseBeadMm3 = 0.0;
  // Tapes of continuous fibre: their number, length and mass.
  std::size_t tapes = 0;
  double tapeMm = 0.0, tapeG = 0.0;
  // Shares of the region that tapes can cover in the chosen layers: covered, and covered twice.
  double tapeCoveredFraction = 0.0, tapeOverlapFraction = 0.0;
  double tapeBareMm = 0.0; // length of tape that no plastic covers
  // Shots into pockets: their number and volume, included in materialMm3.
  std::size_t shots = 0;
  double shotMm3 = 0.0;
  std::vector<ItemToolpaths> items; // empty: the job has one item
  StrengthStatistics strength;
  LoadStatistics load;
};

// Of a motion.
struct MotionStatistics {
  std::size_t waypoints = 0;   // Printed
  std::size_t unreachable = 0; // Waypoints left out: out of reach, or connected to no neighbour
  // Waypoints left out because of collisions, and points of the finished trajectory that collide
  // (always none)
  std::size_t collisions = 0;
  std::size_t splits = 0; // Printed pieces in excess of the number of paths
  std::size_t transfers = 0, arcTransfers = 0, jointTransfers = 0, treeTransfers = 0;
  std::vector<double> maxJerk; // Per joint while printing [rad/s3] ([mm/s3])
  // Before: with the rotations chosen by the ladder, over the same times.
  double sumSquaredJerk = 0.0, sumSquaredJerkBefore = 0.0;
  std::vector<double> maxJerkBefore; // Per joint, likewise
  std::vector<double> maxJerkAtS;    // Per joint: time of maxJerk
  // Per joint in transfers: at least that of the smoothest motion from rest to rest in that time
  std::vector<double> maxTravelJerk, maxTravelJerkAtS;
  double jerkSlowedS = 0.0; // By which the limit of the jerk makes the motion longer
  // Between bodies and part, without the head's clearance to plate and part; at most
  // motion::kClearanceCapMm
  double minClearanceMm = 0.0;
  double minClearanceAtS = 0.0; // Time of that clearance
  // Share of the plan's material; includes all waypoints that are not printed
  double leftOutFraction = 0.0;
  double durationS = 0.0; // Waits included
  std::size_t toolChanges = 0;
  std::size_t waits = 0; // For beads to cool
  double waitS = 0.0;
};

} // namespace voluta::plan
