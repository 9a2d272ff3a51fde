#include "program/urscript/urscript.h"

#include <array>

namespace voluta::program {

// URScript manual, sections "Module motion", "Module internals", "Module interfaces".
std::span<const KnownWord> urscriptWords() {
  static constexpr std::array kTable = {
      KnownWord{"textmsg", kAnywhere, "a line in the log"},
      KnownWord{"sync", kAtRest, "uses up the cycle's time"},
      KnownWord{"popup", kAtRest, "waits for the operator"},
      KnownWord{"stopl", kAtRest, "decelerates along the line"},
      KnownWord{"stopj", kAtRest, "decelerates in joints"},
      KnownWord{"set_payload", kSetUp, "mass and centre of what the arm carries"},
      KnownWord{"set_payload_mass", kSetUp, "mass of what the arm carries"},
      KnownWord{"set_payload_cog", kSetUp, "its centre"},
      KnownWord{"set_target_payload", kSetUp, "mass, centre and inertia"},
      KnownWord{"set_gravity", kSetUp, "which way is down"},
      KnownWord{"set_tool_voltage", kSetUp, "supply of the tool's connector"},
      KnownWord{"set_tool_communication", kSetUp, "serial line of the tool's connector"},
      KnownWord{"set_tool_output_mode", kSetUp, "kind of the tool's outputs"},
      KnownWord{"set_analog_outputdomain", kSetUp, "4-20 mA or 0-10 V"},
      KnownWord{"set_standard_analog_output_domain", kSetUp, "4-20 mA or 0-10 V"},
      KnownWord{"set_analog_inputrange", kSetUp, "range of an input"},
      KnownWord{"set_standard_analog_input_domain", kSetUp, "kind of an input"},
      KnownWord{"set_standard_digital_input_action", kSetUp, "what an input starts"},
      KnownWord{"set_runstate_standard_digital_output_to_value", kSetUp, "output of a stop"},
      KnownWord{"set_tool_digital_out", kOutsidePrint, "an output of the tool"},
      KnownWord{"set_configurable_digital_out", kOutsidePrint,
                "an output that is not the extruder's"},
      KnownWord{"socket_open", kSetUp, "a way to another machine"},
      KnownWord{"socket_close", kAtEnd, "its end"},
      KnownWord{"set_flag", kAnywhere, "a flag of the program's own"},
  };
  return kTable;
}

} // namespace voluta::program
