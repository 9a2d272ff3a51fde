// How a material is laid: nozzle, head, bead limits, speeds (resources/processes/*.json).
#pragma once

#include "process/material.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::process {

// The head as a body of revolution about the nozzle's axis: frusta between consecutive sections.
// z runs from the tip (0) up into the head, against the direction of extrusion. mm.
struct HeadSection {
  double zMm = 0.0, radiusMm = 0.0;
};
struct HeadShape {
  std::vector<HeadSection> sections; // z strictly increasing, or equal for a step; first z = 0
};
// The head shrunk by `toleranceMm`: radii less by it (not below 0), raised by it. What planner and
// replay both call a collision is this solid meeting printed material.
HeadShape erodedHead(const HeadShape& head, double toleranceMm);

struct Process {
  std::string id, label;
  double nozzleDiameterMm = 1.0;
  double layerHeightMm = 0.8, layerHeightMinMm = 0.4, layerHeightMaxMm = 1.0;
  double beadWidthMm = 1.2, beadWidthMinMm = 1.0, beadWidthMaxMm = 2.0;
  double stepMm = 1.0; // distance of waypoints along a path
  double speedMmPerS = 20.0, travelSpeedMmPerS = 100.0;
  double accelerationMmPerS2 = 500.0;
  double contactToleranceMm = 0.4; // the head may be this deep in soft, rounded beads: contact,
                                   // not collision
  double bridgeMm = 6.0;           // a bead spans so much with nothing beneath it
  double bridgeSpeedMmPerS = 10.0; // at most, where it does
  double maxFlowMm3PerS = 40.0;    // flow at the analogue output's full scale
  double primeS = 0.2;             // extruder runs this long before a path moves
  double retractMm = 0.0;          // of filament, drawn back for a travel; 0: stays as it is
  Material material;               // with the density that the process's file gives, if any
  HeadShape head;
};

// Throws Error{UnreadableFile}: not there or not JSON; Error{UnusableInput} naming file and key: a
// key that is missing or unknown, a size, speed or density that is not positive, limits that do not
// enclose their default, a head that does not rise from z = 0.
Process readProcess(const std::filesystem::path& file);
// The same from the file's text; `name` names it in errors.
Process readProcessText(const std::string& text, const std::string& name);
// Ids of the processes in resourceFolder()/processes, sorted.
std::vector<std::string> processIds();
// `choice`: an id, or the text of a process's file (base/data_files.h). Throws Error{Usage} for an
// unknown id, naming the nearest; as readProcess() for a text.
Process loadProcess(const std::string& choice);

} // namespace voluta::process
