// Texts from files, which may have any bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::base {

// Returns at most `maxLength` bytes of a text, which end with a whole character. Bytes that are no
// UTF-8, and those of control characters beyond ASCII, become '?'.
std::string validText(std::string_view text, std::size_t maxLength = std::string_view::npos);

} // namespace voluta::base
