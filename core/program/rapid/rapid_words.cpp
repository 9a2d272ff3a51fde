#include "program/rapid/rapid.h"

#include <array>

namespace voluta::program {

// Technical reference manual, RAPID Instructions, Functions and Data types. In lower case.
std::span<const KnownWord> rapidWords() {
  static constexpr std::array kTable = {
      KnownWord{"tperase", kAnywhere, "clears the pendant's window"},
      KnownWord{"tpwrite", kAnywhere, "writes to the pendant"},
      KnownWord{"errwrite", kAnywhere, "writes to the log"},
      KnownWord{"clkreset", kAnywhere, "a stop watch"},
      KnownWord{"clkstart", kAnywhere, "a stop watch"},
      KnownWord{"clkstop", kAnywhere, "a stop watch"},
      KnownWord{"uimsgbox", kAtRest, "waits for the operator"},
      KnownWord{"tpreadfk", kAtRest, "waits for the operator"},
      KnownWord{"tpreadnum", kOutsidePrint, "waits for the operator"},
      KnownWord{"stop", kAtRest, "waits for the operator"},
      KnownWord{"waitdi", kOutsidePrint, "waits for an input"},
      KnownWord{"waitdo", kOutsidePrint, "waits for an output"},
      KnownWord{"waituntil", kOutsidePrint, "waits for a condition"},
      KnownWord{"accset", kSetUp, "share of the arm's acceleration"},
      KnownWord{"velset", kSetUp, "share of all speeds"},
      KnownWord{"singarea", kSetUp, "behaviour near singular poses"},
      KnownWord{"motionsup", kSetUp, "collision supervision"},
      KnownWord{"gripload", kSetUp, "payload of the gripper"},
      KnownWord{"setgo", kOutsidePrint, "an output that is not the extruder's"},
      KnownWord{"pulsedo", kOutsidePrint, "an output that is not the extruder's"},
      KnownWord{"exit", kAtEnd, "ends the program"},
  };
  return kTable;
}

} // namespace voluta::program
