// The beads of a slicer's G-code file, as its firmware would extrude them.
#pragma once

#include "base/text.h"
#include "plan/tool_plan.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace voluta::sliced {

struct SlicedPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   // [mm]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); // from the bead into the nozzle
  // On the way to this point: filament of the first tool's section [mm], or [mm3] if volumetric
  double extruded = 0.0;
  double speedMmPerS = 0.0; // On the way to this point
  double heightMm = 0.0;    // Of that bead, by a comment; 0: not given
  std::uint32_t line = 0;   // Of the motion to this point
};

// Material that leaves a nozzle in a line of the file, in the unit of SlicedPoint::extruded.
struct AmountAt {
  std::size_t line = 0;
  double amount = 0.0;
};

// Points that are joined by extrusion without a travel between them; at least two.
struct SlicedPath {
  std::vector<SlicedPoint> points;
  // By a comment; nullopt: the file has no comment about it.
  std::optional<plan::PathKind> kind;
  bool ofPart = true;     // false: a wipe tower
  bool outermost = false; // An outer wall, by a comment
  int layer = -1;         // Counted by comments from 0; -1: none yet
  int tool = 0;           // Number of the last T word
  std::size_t line = 0;
};

// A command at which the printer waits for its user.
struct SlicedStop {
  std::size_t line = 0;
  std::string text;    // for the operator
  std::string command; // as written, shortened
};

// What comments state anywhere in the file; 0: nothing.
struct SlicedHeader {
  double filamentMm = 0.0;         // Diameter, of the first tool
  std::string oddDiameters;        // A statement with a diameter that cannot be used
  std::vector<double> filamentsMm; // Diameters by tool; empty: all as the first
  bool volumetric = false;         // Amounts are volumes, by a setting
  bool ultiGcode = false;          // They are, by the language
  bool oneNozzle = false;          // All tools' filaments go to one nozzle
  double layerHeightMm = 0.0, firstLayerHeightMm = 0.0;
  bool hasLayers = false, hasKinds = false;
  std::string slicer; // Its name

  // Returns the section of a tool's filament as a share of the first tool's; 1 for volumes.
  double amountShare(int tool, bool isVolume) const;
};

// Returns the number of a T word; nullopt for larger numbers, which are commands of firmwares, such
// as T255.
std::optional<int> toolNumber(double number);

struct SlicedFile {
  SlicedHeader header;
  std::vector<SlicedPath> paths;
  bool volumetric = false; // Amounts are volumes
  // Amounts outside of paths, in the file's unit: pushed at rest; before the first layer; by the
  // printer's own code behind beads; as purge lines beside the part
  double atRest = 0.0, inStartCode = 0.0, inOwnCode = 0.0, purged = 0.0;
  std::size_t restLine = 0, ownLine = 0, purgeLine = 0; // The first line of each; 0: none
  std::vector<AmountAt> outside; // Line by line, the amounts outside of paths
  std::map<int, int> nozzleC;    // By tool: the temperature at which most material is printed [°C]
  int bedC = 0;                  // The highest that is set [°C]; 0: none
  std::size_t cutLine = 0; // The last line, if the file seems to be cut within it; 0: it is not
  std::vector<SlicedStop> stops;     // In order; a path ends at each
  std::vector<base::Message> unused; // Commands that are not acted on, a sentence each
};

} // namespace voluta::sliced
