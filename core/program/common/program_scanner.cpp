#include "program/common/program_scanner.h"

#include <cstddef>

namespace voluta::program {

namespace {
bool isNameStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isNamePart(char c) {
  return isNameStart(c) || (c >= '0' && c <= '9');
}
} // namespace

void TextScanner::blanks() {
  while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t'))
    rest.remove_prefix(1);
}

bool TextScanner::take(char c) {
  blanks();
  if (rest.empty() || rest.front() != c)
    return false;
  rest.remove_prefix(1);
  return true;
}

std::string_view TextScanner::name() {
  blanks();
  std::size_t n = 0;
  if (!rest.empty() && isNameStart(rest.front()))
    while (n < rest.size() && isNamePart(rest[n]))
      ++n;
  const std::string_view found = rest.substr(0, n);
  rest.remove_prefix(n);
  return found;
}

bool TextScanner::textBehindQuote(std::string_view& text) {
  const std::size_t end = rest.find('"');
  if (end == std::string_view::npos)
    return false;
  text = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return true;
}

bool TextScanner::ended() {
  blanks();
  return rest.empty();
}

} // namespace voluta::program
