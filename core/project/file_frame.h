// The frame of a project file: a first line with the kind of file and its format, a line with
// length and CRC-32 of a header, the header, and the body.
#pragma once

#include "base/text.h"

#include <string>
#include <string_view>

namespace voluta::project {

// How a kind of file begins, and what is said about one that cannot be read.
struct FileNames {
  std::string_view magic;
  base::Text other, truncated, damaged; // another kind of file; ends early; wrong checksum
};

struct FileFrame {
  int format = 0;
  std::string_view header, body;
};

// Returns the frame of a file's bytes, which it refers to. `oldest`, `newest`: formats that can be
// read. Throws Error{UnreadableFile} with `where`.
FileFrame fileFrame(std::string_view bytes, const std::string& where, const FileNames& names,
                    int oldest, int newest);
// Returns all that stands before the body.
std::string fileHead(std::string_view magic, int format, const std::string& header);

} // namespace voluta::project
