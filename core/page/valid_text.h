// Text that every viewer reads.
#pragma once

#include <string>
#include <string_view>

namespace voluta::page {

// UTF-8: bytes that are none, as a file's name may have, become replacement characters.
std::string validText(std::string_view bytes);

} // namespace voluta::page
