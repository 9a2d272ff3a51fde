// Which files make up a RAPID program: its list of modules (.pgf), its signals (EIO.cfg).
#pragma once

#include "plan/program.h"
#include "program/program_builder.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// A module's text without its header, %%% ... %%% (version and language), where it has one.
std::string_view behindHeader(std::string_view text);
bool isModuleList(std::string_view text);
// Configuration of the controller's signals (EIO.cfg), which no program runs.
bool isSignalList(std::string_view text);
// Of module files: .modx for an OmniCore, which runs RobotWare 7, else .mod.
std::string_view moduleExtension(bool omniCore);
// Those two as they are written: the list names one module, which loads the others. `unit`: the
// mechanical unit that the program expects; empty: none. `omniCore`: for RobotWare 7, else 6.
std::string moduleListText(std::string_view module);
std::string signalListText(std::string_view unit, bool omniCore);
// A trimmed line of a list that names a module becomes the name.
bool takeModule(std::string_view& line);
// Of a list: is every module that it names there? Defects go to `out`. false: it has no end.
bool readModuleList(std::string_view text, const std::vector<plan::ProgramFile>& files,
                    ProgramBuilder& out);
// The first line that ends otherwise than with CR LF is a defect. The last may have no end.
void tellLineEnds(std::string_view text, ProgramBuilder& out);

} // namespace voluta::program
