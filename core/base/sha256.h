// Hash of a file's content, as computed by sha256sum.
#pragma once

#include <string>
#include <string_view>

namespace voluta::base {

// Returns 64 hexadecimal digits (FIPS 180-4, section 6.2).
std::string sha256(std::string_view bytes);

} // namespace voluta::base
