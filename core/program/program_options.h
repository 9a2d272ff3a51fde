// What a user may choose about the text of programs.
#pragma once

#include "base/parameters.h"

#include <cstddef>

namespace voluta::program {

struct ProgramOptions {
  // A program of more motions is cut into files to be run one after the other, each cut where the
  // extruder is off if there is such a place (URScript, RAPID; the other formats are streamed and
  // stay one file). 0: as the dialect has it.
  std::size_t motionsPerFile = 0;
  // URScript: `end` is the last line, as ports 30001 and 30002 take it; else the function is called
  // behind it, as a file node of PolyScope needs it.
  bool urscriptForPort = false;
  // RAPID: modules are .modx (RobotWare 7, OmniCore), else .mod.
  bool rapidModx = false;
  // G-code with B and C: the plate's centre as seen from the tilt axis, mm (tilting_table.h), and
  // whether the table's angles count the tool's turn instead of the part's.
  double tableXMm = 0.0, tableZMm = 0.0;
  bool tableReversed = false;
};

base::ParameterTable programParameters();
// Throws nothing when `values` are over a table with programParameters().
ProgramOptions programOptions(const base::ParameterValues& values);

} // namespace voluta::program
