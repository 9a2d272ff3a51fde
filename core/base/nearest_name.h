// "Did you mean ...?" for unknown names.
#pragma once

#include "base/text.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {

// Returns the candidate with the smallest edit distance to `word` (ignoring case; the first of
// equals), or an empty string if there are no candidates.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);
// Returns the remedy "did you mean ...?"; empty if there are no candidates.
Message didYouMean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace voluta::base
