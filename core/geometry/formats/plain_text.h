// Text files of whatever encoding and custom of writing, as the readers take them.
#pragma once

#include "base/text.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

struct PlainText {
  std::string_view original;
  std::optional<std::string> converted; // UTF-8 with decimal points; none: `original` is that
  std::vector<base::Message> notes;     // what was read in a way that is not the usual one

  std::string_view text() const { return converted ? std::string_view(*converted) : original; }
};

// Binary bytes come back as they are. In text UTF-16 becomes UTF-8, a byte-order mark goes, and
// numbers with decimal commas get points. Bytes that are text hold no zero byte, but for UTF-16.
// Throws Error{UnreadableFile}: UTF-32, damaged UTF-16; commas that may separate thousands, or
// beside decimal points in a line. `name`: of the file, for errors.
PlainText plainText(std::string_view bytes, const std::string& name);

} // namespace voluta::geometry
