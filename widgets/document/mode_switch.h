// Companion choices of a way of building: a rod needs a cell that rotates it, a body its file.
#pragma once

#include "base/parameters.h"
#include "geometry/placement.h"
#include "project/job.h"

#include <QString>
#include <map>
#include <string>
#include <vector>

namespace voluta::document {

// Ways of building use either a plate or a rotating rod. Cell, process, platform and placement of
// the part are remembered for either and restored on switching back.
class ModeSwitch {
public:
  // Returns the choices in that mode: with the present values where they fit, otherwise with those
  // from when the mode's kind was last left, otherwise with its defaults. Precondition: known
  // modes.
  project::Choices switched(const project::Choices& now, const std::string& mode);
  // Returns the choices with way of building and platform left to the plan.
  project::Choices automatic(const project::Choices& now);

private:
  struct Companions {
    std::string cell, process;
    geometry::Placement placement;
  };
  std::map<bool, Companions> companions_;              // by Mode::aroundRod
  std::map<std::string, project::Platform> platforms_; // by mode
};

// Returns the choices with all values replaced that do not fit their mode; unchanged if none. Reads
// cell descriptions.
project::Choices fitting(project::Choices choices);

// Returns choices.formats without those that no job of the chosen cell can be written in: joint
// values of another maker's arm, motions without the cell's external axes. Reads the cell; if that
// fails, returns all of them.
std::vector<std::string> writableFormats(const project::Choices& choices);

// Returns whether the platform is a body that is neither a file that exists nor a sample.
bool bodyIsMissing(const project::Choices& choices);

// Returns the parameters with the defaults of the choices' mode and process and, if the way of
// building is left to the plan, with the values of the last chosen way.
base::ParameterTable parametersFor(const project::Choices& choices);

// Returns a sentence on what prevents planning with these choices, apart from parameters; empty if
// nothing does. Reads descriptions of cell and process.
QString obstacle(const project::Choices& choices);

} // namespace voluta::document
