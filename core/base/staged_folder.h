// Writes a set of files into a folder as a whole: afterwards the folder has either all new files or
// the old ones.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace voluta::base {

// A hidden folder that is filled first. Files are written into path() and folders in it; commit()
// moves each of them into `target` by rename (creating folders that are missing; other files and
// folders are kept).
// Without commit() the destructor removes them and `target` is unchanged.
//
// The staging folder is beside the first folder above target that exists, so that renames stay on
// one file system; it is inside target if that is a separate file system (a USB stick) or the
// folder above it is not writable.
//
// A process killed at any moment leaves the old set or the new one. If there is no target yet, the
// staging folder itself becomes it, by one rename. Otherwise a journal in the staging folder marks
// the moment from which the new set is valid. While the files are being moved a note
// (kUnfinishedNote) is in the target, and the next call of finishStaged moves the rest.
class StagedFolder {
public:
  // First finishes an earlier interrupted commit. Throws Error{CannotWrite} if the target has no
  // name, is a file, or cannot be created or written.
  explicit StagedFolder(std::filesystem::path target);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_; }
  // Returns the files in `target` that commit() would replace.
  std::vector<std::filesystem::path> replaced() const;
  // Throws Error{CannotWrite}, also for a folder that has the name of a file; `target` is then
  // unchanged.
  void commit();
  // Does the destructor's work, for a process that must end at once. Does not throw.
  void discard() noexcept;

private:
  std::filesystem::path target_, staging_;
  int lock_ = -1; // Held while this process runs: a free lock shows that the process died
};

inline constexpr std::string_view kUnfinishedNote = "EXPORT-UNFINISHED.txt";

// Finishes sets for `target` that killed processes left behind, and removes those that were not yet
// valid; sets in use by another process are left alone. Returns whether a set was finished. Readers
// call it before they read a folder into which sets are written. Throws Error{CannotWrite} if the
// set cannot be moved; the old one is then restored.
bool finishStaged(const std::filesystem::path& target);

} // namespace voluta::base
