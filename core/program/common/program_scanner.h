// Scanner of a statement from left to right.
#pragma once

#include <string_view>

namespace voluta::program {

// Each function advances `rest` past the text that it takes; if nothing matches, only past blanks.
struct TextScanner {
  std::string_view rest;

  void blanks();
  bool take(char c);
  // A letter or underscore, then letters, digits, underscores; empty if there is none.
  std::string_view name();
  // Takes the text up to the closing quotation mark; the opening one is already taken.
  bool textBehindQuote(std::string_view& text);
  // Returns whether only blanks are left.
  bool ended();
};

} // namespace voluta::program
