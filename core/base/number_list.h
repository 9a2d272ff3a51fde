// Numbers that a user typed in one word: "5x200", "10,0,5".
#pragma once

#include <initializer_list>
#include <string_view>

namespace voluta::base {

// Is the text just as many finite numbers, the separator between them, blanks around them allowed?
// Sets the values; what they are where it returns false is left open.
bool readNumbers(std::string_view text, char separator, std::initializer_list<double*> values);

} // namespace voluta::base
