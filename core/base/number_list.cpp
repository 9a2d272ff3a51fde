#include "base/number_list.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace voluta::base {

bool readNumbers(std::string_view text, char separator, std::initializer_list<double*> values) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::size_t remaining = values.size();
  for (double* value : values) {
    const std::size_t length = --remaining > 0 ? text.find(separator) : text.size();
    if (length == std::string_view::npos)
      return false;
    std::string_view word = text.substr(0, length);
    word.remove_prefix(std::min(word.find_first_not_of(kBlanks), word.size()));
    word = word.substr(0, word.find_last_not_of(kBlanks) + 1);
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), *value);
    if (status != std::errc{} || end != word.data() + word.size() || !std::isfinite(*value))
      return false;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return true;
}

} // namespace voluta::base
