#include "project/file_content.h"

#include "base/error.h"
#include "base/files.h"
#include "project/content_hash.h"

namespace voluta::project {

std::string keyOf(const FileContent& file) {
  if (file.path.empty())
    return {};
  try {
    return "file " + contentHash(base::readFile(file.path));
  } catch (const base::Error&) {
    return "unreadable " + file.path;
  }
}

} // namespace voluta::project
