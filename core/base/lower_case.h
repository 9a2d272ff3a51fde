// Small letters, for names that are compared regardless of case.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace voluta::base {

// Returns the text with its ASCII letters in lower case.
inline std::string lowerCase(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return small;
}

} // namespace voluta::base
