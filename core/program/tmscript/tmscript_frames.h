// Frames in which a listen node takes scripts: $TMSCT,<bytes>,<id>,<script>,*<checksum> and CR LF.
// <bytes> are those of "id,script"; the checksum is XOR of all bytes between $ and *, in two
// hexadecimal digits (tmr_ros1; docs/programs.md on TMscript).
#pragma once

#include "base/text.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::program {

// With its CR LF. Precondition: no line end in `id`.
std::string tmFrame(std::string_view id, std::string_view script);

struct TmFrame {
  std::string_view script;
  std::size_t length = 0; // of the whole frame, without the line end behind it
  bool sound = true;      // else `reason` says why not; the script is then what can be made of it
  base::Message reason;
};

// The frame that `text` begins with, which may go on over lines. Precondition: it begins with '$'.
TmFrame takeTmFrame(std::string_view text);

} // namespace voluta::program
