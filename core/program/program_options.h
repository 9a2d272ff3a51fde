// What a user may choose about the text of programs.
#pragma once

#include "base/parameters.h"

#include <cstddef>

namespace voluta::program {

struct ProgramOptions {
  // A program of more motions is cut into files to be run one after the other, each cut where the
  // extruder is off if there is such a place (URScript, RAPID, MELFA-BASIC; the other formats are
  // streamed and stay one file). 0: as the dialect has it.
  std::size_t motionsPerFile = 0;
  // URScript: `end` is the last line, as ports 30001 and 30002 take it; else the function is called
  // behind it, as a file node of PolyScope needs it.
  bool urscriptForPort = false;
  // RAPID: modules are .modx (RobotWare 7, OmniCore), else .mod.
  bool rapidModx = false;
  // KRL: what the controller has room for; the head of a longer program says so.
  double krlMemoryMb = 4.0;
};

base::ParameterTable programParameters();
// Throws nothing when `values` are over a table with programParameters().
ProgramOptions programOptions(const base::ParameterValues& values);

} // namespace voluta::program
