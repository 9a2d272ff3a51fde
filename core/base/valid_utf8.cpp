#include "base/valid_utf8.h"

#include <algorithm>

namespace voluta::base {

namespace {
// Returns the number of bytes of the character at the beginning, which is no control character
// beyond ASCII; 0 if they are not UTF-8.
std::size_t characterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  if (length < 2 || length > text.size())
    return length > text.size() ? 0 : length;
  // Longer forms than necessary, halves of a pair, and numbers beyond the last character.
  const unsigned char least = first == 0xE0   ? 0xA0
                              : first == 0xF0 ? 0x90
                                              : 0x80,
                      most = first == 0xED   ? 0x9F
                             : first == 0xF4 ? 0x8F
                                             : 0xBF;
  if (byte(1) < least || byte(1) > most)
    return 0;
  for (std::size_t i = 2; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
  return first == 0xC2 && byte(1) < 0xA0 ? 0 : length;
}
} // namespace

std::string validText(std::string_view text, std::size_t maxLength) {
  std::string valid;
  valid.reserve(std::min(text.size(), maxLength));
  while (!text.empty()) {
    const std::size_t length = characterLength(text), taken = std::max<std::size_t>(1, length);
    if (valid.size() + taken > maxLength)
      break;
    if (length == 0)
      valid += '?';
    else
      valid += text.substr(0, length);
    text.remove_prefix(taken);
  }
  return valid;
}

} // namespace voluta::base
