// A table of numbers with a row of names above it, as controllers and their tools record runs.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::record {

struct Table {
  std::string source;                    // name of the file, for errors
  std::vector<std::string> names;        // of the columns
  std::vector<std::vector<double>> rows; // each as long as names; words are NaN
  std::vector<long long> lines;          // per row: its line in the file, from 1

  // Returns the index of the first of these columns that there is, in any case of letters.
  std::optional<std::size_t> column(std::initializer_list<std::string_view> anyOf) const;
  // Returns the indices of prefix0, prefix1 ... or, counted from 1, of prefix1, prefix2 ..., each
  // followed by `suffix`; empty: there are none.
  std::vector<std::size_t> columns(std::string_view prefix, std::string_view suffix) const;
  // Throws Error{UnusableInput} naming line and column if the value is no number.
  double at(std::size_t row, std::size_t column) const;
};

// Reads a table with commas, semicolons, tabs or blanks between its values. Text after # and empty
// lines are ignored; a row that is cut short at the end of the file is left out. Throws
// Error{UnusableInput} if there is no row of names, a row of another length, or no row at all.
Table readTable(std::string_view text, std::string_view source);

} // namespace voluta::record
