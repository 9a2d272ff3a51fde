// Makes text valid UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace voluta::page {

// Returns the text with invalid bytes, which file names may contain, replaced by replacement
// characters.
std::string validText(std::string_view bytes);

} // namespace voluta::page
