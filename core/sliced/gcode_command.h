// The command of a line of a printer's G-code.
#pragma once

#include <string_view>

namespace voluta::sliced {

struct GcodeCommand {
  char letter = ' ';       // G, M or T; ' ': another one, such as a firmware's macro
  double number = 0.0;     // behind the letter
  std::string_view text;   // with its words; without line number, checksum and comment
  std::string_view remark; // behind the semicolon
};

// Returns the command; an empty text if the line has none.
GcodeCommand commandOf(std::string_view line);

} // namespace voluta::sliced
