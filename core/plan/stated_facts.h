// Statements of a program besides its motions and its flow: the machine's setup and operator stops.
// Readers collect them; the replay compares them with the facts that the plan needs
// (replay/required_facts.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace voluta::plan {

enum class FactKind : std::uint8_t {
  // Waits for the operator. Number 1: without time limit; 0: at most for a time that the statement
  // sets, or only if a switch is on
  OperatorStop,
  Payload,           // Number: mass on the flange [kg]
  NozzleHeat,        // Number: degrees C, 0: off
  NozzleHeatWait,    // Waits until the nozzle is that hot
  Home,              // Reference (homing) run. Number 1: all axes are there; 0: some of them
  Millimetres,       // Lengths are in mm
  AbsolutePositions, // Targets are absolute, not relative to the previous one
  FilamentCount,     // Whether amounts of filament are relative to the previous one
  FullFlow,        // Number: flow [mm3/s] at the maximum value of the flow output; word: that value
  FlowOutputRange, // Word: range of the flow output
  TargetFrame,     // The frame of the targets
  MechanicalUnit,  // Word: a unit that moves the part, the robot or the filament
  OpenRounding,    // Corners are blended as far as the controller chooses
  PassingOutput,   // An extruder output is set at a motion that does not stop
  ToolSelected,    // `tool` deposits from here on
  TapeCut,         // Cuts the tape
  FullPower,       // Number 1: the motors have their full power; 0: they are limited to a low one
  ToolLocked,      // Number 1: the tool changer locks the tool; 0: releases it
  BedHeat,         // Number: degrees C, 0: off
  BedHeatWait,     // Waits until the bed is that hot
  FanSpeed,        // Number: part cooling, 0..1
  BeadStartWord,   // Word: a statement of the process at the start of a bead
  BeadEndWord,     // Word: a statement of the process at the end of a bead
  MarkSet,         // Number: the code of a mark's output and its value (plan/marks.h)
  MarkAwaited,     // Number: that of an input that is waited for, without time limit
  Spindle,         // Number: speed of the cutter [1/min], 0: at rest
  BlockTurned,     // Number: angle to which the axis A turns the block [degrees]
  OwnStatement     // Word: a line that the user asked for (program/own_lines.h)
};

struct StatedFact {
  FactKind kind = FactKind::OperatorStop;
  std::uint32_t file = 0, line = 0; // As in ProgramMotion
  std::size_t before = 0;           // Index of the next motion; motions.size(): none
  std::size_t beforePause = 0;      // Index of the next pause; pauses.size(): none
  double number = 0.0;
  std::string word;
  int tool = 0; // That the statement concerns: the selected one, unless the statement names another
};

// The arm's posture at a target, as the flags of a language state it.
struct ArmPosture {
  std::uint32_t structure = 0, turns = 0;
  friend bool operator==(const ArmPosture&, const ArmPosture&) = default;
};
struct StatedPosture {
  std::size_t motion = 0;
  ArmPosture posture;
};

} // namespace voluta::plan
