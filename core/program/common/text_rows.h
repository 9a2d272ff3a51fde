// Reads files with one row per line: comma-separated numbers below a header line, as sent by a
// computer to a controller. Remarks begin with '#', on their own line or after a row.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "program/program_builder.h"

#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns the part of a line before its remark.
std::string_view rowOf(std::string_view line);
// Parses exactly as many comma-separated numbers. Returns false otherwise.
bool parseNumbers(std::string_view line, std::span<double> numbers);

struct RowsForm {
  std::string_view header;
  base::Text notHeader, cutShort; // errors for a different first row, and for a missing end
};
// Reads one file into `out`, whose file is set: passes each row except the header to `take`, which
// returns whether it was the end. Rows after the end, a different header and a missing end are
// defects. Returns whether the end was found. Throws Cancelled.
bool readEachRow(std::string_view text, const RowsForm& form,
                 const std::function<bool(std::string_view row)>& take, ProgramBuilder& out,
                 const base::RunContext& ctx);

// Returns the first row of a text, the header; empty if its first 16384 characters contain none.
std::string_view firstRow(std::string_view text);
// Returns the file names in the head of the text that follow these words, each of which begins a
// line.
std::vector<std::string> namesBehind(std::string_view text,
                                     std::initializer_list<std::string_view> notes);

} // namespace voluta::program
