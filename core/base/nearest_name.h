// "Did you mean ...?" for unknown names.
#pragma once

#include "base/error.h"
#include "base/text.h"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voluta::base {

// Returns the candidate with the smallest edit distance to `word` (ignoring case; the first of
// equals), or an empty string if there are no candidates.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);
// Returns the remedy "did you mean ...?"; empty if there are no candidates.
Message didYouMean(std::string_view word, const std::vector<std::string>& candidates);

// Returns the row with that id. Throws Error{Usage} with the text `unknown`, whose placeholder is
// the id, about `parameter`, and suggests the nearest id.
template <typename Row>
const Row& rowWithId(std::span<const Row> rows, std::string_view id, const Text& unknown,
                     std::string parameter) {
  std::vector<std::string> ids;
  for (const Row& row : rows) {
    if (row.id == id)
      return row;
    ids.emplace_back(row.id);
  }
  throw Error(ErrorCode::Usage, Message(unknown, {std::string(id)}), std::move(parameter),
              didYouMean(id, ids));
}

} // namespace voluta::base
