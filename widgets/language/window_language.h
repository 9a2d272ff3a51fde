// The window's language, for texts formatted by core.
#pragma once

#include "base/text.h"

#include <memory>
#include <string>

namespace voluta::language {

// Thread-safe. Never null.
std::shared_ptr<const base::Language> windowLanguage();
// BCP 47, such as "it".
std::string windowLanguageCode();

} // namespace voluta::language
