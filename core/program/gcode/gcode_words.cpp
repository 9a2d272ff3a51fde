#include "program/gcode/gcode_reader.h"

#include <array>

namespace voluta::program {

// RepRap G-code dictionary (reprap.org/wiki/G-code). The reader itself handles M84 and M18, heat
// and tool.
std::span<const KnownWord> gcodeWords() {
  static constexpr std::array kTable = {
      KnownWord{"G17", kAnywhere, "plane of arcs: X and Y"},
      KnownWord{"G21", kAnywhere, "millimetres"},
      KnownWord{"G28", kSetUp, "drives home"},
      KnownWord{"G40", kAnywhere, "no tool compensation"},
      KnownWord{"G49", kAnywhere, "no tool compensation"},
      KnownWord{"G80", kAnywhere, "no cycle"},
      KnownWord{"G90", kAnywhere, "absolute positions"},
      KnownWord{"G94", kAnywhere, "speeds a minute"},
      KnownWord{"M0", kAtRest, "waits for the operator"},
      KnownWord{"M1", kOutsidePrint, "waits for the operator"},
      KnownWord{"M17", kSetUp, "motors on"},
      KnownWord{"M18", kAtEnd, "motors off"},
      KnownWord{"M84", kAtEnd, "motors off"},
      KnownWord{"M105", kAnywhere, "asks for temperatures"},
      KnownWord{"M106", kAnywhere, "fan"},
      KnownWord{"M107", kAnywhere, "fan off"},
      KnownWord{"M110", kAnywhere, "line numbers"},
      KnownWord{"M111", kAnywhere, "messages"},
      KnownWord{"M114", kAnywhere, "asks for the position"},
      KnownWord{"M115", kAnywhere, "asks for the firmware"},
      KnownWord{"M117", kAnywhere, "a message"},
      KnownWord{"M118", kAnywhere, "a message"},
      KnownWord{"M140", kOutsidePrint, "heat of the bed"},
      KnownWord{"M190", kOutsidePrint, "heat of the bed"},
      KnownWord{"M73", kAnywhere, "progress"},
      KnownWord{"M400", kAnywhere, "waits until all motion is done"},
  };
  return kTable;
}

// Words that PrusaSlicer, OrcaSlicer and Cura write into programs for printers, with Marlin's
// meanings (marlinfw.org/meta/gcode). Limits and ramps change times, not the path.
std::span<const KnownWord> slicerWords() {
  static constexpr std::array kTable = {
      KnownWord{"G29", kSetUp, "measures the bed"},
      KnownWord{"M75", kAnywhere, "timer"},
      KnownWord{"M76", kAnywhere, "timer"},
      KnownWord{"M77", kAnywhere, "timer"},
      KnownWord{"M141", kOutsidePrint, "heat of the chamber"},
      KnownWord{"M191", kOutsidePrint, "heat of the chamber"},
      KnownWord{"M201", kAnywhere, "acceleration limits"},
      KnownWord{"M203", kAnywhere, "speed limits"},
      KnownWord{"M204", kAnywhere, "acceleration"},
      KnownWord{"M205", kAnywhere, "jerk"},
      KnownWord{"M420", kSetUp, "the bed as measured"},
      KnownWord{"M900", kAnywhere, "pressure ahead of speed"},
  };
  return kTable;
}

} // namespace voluta::program
