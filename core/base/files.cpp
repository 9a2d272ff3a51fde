#include "base/files.h"

#include "base/error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

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
} // namespace

std::string beginningOf(const fs::path& path, std::size_t count) {
  std::string bytes(count, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::string readFile(const fs::path& path) {
  std::error_code status;
  if (!fs::exists(path, status))
    throw Error(ErrorCode::UnreadableFile, "no such file"_text, path.string());
  if (fs::is_directory(path, status))
    throw Error(ErrorCode::UnreadableFile, "is a directory, not a file"_text, path.string());
  // Reading a device or a pipe might never end.
  if (!fs::is_regular_file(path, status))
    throw Error(ErrorCode::UnreadableFile, "is not a regular file, but a device or a pipe"_text,
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
  writeFile(path, std::span(&bytes, 1));
}

void writeFile(const fs::path& path, std::span<const std::string_view> parts) {
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
  for (std::string_view rest : parts)
    while (!rest.empty()) {
      const ssize_t n = ::write(descriptor, rest.data(), rest.size());
      if (n < 0 && errno == EINTR)
        continue;
      if (n < 0)
        giveUp(errno);
      rest.remove_prefix(static_cast<std::size_t>(n));
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
