// The parts of a plan on the command line, and their places on the plate.
#pragma once

#include "pipeline/plan_result.h"

#include <string>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::cli {

struct PlateOptions {
  std::vector<std::string> parts;   // mesh files, or sample:NAME
  int copies = 1;                   // of each part
  bool asOne = false;               // a file of several parts is one part
  bool noFileRegions = false;       // leave out the regions of the files
  std::string facets;               // of CAD files: "MM" or "MM,DEGREES"; empty: from the bead
  std::vector<std::string> places;  // "NUMBER:X,Y" or "NUMBER:X,Y,TURN" [mm, degrees]
  std::vector<std::string> own;     // "NUMBER:KEY=VALUE": mode, scale or a parameter of one part
  std::vector<std::string> regions; // "[NUMBER:]" and a text of regions::kRegionForm
};

// Returns the request with an item for each copy of each part, numbered from 1 in this order, all
// with the choices of the request's item but for their own ones. The parts of one file keep their
// places (project::placesInFile()) unless there are other parts. Parts without a place are arranged
// (pipeline::withArrangedParts()) unless one has a place. Throws Error{Usage} for a text that does
// not have this form or names no part; as withArrangedParts().
pipeline::PlanRequest withParts(pipeline::PlanRequest request, const PlateOptions& options,
                                const base::RunContext& ctx);

} // namespace voluta::cli
