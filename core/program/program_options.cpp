#include "program/program_options.h"

namespace voluta::program {

base::ParameterTable programParameters() {
  return base::ParameterTable(
      {base::integerParameter("motionsPerFile", 0, 0, 1000000, "Programs"_text,
                              "motions per file"_text,
                              "Longer programs are cut into files to be run in turn (URScript, "
                              "RAPID); 0: as the format has it."_text),
       base::choiceParameter(
           "urscriptForm", "node",
           {{"node", "file node of PolyScope"_text}, {"port", "sent to port 30001 or 30002"_text}},
           "Programs"_text, "URScript for"_text,
           "A file node needs the function to be called behind its end; text that "
           "is sent runs by itself and must not call it."_text),
       base::choiceParameter(
           "rapidModules", "mod", {{"mod", "IRC5: .mod"_text}, {"modx", "OmniCore: .modx"_text}},
           "Programs"_text, "RAPID modules"_text, "Which modules the controller loads."_text),
       base::numberParameter("tableXMm", "mm", 0.0, -1000.0, 1000.0, "Programs"_text,
                             "plate beside the tilt axis"_text,
                             "G-code with B and C: how far the plate's centre stands beside the "
                             "axis that the table tilts about, along X."_text),
       base::numberParameter(
           "tableZMm", "mm", 0.0, -1000.0, 1000.0, "Programs"_text,
           "plate above the tilt axis"_text,
           "G-code with B and C: how far the plate's top lies above the axis that "
           "the table tilts about."_text),
       base::choiceParameter(
           "tableSense", "part", {{"part", "the part"_text}, {"tool", "the tool (ISO 841)"_text}},
           "Programs"_text, "table's angles turn"_text,
           "G-code with B and C: whether B and C are the right-handed turn of the part, or that "
           "of the tool about a part that stands."_text)});
}

ProgramOptions programOptions(const base::ParameterValues& values) {
  return {.motionsPerFile = static_cast<std::size_t>(values.integer("motionsPerFile")),
          .urscriptForPort = values.text("urscriptForm") == "port",
          .rapidModx = values.text("rapidModules") == "modx",
          .tableXMm = values.number("tableXMm"),
          .tableZMm = values.number("tableZMm"),
          .tableReversed = values.text("tableSense") == "tool"};
}

} // namespace voluta::program
