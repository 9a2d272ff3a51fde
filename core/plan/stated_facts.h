// What a program states beside its motions and its flow: how the machine is set up, and where it
// waits for the operator. Readers collect the statements, the replay compares them with what the
// plan needs (replay/stated_facts.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace voluta::plan {

enum class FactKind : std::uint8_t {
  OperatorStop,      // waits for the operator; number 1: as long as that takes, 0: no longer than
                     // a time that the statement sets, or only if a switch says so
  NozzleHeat,        // number: degrees C, 0: off
  NozzleHeatWait,    // waits until the nozzle is that hot
  Home,              // drives to the reference
  Millimetres,       // lengths are in mm
  AbsolutePositions, // targets do not count from the last one
  FilamentCount,     // whether amounts of filament count from the last one
  FullFlow,          // number: mm3/s at the greatest value of the flow output; word: that value
  FlowOutputRange,   // word: what the flow output goes through
  TargetFrame,       // the frame that targets are in
  MechanicalUnit,    // word: a unit that moves part, robot or filament
  OpenRounding,      // corners are rounded, as far as the controller chooses
  PassingOutput,     // an output of the extruder is set beside a motion that does not stop
  ToolSelected,      // number: the tool that deposits from here on
  TapeCut            // the tape is cut
};

struct StatedFact {
  FactKind kind = FactKind::OperatorStop;
  std::uint32_t file = 0, line = 0; // as of a motion
  std::size_t before = 0;           // the motion that follows; motions.size(): none
  std::size_t beforePause = 0;      // the pause that follows, likewise
  double number = 0.0;
  std::string word;
};

// How the arm stands at a target, as the flags of a language say it.
struct ArmPosture {
  std::uint32_t structure = 0, turns = 0;
  friend bool operator==(const ArmPosture&, const ArmPosture&) = default;
};
struct StatedPosture {
  std::size_t motion = 0;
  ArmPosture posture;
};

} // namespace voluta::plan
