// Files of rows, one a line: numbers between commas under a header line, for what a computer sends
// a controller. Remarks begin with '#', in lines of their own or behind a row.
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

// What of a line stands before its remark.
std::string_view rowOf(std::string_view line);
// Numbers between commas, just as many. false: it is something else.
bool parseNumbers(std::string_view line, std::span<double> numbers);

struct RowsForm {
  std::string_view header;
  base::Text notHeader, cutShort; // what is wrong with another first row, and without an end
};
// Reads one file into `out`, whose file is set: each row but the header goes to `take`, which says
// whether it was the end. What comes behind that, another header and a missing end are defects.
// Gives whether the end was found. Throws Cancelled.
bool readEachRow(std::string_view text, const RowsForm& form,
                 const std::function<bool(std::string_view row)>& take, ProgramBuilder& out,
                 const base::RunContext& ctx);

// The first row of a text, the header; empty: none in its first 16384 characters.
std::string_view firstRow(std::string_view text);
// Names of files that stand in its head behind these words, each of which begins a line.
std::vector<std::string> namesBehind(std::string_view text,
                                     std::initializer_list<std::string_view> notes);

} // namespace voluta::program
