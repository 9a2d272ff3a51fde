// Files of values that replace a text of the user's.
#pragma once

#include <filesystem>
#include <string>

namespace voluta::base {

// Returns the bytes of a file. Throws Error{UnreadableFile} as readFile(), and if the file has
// nothing but blanks: it would be taken for a text that was not given.
std::string readFilledFile(const std::filesystem::path& path);

} // namespace voluta::base
