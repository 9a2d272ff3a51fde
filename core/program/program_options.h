// User options for the text of programs, defined by the rows of the registry (Dialect::options).
#pragma once

#include "base/parameters.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

struct ProgramOptions {
  // A program with more motions is split into files that are run one after the other, if possible
  // at points where the extruder is off. 0: the dialect's default.
  std::size_t motionsPerFile = 0;
  // The other options by key; missing ones have their default.
  std::map<std::string, base::ParameterValue, std::less<>> own = {};
};

// Shared by the dialects whose programs can be split: sets ProgramOptions::motionsPerFile.
base::ParameterSpec motionsPerFileOption();

// Shared by all dialects whose motions are straight: the tolerance within which points of beads are
// omitted [mm], 0: none. Of those with circular motions: whether they are used.
base::ParameterSpec programResolution();
base::ParameterSpec arcFitting();

// Returns the chosen number, or the dialect's `usual`. 0: unlimited.
std::size_t motionsPerFile(const ProgramOptions& options, std::size_t usual);

// Returns the chosen id of a choice option.
std::string chosenOf(const base::ParameterSpec& option, const ProgramOptions& options);
// Return the value of a numeric option, and of a boolean one.
bool isOn(const base::ParameterSpec& option, const ProgramOptions& options);
double numberOf(const base::ParameterSpec& option, const ProgramOptions& options);

// Returns those of `options` that are among `specs`.
ProgramOptions optionsAmong(const std::vector<base::ParameterSpec>& specs,
                            const ProgramOptions& options);

// Returns the values chosen for `specs`. Throws nothing if `values` belong to a table with them.
ProgramOptions optionsOf(const std::vector<base::ParameterSpec>& specs,
                         const base::ParameterValues& values);

// Returns a key: equal texts mean equal options (base/key_text.h).
std::string keyOf(const ProgramOptions& options);

} // namespace voluta::program
