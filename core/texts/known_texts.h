// Every text that core and widgets have for a user as data, as found in their sources by
// extract.cpp.
#pragma once

#include "base/text.h"

#include <span>
#include <string_view>

namespace voluta::texts {

// Each once.
std::span<const base::Text> knownTexts();
// The one that reads so in English (for many, where that differs); empty where there is none.
base::Text knownText(std::string_view english);

} // namespace voluta::texts
