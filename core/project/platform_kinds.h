// The table of platform kinds.
#pragma once

#include "project/platform_kind.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::project {

// In the order shown to users; the first is the default.
const std::vector<PlatformKind>& platformKinds();
// Throws Error{Usage} for an unknown word, naming the nearest.
const PlatformKind& findPlatformKind(std::string_view word);
// Returns the kinds of the first use, then those of the next, each once.
std::vector<const PlatformKind*> platformKindsFor(const std::vector<PlatformUse>& uses);

// Returns the textual form, e.g. "disc:DIAMETER" or "fit[:MARGIN]".
std::string platformForm(const PlatformKind& kind);
// Returns the forms of all kinds with these uses, separated by commas.
std::string platformForms(const std::vector<PlatformUse>& uses);

} // namespace voluta::project
