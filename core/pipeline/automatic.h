// Mode auto: the first way of building that nothing blocks and of which no bead hangs too far.
#pragma once

#include "base/text.h"
#include "project/choices.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// A way that is tried: mode and platform, and parameters unless the user has changed them.
struct AutomaticWay {
  std::string_view id; // kept in projects: stays when ways are put in between
  std::string_view mode, platform;
  base::Text name, nameWithSupports; // what a user reads
  std::map<std::string, std::string> parameters = {};
  bool lowLayers = false; // of a quarter of what the process has between its least and usual height
};

// In the order they are tried: what needs no support first, then curved layers with thin columns
// where growth would lose something, then what an ordinary printer does, once more in lower layers,
// which cover thin and slanted places better; last what needs a pedestal made for the part.
const std::vector<AutomaticWay>& automaticWays();

// Those of them, and of the modes for rods and bodies, that go with the cell (level layers alone
// where it cannot lean the nozzle) and, where it stays, the platform of automatic choices: the
// choices with each way's mode and platform. Throws Error{Usage}: there is none.
std::vector<project::Choices> automaticChoices(const project::Choices& choices);

// Whether automatic choices name a way that has their mode and platform: that of an earlier plan.
bool namesWay(const project::Choices& choices);

// What automatic choices stand for: the way that they name, where they have its mode and platform,
// else the first that would be tried. Others as they are. Throws as automaticChoices().
project::Choices wayOrFirst(const project::Choices& choices);

// As somebody would choose by hand what automatic choices, with the mode of one of the ways, come
// to: with the way's parameters. Others as they are.
project::Choices resolved(project::Choices choices);

// Returns what resolved() would set if the user had changed no parameter. Empty for other choices.
std::map<std::string, std::string> parametersOfWay(project::Choices choices);

// Returns the name of the way, e.g. "flat layers with supports"; for choices by hand, the mode's.
base::Message nameOfWay(const project::Choices& choices);

} // namespace voluta::pipeline
