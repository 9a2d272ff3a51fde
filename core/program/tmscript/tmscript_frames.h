// Frames in which a listen node receives scripts: $TMSCT,<bytes>,<id>,<script>,*<checksum> and CR
// LF. <bytes> is the length of "id,script"; the checksum is the XOR of all bytes between $ and *,
// as two hexadecimal digits (tmr_ros1; docs/programs.md on TMscript).
#pragma once

#include "base/text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Returns the frame with its CR LF. Precondition: no line end in `id`.
std::string tmFrame(std::string_view id, std::string_view script);

struct TmFrame {
  std::string_view id, script;
  std::size_t length = 0; // Of the whole frame, without the line end after it
  bool sound = true; // If false, `reason` is the defect, and `script` is as much as could be read
  base::Message reason;
};

// Returns the frame at the beginning of `text`, which may extend over several lines. Precondition:
// `text` begins with '$'.
TmFrame takeTmFrame(std::string_view text);

// A frame of a file that does not follow the number of the one before it.
struct TmFrameGap {
  std::size_t line = 0;
  std::string id, before;
};
// The ids of a file's frames. Numbers count up if most do; frames with another id count, too.
class TmFrameNumbers {
public:
  void add(std::string_view id, std::size_t line);
  std::vector<TmFrameGap> gaps() const; // none if the numbers do not count up

private:
  std::optional<long> last_;
  std::string lastId_;
  std::size_t steps_ = 0; // that count up
  std::vector<TmFrameGap> others_;
};

} // namespace voluta::program
