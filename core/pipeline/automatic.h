// Mode auto: tries ways of building in order and picks the first one without blocking findings and
// without long unsupported beads.
#pragma once

#include "base/text.h"
#include "project/choices.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// One candidate of mode auto: a mode, a platform and parameter values that apply unless the user
// has changed them.
struct AutomaticStrategy {
  std::string_view id; // Saved in projects: must not change when ways are inserted
  std::string_view mode, platform;
  base::Text name, nameWithSupports; // Shown to the user
  std::map<std::string, std::string> parameters = {};
  // Layer height a quarter of the way from the process's minimum to its usual height
  bool lowLayers = false;
};

// The way that is tried first, and only, on parts that need no supports in flat layers
// (placement/terraced.h).
inline constexpr std::string_view kTerraced = "terraced";

// Returns the ways in the order in which they are tried: first those without supports, then curved
// layers with thin support columns where growth would lose voxels, then flat layers with supports
// as on an ordinary printer, then the same in lower layers, which cover thin and slanted regions
// better, then curved layers on a pedestal made for the part. The last one is kTerraced.
const std::vector<AutomaticStrategy>& automaticStrategies();

// Returns `choices` once per applicable way, with that way's mode and platform. A way applies if it
// suits the cell (level layers only, if the cell cannot tilt the nozzle) and, if
// choices.platformStays, the chosen platform. Falls back to the modes for rods and bodies. Throws
// Error{Usage} if no way applies.
std::vector<project::Choices> automaticChoices(const project::Choices& choices);

// Returns whether the choices are automatic and name a way that has their mode and platform, as
// those of an earlier plan do.
bool namesStrategy(const project::Choices& choices);

// Returns automatic choices with the way that they name, if it has their mode and platform, else
// with the first way that would be tried. Returns other choices unchanged. Throws as
// automaticChoices().
project::Choices strategyOrFirst(const project::Choices& choices);

// Returns the manual choices that are equivalent to automatic choices with the mode of one of the
// ways: the way's parameters are filled in. Returns other choices unchanged.
project::Choices resolved(project::Choices choices);

// Returns the parameters that resolved() would set if the user had changed none. Empty for manual
// choices.
std::map<std::string, std::string> parametersOfStrategy(project::Choices choices);

// Returns the name of the way, e.g. "flat layers with supports"; for manual choices the mode's
// label.
base::Message nameOfStrategy(const project::Choices& choices);

} // namespace voluta::pipeline
