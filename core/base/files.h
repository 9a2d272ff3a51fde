// Files that are written completely or not at all, and read with clear errors.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace voluta::base {

// Returns the bytes of a file. Throws Error{UnreadableFile} if it is missing, a directory or
// unreadable.
std::string readFile(const std::filesystem::path& path);

// Returns up to `count` bytes from the beginning of a file; fewer, or none, if it is shorter or
// cannot be read.
std::string beginningOf(const std::filesystem::path& path, std::size_t count);

// Writes to a temporary file beside `path` and renames it. Throws Error{CannotWrite}; `path` is
// then unchanged.
void writeFile(const std::filesystem::path& path, std::string_view bytes);
// Writes the parts one after the other, without copying them.
void writeFile(const std::filesystem::path& path, std::span<const std::string_view> parts);

// Returns the folder of the program's data (robots/, cells/, processes/): VOLUTA_RESOURCES if set,
// else ../share/voluta beside the running program. Throws Error{UnreadableFile} if there is none.
std::filesystem::path resourceFolder();

} // namespace voluta::base
