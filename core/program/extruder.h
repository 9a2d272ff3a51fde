// What turns the filament, and how a robot's program tells it how much: a row each. A cell says
// which it has; the option `extruder` of a dialect takes another. A new one is a file and a row.
//
// Dialects whose motions say amounts (G-code's E, the joint table) have an extruder of their own
// and none of these.
#pragma once

#include "base/parameters.h"
#include "base/text.h"
#include "program/program_input.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::robot {
class Cell;
}

namespace voluta::program {

struct Extruder {
  std::string_view id;
  base::Text label;
  // Said to it by texts that the program sends (ProgramEmitter::send): the text of a flow, mm3/s, 0
  // stops it. nullptr: it is told by outputs.
  std::string (*text)(double mm3PerS) = nullptr;
  // The flow, mm3/s, that its words say for one that is wanted. nullptr: as the dialect's analogue
  // output has it.
  double (*written)(double mm3PerS) = nullptr;
  // A file beside the program tells the flow, from each moment on at which the digital output goes
  // on (extruder_stream.h).
  bool streams = false;
  bool byAxis = false;        // an external axis that each motion takes along (extruder_axis.h)
  double filamentMm = 0.0;    // its diameter, of one that can draw back; 0: it cannot
  double lagS = 0.0;          // assumed, from the word to the filament; told, not made up for
  std::string_view note = {}; // of its words, for the program's head
};

inline constexpr std::string_view kOutputsExtruder = "outputs";
inline constexpr std::string_view kCastelliExtruder = "castelli-serial";
inline constexpr std::string_view kStreamExtruder = "e-stream";

// How fast filament is drawn back and returned, where the arm waits for it.
inline constexpr double kDrawBackMmPerS = 10.0;

const std::vector<Extruder>& extruders();
// Throws Error{Usage} for an unknown id, naming the nearest.
const Extruder& findExtruder(std::string_view id);

// Which of them: as the cell has it, or one of `ids` (Dialect::extruders).
inline constexpr std::string_view kExtruderOption = "extruder";
base::ParameterSpec extruderOption(std::span<const std::string_view> ids);

// The one that a program is written for.
const Extruder& extruderOf(const ProgramInput& input);
// Throws Error{Usage}: the one that was chosen, or that the cell has, is none of `ids`, those that
// a format has words for. None: it tells amounts, and takes any.
void requireExtruder(std::string_view format, std::span<const std::string_view> ids,
                     const robot::Cell& cell, const ProgramOptions& options);

// Of the flow as a share of the full one: what is written of it. `outputs`: of the dialect's own.
double writtenBy(const Extruder& extruder, const process::Process& process, double share,
                 double (*outputs)(double share));

// What the head says of it; `outputs`: where they are the dialect's own.
std::string extruderNote(const ProgramInput& input, std::string_view outputs);

} // namespace voluta::program
