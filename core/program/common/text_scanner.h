// A statement that is read from left to right.
#pragma once

#include <string_view>

namespace voluta::program {

// Every function moves `rest` behind what it took; where there is no such thing it takes nothing
// but blanks.
struct TextScanner {
  std::string_view rest;

  void blanks();
  bool take(char c);
  // A letter or underscore, then letters, digits, underscores; empty: there is none.
  std::string_view name();
  // Behind its opening quotation mark, and what is closed by another.
  bool textBehindQuote(std::string_view& text);
  // Nothing but blanks is left.
  bool ended();
};

} // namespace voluta::program
