// The language of the window, for what core writes in it.
#pragma once

#include "base/text.h"

#include <memory>
#include <string>

namespace voluta::language {

// Good for any thread. Never null.
std::shared_ptr<const base::Language> windowLanguage();
// BCP 47, such as "it".
std::string windowLanguageCode();

} // namespace voluta::language
