// Splits a MELFA-BASIC program into its steps.
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
  std::size_t line; // From 1
  std::string_view code;
};

struct MelfaText {
  std::vector<MelfaStep> steps;                           // Steps with code
  std::map<std::string, std::size_t, std::less<>> labels; // Lower-case label -> index of its step
  std::size_t lastLine = 0;
};

// Returns a step's line without its number and remark. `step`: its number, 0 if it has none.
std::string_view melfaCode(std::string_view line, std::size_t& step);

// Returns the next of the statements that share a step and advances `rest` beyond it. Empty if
// there is none, or between two adjacent colons.
std::string_view takeMelfaStatement(std::string_view& rest);

// `text` must outlive the result. Steps that are too long, numbers that do not ascend and a last
// line without a line end are defects of `out`, whose line advances. Throws Cancelled.
MelfaText melfaText(std::string_view text, ProgramBuilder& out, const base::RunContext& ctx);

} // namespace voluta::program
