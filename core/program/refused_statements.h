// Words that a statement of the user's own must not have: the plan and its check hold only if the
// arm, its frames, the heat and the extruder are as the program says, and if the program goes on.
#pragma once

#include "base/text.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

struct RefusedWord {
  std::string word;           // as the statement has it
  base::Text effect, instead; // "moves the arm"; what the user does instead
};

// Returns the first such word of a statement of a dialect; nullopt if it has none.
std::optional<RefusedWord> refusedWord(std::string_view dialect, std::string_view statement);

// Returns the variables that a statement, or several with semicolons between them, sets, in small
// letters.
std::vector<std::string> assignedNames(std::string_view statement);
// Returns whether a line of code has that name, whatever its letters' case.
bool hasName(std::string_view line, std::string_view name);

} // namespace voluta::program
