#include "base/staged_folder.h"

#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace voluta::base {

namespace fs = std::filesystem;

namespace {
constexpr const char* kJournal = ".journal";
constexpr const char* kReplaced = ".replaced";
constexpr const char* kNote = ".note"; // Stored as kUnfinishedNote in the target
constexpr std::string_view kNoteText =
    "An export into this folder was broken off: its files may be of two exports.\n"
    "Do not run them. Export again, or open or verify one of them with Voluta: either\n"
    "makes the set whole, and this note goes away.\n";

Error cannotWrite(const fs::path& path, const Value& why) {
  return Error(ErrorCode::CannotWrite, message("cannot be written: {why}"_text, why),
               path.string());
}

bool isThere(const fs::path& path) {
  std::error_code status;
  return fs::exists(fs::symlink_status(path, status));
}

bool isFolder(const fs::path& path) {
  std::error_code status;
  return fs::is_directory(fs::symlink_status(path, status));
}

// Returns the first folder at or above `path` that exists; for a target "a/b" without "a" that is
// ".".
fs::path existingFolder(fs::path path) {
  while (!path.empty() && !isThere(path))
    path = path.parent_path();
  return path.empty() ? fs::path(".") : path;
}

fs::path wholePath(const fs::path& target) {
  fs::path whole = fs::absolute(target).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// Returns the candidate staging folders for `target`; the first usable one is taken.
std::vector<fs::path> stagingPlaces(const fs::path& target) {
  const fs::path standing = existingFolder(target);
  if (standing != target)
    return {standing};
  struct stat here {
  }, above{};
  const fs::path parent = target.parent_path();
  const bool own = ::stat(target.c_str(), &here) == 0 && ::stat(parent.c_str(), &above) == 0 &&
                   here.st_dev != above.st_dev;
  return own ? std::vector{target} : std::vector{parent, target};
}

std::string stagingPrefix(const fs::path& target) {
  return fmt::format(".{}.voluta-", target.filename().string());
}

// Returns -1 if another process is using the folder.
int lockOf(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    return descriptor;
  ::close(descriptor);
  return -1;
}

void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  ::fsync(descriptor); // Not every file system supports this
  ::close(descriptor);
}

// The staged set on its way into its folder. Each step can be repeated, so an interrupted move is
// continued.
class Set {
public:
  Set(const fs::path& staging, const fs::path& target) : staging_(staging), target_(target) {}

  // Throws Error{CannotWrite} if a file cannot be moved; the files moved before it are then moved
  // back.
  void moveIn(const std::vector<std::string>& names) const {
    for (const std::string& name : names)
      if (const std::error_code failed = put(name)) {
        for (auto back = names.rbegin(); back != names.rend(); ++back)
          putBack(*back);
        throw cannotWrite(target_ / name, failed.message());
      }
    syncFolder(target_);
  }

private:
  std::error_code put(const std::string& name) const {
    const fs::path staged = staging_ / name, place = target_ / name,
                   old = staging_ / kReplaced / name;
    std::error_code status;
    if (!isThere(staged))
      return status; // It is in its place already
    fs::create_directories(place.parent_path(), status);
    if (status)
      return status;
    if (isFolder(place))
      return std::make_error_code(std::errc::is_a_directory);
    if (isThere(place) && !isThere(old)) {
      fs::create_directories(old.parent_path(), status);
      if (status)
        return status;
      // A file keeps its name until the new one has it; some file systems do not support this.
      if (::link(place.c_str(), old.c_str()) != 0)
        fs::rename(place, old, status);
      if (status)
        return status;
    }
    fs::rename(staged, place, status);
    return status;
  }
  void putBack(const std::string& name) const {
    const fs::path staged = staging_ / name, place = target_ / name,
                   old = staging_ / kReplaced / name;
    std::error_code ignored;
    if (isFolder(place))
      return; // It was there before
    if (!isThere(staged) && !isThere(old))
      fs::rename(place, staged, ignored);
    if (isThere(old))
      fs::rename(old, place, ignored);
  }

  fs::path staging_, target_;
};

// Returns the files in a folder and the folders in it, relative to it, sorted.
std::vector<std::string> filesIn(const fs::path& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (!isFolder(entry.path()))
      files.push_back(entry.path().lexically_relative(folder).string());
  std::sort(files.begin(), files.end());
  return files;
}

// Returns the target, then the files to move into it, relative to it.
std::string journalText(const fs::path& target, const std::vector<std::string>& names) {
  std::string text = target.string() + '\n';
  for (const std::string& name : names)
    text += name + '\n';
  return text;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    lines.push_back(text.substr(at, end - at));
  return lines;
}

// While the journal exists, the new set is the valid one.
void carryOut(const fs::path& staging, const fs::path& target,
              const std::vector<std::string>& names) {
  const fs::path note = target / kUnfinishedNote;
  std::error_code ignored;
  try {
    fs::rename(staging / kNote, note, ignored);
    Set(staging, target).moveIn(names);
  } catch (const Error&) {
    fs::remove(note, ignored);
    fs::remove(staging / kJournal, ignored);
    throw;
  }
  fs::remove(note, ignored);
  fs::remove(staging / kJournal, ignored);
}

} // namespace

StagedFolder::StagedFolder(fs::path target) {
  if (target.empty())
    throw Error(ErrorCode::CannotWrite, "the name of the folder is empty"_text, {},
                "name a folder for the results"_text);
  target_ = wholePath(target);
  std::error_code status;
  if (fs::is_directory(target_, status) && ::access(target_.c_str(), W_OK | X_OK) != 0)
    throw cannotWrite(target_, std::string(std::strerror(errno)));
  const fs::path standing = existingFolder(target_);
  if (!fs::is_directory(standing, status))
    throw cannotWrite(standing, "it is a file, not a folder"_text);
  finishStaged(target_);
  int code = 0;
  for (const fs::path& place : stagingPlaces(target_)) {
    std::string pattern = (place / (stagingPrefix(target_) + "XXXXXX")).string();
    if (::mkdtemp(pattern.data())) {
      staging_ = pattern;
      lock_ = lockOf(staging_);
      return;
    }
    code = code == 0 ? errno : code;
  }
  throw cannotWrite(target_, std::string(std::strerror(code)));
}

StagedFolder::~StagedFolder() {
  discard();
  if (lock_ >= 0)
    ::close(lock_);
}

void StagedFolder::discard() noexcept {
  // Another thread may still be writing; it does not find the folder under the other name.
  const fs::path gone = staging_.string() + "-gone";
  std::error_code moved, ignored;
  fs::rename(staging_, gone, moved);
  fs::remove_all(moved ? staging_ : gone, ignored);
}

std::vector<fs::path> StagedFolder::replaced() const {
  std::vector<fs::path> files;
  for (const std::string& name : filesIn(staging_))
    if (isThere(target_ / name))
      files.push_back(target_ / name);
  return files;
}

void StagedFolder::commit() {
  std::error_code status;
  const std::vector<std::string> names = filesIn(staging_);
  for (const std::string& name : names)
    if (isFolder(target_ / name))
      throw cannotWrite(target_ / name, "it is a folder"_text);
  if (!isThere(target_)) {
    fs::create_directories(target_.parent_path(), status);
    if (status)
      throw cannotWrite(target_, status.message());
    // Folders made by mkdtemp are accessible to their owner only.
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::chmod(staging_.c_str(), 0777 & ~mask);
    syncFolder(staging_);
    fs::rename(staging_, target_, status);
    if (status)
      throw cannotWrite(target_, status.message());
    syncFolder(target_.parent_path());
    return;
  }
  writeFile(staging_ / kNote, kNoteText);
  syncFolder(staging_);
  writeFile(staging_ / kJournal, journalText(target_, names));
  syncFolder(staging_);
  carryOut(staging_, target_, names);
}

bool finishStaged(const fs::path& given) {
  const fs::path target = wholePath(given);
  std::vector<fs::path> left;
  std::error_code status;
  for (const fs::path& place : stagingPlaces(target))
    for (const auto& entry : fs::directory_iterator(place, status))
      if (entry.path().filename().string().starts_with(stagingPrefix(target)) &&
          isFolder(entry.path()))
        left.push_back(entry.path());
  bool finished = false;
  for (const fs::path& staging : left) {
    const int lock = lockOf(staging);
    if (lock < 0)
      continue;
    try {
      std::vector<std::string> lines;
      if (isThere(staging / kJournal))
        lines = linesOf(readFile(staging / kJournal));
      if (!lines.empty() && lines.front() == target.string() && isFolder(target)) {
        lines.erase(lines.begin());
        carryOut(staging, target, lines);
        finished = true;
      }
    } catch (const Error&) {
      fs::remove_all(staging, status);
      ::close(lock);
      throw;
    }
    fs::remove_all(staging, status);
    ::close(lock);
  }
  return finished;
}

} // namespace voluta::base
