// Commands of a slicer's file that are not acted on although they change the print, and its stops.
#pragma once

#include "base/text.h"
#include "sliced/gcode_command.h"
#include "sliced/sliced_file.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::sliced {

// Collects them while a file is read.
class UnusedCommands {
public:
  // Takes a command that the machine does not execute; returns whether it is a stop. `hasBeads`: a
  // bead came before it; commands before the first bead prepare a printer, and only stops are kept
  // of them.
  bool take(const GcodeCommand& command, std::size_t line, bool hasBeads);
  // Takes one under that name.
  void takeNamed(const std::string& name, std::size_t line);

  const std::vector<SlicedStop>& stops() const { return stops_; }
  // Returns a sentence for each other command that is used at or before `lastLine`, that of the
  // last bead.
  std::vector<base::Message> notes(std::size_t lastLine) const;

private:
  struct Seen {
    std::size_t count = 0, line = 0; // the first
  };

  std::vector<SlicedStop> stops_;
  std::map<std::string, Seen> others_;
  std::string shown_; // by the line before, on the printer's display
  std::size_t shownIn_ = 0;
};

} // namespace voluta::sliced
