// Frames in which a listen node receives scripts: $TMSCT,<bytes>,<id>,<script>,*<checksum> and CR
// LF. <bytes> is the length of "id,script"; the checksum is the XOR of all bytes between $ and *,
// as two hexadecimal digits (tmr_ros1; docs/programs.md on TMscript).
#pragma once

#include "base/text.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::program {

// Returns the frame with its CR LF. Precondition: no line end in `id`.
std::string tmFrame(std::string_view id, std::string_view script);

struct TmFrame {
  std::string_view script;
  std::size_t length = 0; // Of the whole frame, without the line end after it
  bool sound = true; // If false, `reason` is the defect, and `script` is as much as could be read
  base::Message reason;
};

// Returns the frame at the beginning of `text`, which may extend over several lines. Precondition:
// `text` begins with '$'.
TmFrame takeTmFrame(std::string_view text);

} // namespace voluta::program
