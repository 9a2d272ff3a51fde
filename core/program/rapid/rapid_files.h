// The files that make up a RAPID program: its list of modules (.pgf), its signals (EIO.cfg).
#pragma once

#include "plan/program.h"
#include "program/program_builder.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns a module's text without its header, %%% ... %%% (version and language), if any.
std::string_view behindHeader(std::string_view text);
bool isModuleList(std::string_view text);
// Configuration of the controller's signals (EIO.cfg), which no program runs.
bool isSignalList(std::string_view text);
// Returns the extension of module files: .modx for an OmniCore, which runs RobotWare 7, else .mod.
std::string_view moduleExtension(bool omniCore);
// Return these two files as written: the list names one module, which loads the others. `unit`: the
// mechanical unit that the program expects; empty: none. `omniCore`: for RobotWare 7, else 6.
// `extrudes`: there are signals for an extruder; `outputs`: names of further digital ones.
std::string moduleListText(std::string_view module);
std::string signalListText(std::string_view unit, bool omniCore, bool extrudes,
                           std::span<const std::string> outputs);
// Reduces a trimmed line of a list that names a module to the name.
bool takeModule(std::string_view& line);
// Checks that every module in the list exists. Defects are added to `out`. Returns false if the
// list has no end.
bool readModuleList(std::string_view text, const std::vector<plan::ProgramFile>& files,
                    ProgramBuilder& out);
// Reports the first line that does not end with CR LF as a defect. The last line may have no end.
void reportLineEnds(std::string_view text, ProgramBuilder& out);

} // namespace voluta::program
