// A program of MELFA-BASIC taken apart into its steps.
#pragma once

#include "base/run_context.h"
#include "program/program_builder.h"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

struct MelfaStep {
  std::size_t line; // from 1
  std::string_view code;
};

struct MelfaText {
  std::vector<MelfaStep> steps;                           // with code in them
  std::map<std::string, std::size_t, std::less<>> labels; // in small letters; indices of steps
  std::size_t lastLine = 0;
};

// A step's line without its number and its remark. `step`: its number, 0 where it has none.
std::string_view melfaCode(std::string_view line, std::size_t& step);

// The next of the statements that share a step; `rest` moves behind it. Empty: there is none, or
// none between two colons.
std::string_view takeMelfaStatement(std::string_view& rest);

// `text` lives as long as what is made of it. Steps that are too long, numbers that do not ascend
// and a last line without an end are defects of `out`, whose line moves. Throws Cancelled.
MelfaText melfaText(std::string_view text, ProgramBuilder& out, const base::RunContext& ctx);

} // namespace voluta::program
