// What a part can be printed on: one row a kind.
#pragma once

#include "project/platform_kind.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::project {

// In the order they are offered; the first is what there is unless another one is chosen.
const std::vector<PlatformKind>& platformKinds();
// Throws Error{Usage} for an unknown word, naming the nearest.
const PlatformKind& findPlatformKind(std::string_view word);
// Those of the first use, then those of the next, each once.
std::vector<const PlatformKind*> platformKindsFor(const std::vector<PlatformUse>& uses);

// "disc:DIAMETER", "fit[:MARGIN]": how it is typed.
std::string platformForm(const PlatformKind& kind);
// The forms of all kinds with these uses, with commas between.
std::string platformForms(const std::vector<PlatformUse>& uses);

} // namespace voluta::project
