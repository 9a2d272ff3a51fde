// Texts for the operator at a stop.
#pragma once

#include <string>
#include <string_view>

namespace voluta::program {

// Returns such a text as programs of a format have it, so that their reader returns the same:
// G-code has no comments, checksums and numbers of seconds in it.
std::string shownText(std::string_view format, std::string_view text);

} // namespace voluta::program
