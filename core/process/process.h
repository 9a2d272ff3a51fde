// A process: nozzle, head, bead limits, speeds and material (resources/processes/*.json).
#pragma once

#include "process/features.h"
#include "process/machine_laws.h"
#include "process/material.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::process {

// A section of the head, a body of revolution around the nozzle's axis made of frusta between
// consecutive sections. z points from the tip (0) up into the head, against the direction of
// extrusion [mm].
struct HeadSection {
  double zMm = 0.0, radiusMm = 0.0;
};
struct HeadShape {
  std::vector<HeadSection> sections; // z strictly increasing, or equal for a step; first z = 0
};
// Returns the head shrunk by `toleranceMm`: its radii are reduced (not below 0) and it is raised by
// it. Planner and replay both report a collision if this solid intersects printed material.
HeadShape erodedHead(const HeadShape& head, double toleranceMm);

// A tape of continuous fibre, ironed onto a layer.
struct Tape {
  double widthMm = 5.0, thicknessMm = 0.08;
  double minLengthMm = 20.0;     // Shorter pieces cannot be fed
  double minBendRadiusMm = 30.0; // Bends within the surface that are narrower fold the tape
  double cutAheadMm = 10.0;      // Length between the cutter and the place that is ironed on
  double fibreMPa = 0.0;         // Modulus of the fibres; 0: unknown
  double fibreShare = 0.0;       // Of the tape's volume, [0, 1]

  bool operator==(const Tape&) const = default;
};

struct Process {
  std::string id, label;
  double nozzleDiameterMm = 1.0;
  double layerHeightMm = 0.8, layerHeightMinMm = 0.4, layerHeightMaxMm = 1.0;
  double beadWidthMm = 1.2, beadWidthMinMm = 1.0, beadWidthMaxMm = 2.0;
  double stepMm = 1.0; // Distance of waypoints along a path
  double speedMmPerS = 20.0, travelSpeedMmPerS = 100.0;
  double accelerationMmPerS2 = 500.0;
  // How deep the head may penetrate soft, rounded beads: contact, not collision
  double contactToleranceMm = 0.4;
  double bridgeMm = 6.0;           // Maximum length of an unsupported bridge
  double bridgeSpeedMmPerS = 10.0; // Maximum speed on a bridge
  double maxFlowMm3PerS = 40.0;    // Flow at the analogue output's full scale; see flowLimit()
  double primeS = 0.2;             // The extruder runs this long before a path moves
  double retractMm = 0.0;          // Length of filament, retracted for a travel; 0: none
  Material material;               // With the density that the process's file states, if any
  HeadShape head;
  FeatureTable features;       // Optional in the file
  OverhangSpeed overhangSpeed; // Optional
  // Of a tool that lays tape. The section of its paths is then the tape's: bead width and layer
  // height give a bead of width x thickness, and the speed is that of ironing.
  std::optional<Tape> tape;
  ExtruderLag lag; // Optional
  // Distance of neighbouring beads as a share of the width of a single one; 1: side by side.
  // Optional
  double overlapFactor = 1.0;
  std::vector<BeadWords> beadWords; // Optional
  // Corrections of the machine's sizes, from measured parts (size_correction.h). Optional; flat
  // layers have them
  double scaleX = 1.0, scaleY = 1.0; // Factors of the part's sizes along x and y
  double outlineOffsetMm = 0.0;      // Outlines move outwards by so much
  double holeOffsetMm = 0.0;         // Contours of holes move into the material by so much

  // Returns the statements for a format; nullptr if there are none.
  const BeadWords* wordsFor(std::string_view format) const;
};

// Returns the largest flow that may be planned [mm3/s]: that of the head or, if less, that of the
// material.
double flowLimit(const Process& process);

// Returns the longest span that a bead of that width bridges with a sag of up to 0.2 mm [mm]:
// bridgedMm() of the material, but at least bridgeMm. The second form: of the usual width.
double saggingBridgeMm(const Process& process, double beadWidthMm);
double saggingBridgeMm(const Process& process);
// Returns the flow with which a nozzle at rest primes or purges [mm3/s]: that of a bead of the
// default section at the default speed, limited by flowLimit().
double primeFlow(const Process& process);

// Throws Error{UnreadableFile} if the file is missing or not JSON; Error{UnusableInput} naming file
// and key for a missing or unknown key, a size, speed or density that is not positive, limits that
// do not include their default, or a head that does not rise from z = 0.
Process readProcess(const std::filesystem::path& file);
// The same from the file's text; `name` names it in errors.
Process readProcessText(const std::string& text, const std::string& name);
// Returns the ids of the processes in resourceFolder()/processes, sorted.
std::vector<std::string> processIds();
// `choice`: an id, or the text of a process's file (base/data_files.h). Throws Error{Usage} for an
// unknown id, naming the nearest; for a text as readProcess().
Process loadProcess(const std::string& choice);

} // namespace voluta::process
