// Programs beside one that is judged: the same for every job, or made from that one.
#pragma once

#include "base/text.h"
#include "program/program_builder.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// A defect of the file that is read where its first line other than the expected one stands; blanks
// and ends of lines do not count behind a line. `line`: of the text's first.
void tellOtherText(std::string_view text, std::string_view expected, std::size_t line,
                   ProgramBuilder& out);

// What of a line is code, without what a user sets there; empty: a remark.
using CodeOf = std::function<std::string(std::string_view line)>;
// A defect, with out.line there, where the text's code is not these steps one after the other:
// `other` with its place {code}, or `cutShort`.
struct OtherSteps {
  base::TextWithPlaces<1> other;
  base::Text cutShort;
};
void tellOtherSteps(std::string_view text, const std::vector<std::string>& steps,
                    const CodeOf& codeOf, const OtherSteps& told, ProgramBuilder& out);

} // namespace voluta::program
