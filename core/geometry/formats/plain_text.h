// Normalizes text files of different encodings and number formats for the readers.
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
  std::vector<base::Message> notes;     // about unusual encodings and number formats

  std::string_view text() const { return converted ? std::string_view(*converted) : original; }
};

// Binary bytes are returned unchanged. In text, UTF-16 is converted to UTF-8, a byte-order mark is
// removed, and decimal commas are replaced by points. Bytes with a zero byte are not text, except
// for UTF-16. Throws Error{UnreadableFile} for UTF-32, damaged UTF-16, and commas that may separate
// thousands or occur beside decimal points in a line. `name`: of the file, for errors.
PlainText plainText(std::string_view bytes, const std::string& name);

} // namespace voluta::geometry
