// What a user may choose about the text of programs: options that the rows of the registry bring
// (Dialect::options).
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
  // A program of more motions is cut into files to be run one after the other, each cut where the
  // extruder is off if there is such a place. 0: as the dialect has it.
  std::size_t motionsPerFile = 0;
  // The other options, by key; one that is not there has its default.
  std::map<std::string, base::ParameterValue, std::less<>> own = {};
};

// Shared by the dialects whose programs may be cut: fills ProgramOptions::motionsPerFile.
base::ParameterSpec motionsPerFileOption();

// What was chosen, or as many as the dialect has it. 0: any number.
std::size_t motionsPerFile(const ProgramOptions& options, std::size_t usual);

// The id that was chosen of an option that is a choice.
std::string chosenOf(const base::ParameterSpec& option, const ProgramOptions& options);
// Of an option that is a number.
double numberOf(const base::ParameterSpec& option, const ProgramOptions& options);

// Those of `options` that are among `specs`.
ProgramOptions optionsAmong(const std::vector<base::ParameterSpec>& specs,
                            const ProgramOptions& options);

// What was chosen among `specs`. Throws nothing when `values` are over a table with them.
ProgramOptions optionsOf(const std::vector<base::ParameterSpec>& specs,
                         const base::ParameterValues& values);

// Equal texts, equal options (base/key_text.h).
std::string keyOf(const ProgramOptions& options);

} // namespace voluta::program
