// The command of a line of a printer's G-code.
#pragma once

#include <string_view>

namespace voluta::sliced {

struct GcodeCommand {
  char letter = ' ';       // G, M or T; ' ': another one, such as a firmware's macro
  double number = 0.0;     // behind the letter
  std::string_view text;   // with its words; without line number, checksum and comment
  std::string_view remark; // behind the semicolon
  std::string_view next;   // the line from its next command on; empty: there is none
};

// Returns the first command of a line; an empty text if the line has none. Remarks in parentheses
// are no commands, wherever they stand. Several in one line are
// told apart where none of them can be another's word or text: the modes (G17 to G21, G40, G49,
// G90 to G94, M82, M83), motions, tools, heat, fans and shares (M220, M221).
GcodeCommand commandOf(std::string_view line);

} // namespace voluta::sliced
