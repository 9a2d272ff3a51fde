#include "base/filled_file.h"

#include "base/error.h"
#include "base/files.h"

namespace voluta::base {

std::string readFilledFile(const std::filesystem::path& path) {
  std::string bytes = readFile(path);
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
    throw Error(ErrorCode::UnreadableFile, "the file is empty"_text, path.string());
  return bytes;
}

} // namespace voluta::base
