// The supported extruder interfaces: how a robot's program states the amount of filament, one row
// each. A cell defines its extruder; a dialect's option `extruder` overrides it. To add one, add a
// file and a row.
//
// Dialects whose motions state amounts (G-code's E, the joint table) have their own extruder and
// use none of these.
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
  // For extruders controlled by texts that the program sends (ProgramEmitter::send): returns the
  // text for a flow [mm3/s]; 0 stops it. nullptr: controlled by outputs.
  std::string (*text)(double mm3PerS) = nullptr;
  // For such extruders with a fan: returns the text for part cooling, 0..1; nullptr: without a fan.
  std::string (*fan)(double share) = nullptr;
  // Returns the flow [mm3/s] that is actually written for a wanted flow. nullptr: as with the
  // dialect's analogue output.
  double (*written)(double mm3PerS) = nullptr;
  // A separate file states the flow over time, starting whenever the digital output is switched on
  // (extruder_stream.h).
  bool streams = false;
  bool byAxis = false;     // an external axis that each motion moves (extruder_axis.h)
  double filamentMm = 0.0; // filament diameter if it can retract, else 0
  double lagS = 0.0; // assumed delay from the command to the filament; reported, not compensated
  std::string_view note = {}; // on its commands, for the program's head
};

inline constexpr std::string_view kOutputsExtruder = "outputs";
inline constexpr std::string_view kCastelliExtruder = "castelli-serial";
inline constexpr std::string_view kStreamExtruder = "e-stream";

// Speed of retraction and return of filament while the arm waits.
inline constexpr double kDrawBackMmPerS = 10.0;

const std::vector<Extruder>& extruders();
// Throws Error{Usage} for an unknown id, naming the most similar one.
const Extruder& findExtruder(std::string_view id);

// The option that selects the extruder: that of the cell, or one of `ids` (Dialect::extruders).
inline constexpr std::string_view kExtruderOption = "extruder";
base::ParameterSpec extruderOption(std::span<const std::string_view> ids);

// Returns the extruder that a program is written for.
const Extruder& extruderOf(const ProgramInput& input);
// Throws Error{Usage} if the chosen extruder, or the cell's, is not among `ids`, those that a
// format supports. If `ids` is empty, the format states amounts and supports any extruder.
void requireExtruder(std::string_view format, std::span<const std::string_view> ids,
                     const robot::Cell& cell, const ProgramOptions& options);

// Throws Error{Usage} if the trajectory has events that the program's extruder cannot follow: a
// change of the tool needs outputs that select it; the lags of an extruder need one that is not fed
// amounts, since it runs while the arm waits.
void requireEventsSaid(const ProgramInput& input);

// Returns the written flow for a wanted flow, both as shares of the full flow. `outputs`:
// conversion of the dialect's own outputs.
double writtenBy(const Extruder& extruder, const process::Process& process, double share,
                 double (*outputs)(double share));

// Returns the note on the extruder for the head; `outputs`: the description of the dialect's own
// outputs.
std::string extruderNote(const ProgramInput& input, std::string_view outputs);

} // namespace voluta::program
