// Text that is put into XML or HTML.
#pragma once

#include <string>
#include <string_view>

namespace voluta::base {

// With entities for what is markup: & < > ".
std::string escapedMarkup(std::string_view text);

} // namespace voluta::base
