// A set of files that comes into a folder as a whole: all of it is there, or what was there before.
#pragma once

#include <filesystem>
#include <string_view>

namespace voluta::base {

// A folder filled out of sight. Files are written into path(); commit() moves each of them into
// `target` by rename (made with its parents where missing; what else it holds stays). Without it
// the destructor removes them and `target` is as it was.
//
// The staging folder is hidden: beside the first folder above target that exists, so that renames
// stay on one file system; inside target where that is a file system of its own (a stick) or what
// is above it cannot be written.
//
// A process that is killed at any moment leaves the old set or the new one. Where there is no
// target yet, the staging folder itself becomes it, by one rename. Else a journal in the staging
// folder says from when on the new set counts; while the files are being moved a note lies in the
// target (kUnfinishedNote), and whoever comes next, finishStaged, moves the rest.
class StagedFolder {
public:
  // Finishes what was broken off there before. Throws Error{CannotWrite}: the target is a file, or
  // cannot be made or written.
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
  int lock_ = -1; // held while this process lives: who finds it free knows that it died
};

inline constexpr std::string_view kUnfinishedNote = "EXPORT-UNFINISHED.txt";

// Finishes what processes that were killed left of sets for `target`, and removes what never came
// to count; leaves alone what a process is about. true: a set was finished. For readers: before
// they look into a folder that sets are written into. Throws Error{CannotWrite}: the set cannot be
// moved; then the old one is there again.
bool finishStaged(const std::filesystem::path& target);

} // namespace voluta::base
