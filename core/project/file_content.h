// A file among the options of a stage, compared by its content.
#pragma once

#include <string>

namespace voluta::project {

struct FileContent {
  std::string path; // empty: none
};
// For base::keyText(). Does not throw: an unreadable file has a key that names its path.
std::string keyOf(const FileContent& file);

} // namespace voluta::project
