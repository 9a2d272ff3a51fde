// Files that are written whole or not at all, and read with clear errors.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace voluta::base {

// The bytes of a file. Throws Error{UnreadableFile}: missing, a directory, unreadable.
std::string readFile(const std::filesystem::path& path);

// Writes to a sibling temporary and renames it over `path`. Throws Error{CannotWrite}; then `path`
// is as it was.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

// A folder filled out of sight. Files are written into path(); commit() moves each of them into
// `target` by rename (made with its parents where missing; what else it holds stays). Without it
// the destructor removes them and `target` is as it was. The staging folder stands beside the
// first folder above target that exists, so renames stay on one file system.
class StagedFolder {
public:
  // Throws Error{CannotWrite}: the target is a file, or cannot be made or written.
  explicit StagedFolder(std::filesystem::path target);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_; }
  // Throws Error{CannotWrite}; then `target` is as it was.
  void commit();
  // What the destructor does, for a process that must leave at once. Does not throw.
  void discard() noexcept;

private:
  std::filesystem::path target_, staging_;
};

// Folder of the program's data (robots/, cells/, processes/): VOLUTA_RESOURCES if set, else
// ../share/voluta beside the running program. Throws Error{UnreadableFile} when there is none.
std::filesystem::path resourceFolder();

} // namespace voluta::base
