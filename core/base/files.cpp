#include "base/files.h"

#include "base/error.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace voluta::base {

namespace fs = std::filesystem;

namespace {
Error cannotWrite(const fs::path& path, const Value& why) {
  return Error(ErrorCode::CannotWrite, message("cannot be written: {why}"_text, why),
               path.string());
}

std::string systemReason(int code) {
  return std::strerror(code);
}

// The first folder at or above `path` that exists; for a target "a/b" without "a" that is ".".
fs::path existingFolder(fs::path path) {
  std::error_code status;
  while (!path.empty() && !fs::exists(path, status))
    path = path.parent_path();
  return path.empty() ? fs::path(".") : path;
}

} // namespace

std::string readFile(const fs::path& path) {
  std::error_code status;
  if (!fs::exists(path, status))
    throw Error(ErrorCode::UnreadableFile, "no such file"_text, path.string());
  if (fs::is_directory(path, status))
    throw Error(ErrorCode::UnreadableFile, "is a directory, not a file"_text, path.string());
  // A device or a pipe may never end.
  if (!fs::is_regular_file(path, status))
    throw Error(ErrorCode::UnreadableFile, "is no ordinary file, but a device or a pipe"_text,
                path.string(), "copy it to a file first"_text);
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw Error(ErrorCode::UnreadableFile,
                message("cannot be read: {why}"_text, systemReason(errno)), path.string());
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (in.bad())
    throw Error(ErrorCode::UnreadableFile, "cannot be read to its end"_text, path.string());
  return std::move(bytes).str();
}

void writeFile(const fs::path& path, std::string_view bytes) {
  const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
  std::string temporary = (folder / fmt::format(".{}.XXXXXX", path.filename().string())).string();
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0)
    throw cannotWrite(path, systemReason(errno));
  const auto giveUp = [&](int code) {
    ::close(descriptor);
    ::unlink(temporary.c_str());
    throw cannotWrite(path, systemReason(code));
  };
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR)
      continue;
    if (n < 0)
      giveUp(errno);
    done += static_cast<std::size_t>(n);
  }
  if (::fsync(descriptor) != 0)
    giveUp(errno);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, 0666 & ~mask);
  if (::close(descriptor) != 0 || ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int code = errno;
    ::unlink(temporary.c_str());
    throw cannotWrite(path, systemReason(code));
  }
}

StagedFolder::StagedFolder(fs::path target) : target_(fs::absolute(target).lexically_normal()) {
  if (!target_.has_filename())
    target_ = target_.parent_path();
  std::error_code status;
  if (fs::is_directory(target_, status) && ::access(target_.c_str(), W_OK | X_OK) != 0)
    throw cannotWrite(target_, systemReason(errno));
  const fs::path standing = existingFolder(target_);
  if (!fs::is_directory(standing, status))
    throw cannotWrite(standing, "it is a file, not a folder"_text);
  const fs::path beside = standing == target_ ? target_.parent_path() : standing;
  std::string pattern = (beside / fmt::format(".{}.XXXXXX", target_.filename().string())).string();
  if (!::mkdtemp(pattern.data()))
    throw cannotWrite(target_, systemReason(errno));
  staging_ = pattern;
}

StagedFolder::~StagedFolder() {
  discard();
}

void StagedFolder::discard() noexcept {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

void StagedFolder::commit() {
  std::error_code status;
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(staging_))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  fs::create_directories(target_, status);
  if (status)
    throw cannotWrite(target_, status.message());
  // What is replaced waits out of sight until all is in its place; discard() then takes it.
  std::string pattern = (staging_ / ".XXXXXX").string();
  if (!::mkdtemp(pattern.data()))
    throw cannotWrite(target_, systemReason(errno));
  const fs::path replaced = pattern;
  std::vector<fs::path> moved; // the latest last
  const auto giveUp = [&](const fs::path& place, const std::string& why) {
    std::error_code ignored;
    for (auto name = moved.rbegin(); name != moved.rend(); ++name) {
      fs::rename(target_ / *name, staging_ / *name, ignored);
      fs::rename(replaced / *name, target_ / *name, ignored);
    }
    throw cannotWrite(place, why);
  };
  for (const fs::path& entry : entries) {
    const fs::path name = entry.filename(), place = target_ / name;
    if (fs::exists(fs::symlink_status(place, status))) {
      fs::rename(place, replaced / name, status);
      if (status)
        giveUp(place, status.message());
    }
    moved.push_back(name);
    fs::rename(entry, place, status);
    if (status)
      giveUp(place, status.message());
  }
}

fs::path resourceFolder() {
  std::error_code status;
  const fs::path self = fs::read_symlink("/proc/self/exe", status);
  const char* chosen = std::getenv("VOLUTA_RESOURCES");
  const fs::path folder =
      chosen ? fs::path(chosen) : self.parent_path().parent_path() / "share" / "voluta";
  if (!fs::is_directory(folder, status))
    throw Error(ErrorCode::UnreadableFile, "the program's data folder is missing"_text,
                folder.string(), message("set {variable}"_text, "VOLUTA_RESOURCES"_name));
  return folder;
}

} // namespace voluta::base
