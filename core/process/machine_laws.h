// The optional laws of a process's machine in its file: lags of the extruder, overlap of beads,
// statements where beads start and end.
#pragma once

#include <string>
#include <vector>

namespace voluta::base {
class JsonNode;
}

namespace voluta::process {

// Delays of an extruder, such as one with a screw [s]. Programs switch it on so long before a bead
// moves, and off so long before its end.
struct ExtruderLag {
  double startS = 0.0, stopS = 0.0;

  bool operator==(const ExtruderLag&) const = default;
};

// Statements of one program format, copied to programs line by line where a bead starts and ends,
// e.g. those that strike and end an arc.
struct BeadWords {
  std::string format; // Id in the dialect registry
  std::vector<std::string> start, end;
  // Press with a force ({press...}): beads are also laid without, by position alone
  bool isForce = false;

  bool operator==(const BeadWords&) const = default;
};

struct MachineLaws {
  ExtruderLag lag;
  double overlapFactor = 1.0;
  std::vector<BeadWords> beadWords;
};

// Reads the keys startLagS, stopLagS, overlapFactor and beadWords. Throws Error{UnusableInput} for
// a negative lag or one above 10 s, a factor outside [0.5, 1], a format that has its statements
// twice or none, and a statement that is empty or has several lines.
MachineLaws readMachineLaws(const base::JsonNode& top);

} // namespace voluta::process
