// Text parameters whose value may name a file.
#pragma once

#include <string_view>
#include <vector>

namespace voluta::modes {

struct FileParameter {
  std::string_view key;
  std::string_view patterns; // file name patterns, separated by blanks
  std::string_view prefix;   // precedes the file name in the parameter's text
};

const std::vector<FileParameter>& fileParameters();

} // namespace voluta::modes
