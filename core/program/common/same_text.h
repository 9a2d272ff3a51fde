// Checks companion programs: those that are the same for every job, or derived from the main
// program.
#pragma once

#include "base/text.h"
#include "program/program_builder.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Adds a defect at the first line of the text that differs from the expected one; trailing blanks
// and line ends are ignored. `line`: number of the text's first line.
void reportOtherText(std::string_view text, std::string_view expected, std::size_t line,
                     ProgramBuilder& out);

// Returns the code of a line without values that the user sets there; empty for a remark.
using CodeOf = std::function<std::string(std::string_view line)>;
// Adds a defect, at out.line, if the text's code is not this sequence of steps: `other` with the
// placeholder {code}, or `cutShort`.
struct OtherSteps {
  base::TextWithPlaces<1> other;
  base::Text cutShort;
};
void reportOtherSteps(std::string_view text, const std::vector<std::string>& steps,
                      const CodeOf& codeOf, const OtherSteps& refusals, ProgramBuilder& out);

} // namespace voluta::program
