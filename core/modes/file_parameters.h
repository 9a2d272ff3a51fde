// Text parameters that may name a file instead of saying everything themselves.
#pragma once

#include <string_view>
#include <vector>

namespace voluta::modes {

struct FileParameter {
  std::string_view key;
  std::string_view patterns; // of names, separated by blanks
  std::string_view prefix;   // stands before the name in the parameter's text
};

const std::vector<FileParameter>& fileParameters();

} // namespace voluta::modes
