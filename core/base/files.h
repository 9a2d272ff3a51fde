// Files that are written whole or not at all, and read with clear errors.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace voluta::base {

// The bytes of a file. Throws Error{UnreadableFile}: missing, a directory, unreadable.
std::string readFile(const std::filesystem::path& path);

// Writes to a sibling temporary and renames it over `path`. Throws Error{CannotWrite}; then `path`
// is as it was.
void writeFile(const std::filesystem::path& path, std::string_view bytes);
// The parts one after the other, of which nothing is copied.
void writeFile(const std::filesystem::path& path, std::span<const std::string_view> parts);

// Folder of the program's data (robots/, cells/, processes/): VOLUTA_RESOURCES if set, else
// ../share/voluta beside the running program. Throws Error{UnreadableFile} when there is none.
std::filesystem::path resourceFolder();

} // namespace voluta::base
