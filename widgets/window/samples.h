// Parts that come with the program: the rows of the menu File > Samples.
#pragma once

#include "project/choices.h"

#include <QString>
#include <map>
#include <string>
#include <vector>

namespace voluta::window {

struct Sample {
  const char* id;           // of the command
  const char *text, *tip;   // source texts of the context "Commands"
  const char* part;         // "sample:NAME", or a file of the resource folder
  const char* body = "";    // the sample that it is printed on; empty: the plate of the cell
  const char* process = ""; // and the cell: those that the sample is made for; empty: any
  const char* cell = "";
  std::map<std::string, std::string> parameters = {};

  // Returns the path or name under which the part is opened.
  QString path() const;
  // Returns the choices with those that the sample requires.
  project::Choices required(project::Choices choices) const;
};

const std::vector<Sample>& samples();

} // namespace voluta::window
