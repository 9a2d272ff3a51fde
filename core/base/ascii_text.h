// Texts from files, and of users, in the characters that every controller shows.
#pragma once

#include <string>
#include <string_view>

namespace voluta::base {

// Returns a text of UTF-8 in printable ASCII: letters with marks, ligatures, Cyrillic letters and
// signs as they are usually transcribed (ä: ae, é: e, ш: sh, °: deg); any other character becomes
// '_'.
std::string asciiText(std::string_view text);

} // namespace voluta::base
