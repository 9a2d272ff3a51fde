// All texts of core and widgets that users see, as found in their sources by extract.cpp.
#pragma once

#include "base/text.h"

#include <span>
#include <string_view>

namespace voluta::texts {

// Returns each text once.
std::span<const base::Text> knownTexts();
// Returns the text with this English wording (the plural form, if there is one); empty if there is
// none.
base::Text knownText(std::string_view english);

} // namespace voluta::texts
