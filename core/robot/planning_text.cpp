#include "robot/planning_text.h"

#include <cctype>
#include <cstddef>

namespace voluta::robot {

namespace {

constexpr std::string_view kMember = "\"shape\"";

std::size_t pastSpace(std::string_view text, std::size_t at) {
  while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])))
    ++at;
  return at;
}

// Returns the position after the string that begins at `at`.
std::size_t pastString(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (text[at] == '\\')
      ++at;
  return at + 1;
}

} // namespace

std::string planningText(std::string_view text) {
  std::size_t comma = std::string_view::npos, from = comma;
  int depth = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"') {
      const std::size_t end = pastString(text, at), colon = pastSpace(text, end);
      if (depth == 1 && comma != std::string_view::npos &&
          text.substr(at, kMember.size()) == kMember && colon < text.size() && text[colon] == ':')
        from = comma;
      at = end;
      continue;
    }
    depth += c == '{' || c == '[';
    depth -= c == '}' || c == ']';
    const bool ends = (c == ',' && depth == 1) || (c == '}' && depth == 0);
    if (ends && from != std::string_view::npos) {
      // For the last member, the space before the closing brace is kept.
      std::size_t to = at;
      while (c == '}' && to > from && std::isspace(static_cast<unsigned char>(text[to - 1])))
        --to;
      return std::string(text.substr(0, from)) + std::string(text.substr(to));
    }
    if (c == ',' && depth == 1)
      comma = at;
    ++at;
  }
  return std::string(text);
}

} // namespace voluta::robot
