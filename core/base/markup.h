// Text for use in XML or HTML.
#pragma once

#include <string>
#include <string_view>

namespace voluta::base {

// Returns the text with entities for the markup characters & < > ".
std::string escapedMarkup(std::string_view text);

} // namespace voluta::base
