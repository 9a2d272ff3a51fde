// Parses numbers that users type in one word, "5x200", "10,0,5", or put into a table.
#pragma once

#include "base/text.h"

#include <initializer_list>
#include <string_view>
#include <vector>

namespace voluta::base {

// Returns whether the text has exactly as many finite numbers as `values`, with the separator
// between them and optional blanks around them. Sets the values; if it returns false they are
// unspecified.
bool readNumbers(std::string_view text, char separator, std::initializer_list<double*> values);

// Returns the rows of a table of finite numbers, separated by commas, semicolons, tabs or blanks;
// text after # and empty lines are ignored. `source`: the table's name. Throws Error{UnusableInput}
// with the line if a value is no number or a row differs in length from the first.
std::vector<std::vector<double>> readRows(std::string_view text, std::string_view source);

} // namespace voluta::base
