// A file among the options of a stage: what counts is what it holds.
#pragma once

#include <string>

namespace voluta::project {

struct FileContent {
  std::string path; // empty: none
};
// For base::keyText(). Throws nothing: a file that cannot be read counts as such.
std::string keyOf(const FileContent& file);

} // namespace voluta::project
