#include "program/program_options.h"

namespace voluta::program {

base::ParameterTable programParameters() {
  return base::ParameterTable(
      {base::integerParameter("motionsPerFile", 0, 0, 1000000, "Programs"_text,
                              "motions per file"_text,
                              "Longer programs are cut into files to be run in turn (URScript, "
                              "RAPID, KRL, SPEL+); 0: as the format has it."_text),
       base::choiceParameter(
           "urscriptForm", "node",
           {{"node", "file node of PolyScope"_text}, {"port", "sent to port 30001 or 30002"_text}},
           "Programs"_text, "URScript for"_text,
           "A file node needs the function to be called behind its end; text that "
           "is sent runs by itself and must not call it."_text),
       base::choiceParameter(
           "rapidModules", "mod", {{"mod", "IRC5: .mod"_text}, {"modx", "OmniCore: .modx"_text}},
           "Programs"_text, "RAPID modules"_text, "Which modules the controller loads."_text),
       base::numberParameter("krlMemoryMb", "MB", 4.0, 0.1, 10000.0, "Programs"_text,
                             "KRL memory"_text,
                             "Room for programs on the controller: a longer one says so in its "
                             "head."_text)});
}

ProgramOptions programOptions(const base::ParameterValues& values) {
  return {.motionsPerFile = static_cast<std::size_t>(values.integer("motionsPerFile")),
          .urscriptForPort = values.text("urscriptForm") == "port",
          .rapidModx = values.text("rapidModules") == "modx",
          .krlMemoryMb = values.number("krlMemoryMb")};
}

} // namespace voluta::program
