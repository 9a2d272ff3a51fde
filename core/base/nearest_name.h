// "Did you mean ...?" for unknown names.
#pragma once

#include "base/text.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {

// The candidate with the least edit distance to `word` (case ignored; first of equals), or an
// empty string when there are no candidates.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);
// "did you mean ...?", the remedy of an error; empty when there are no candidates.
Message didYouMean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace voluta::base
