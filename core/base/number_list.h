// Numbers that a user typed in one word, "5x200", "10,0,5", or put into a table.
#pragma once

#include "base/text.h"

#include <initializer_list>
#include <string_view>
#include <vector>

namespace voluta::base {

// Is the text just as many finite numbers, the separator between them, blanks around them allowed?
// Sets the values; what they are where it returns false is left open.
bool readNumbers(std::string_view text, char separator, std::initializer_list<double*> values);

// The rows of a table of finite numbers, with commas, semicolons, tabs or blanks between them; what
// follows a # and empty lines are no rows. `source`: what the table is called. Throws
// Error{UnusableInput} with the line: what is no number, a row of another length than the first.
std::vector<std::vector<double>> readRows(std::string_view text, std::string_view source);

} // namespace voluta::base
