// The place of a line of a program that is to be damaged, and the end of its own text.
#pragma once

#include "replay/mutations.h"

namespace voluta::test {

using Line = std::optional<std::size_t>; // 1-based

inline std::ptrdiff_t at(std::size_t line) { // 1-based
  return static_cast<std::ptrdiff_t>(line) - 1;
}
inline std::string& lineOf(Subject& s, std::size_t m) {
  return s.text.lines[s.read.motions.at(m).line - 1];
}
inline bool endsWithCr(const std::string& line) {
  return line.ends_with('\r');
}
inline std::size_t endOf(const std::string& line) {
  return line.size() - (endsWithCr(line) ? 1 : 0);
}
// `line` with the ends that the text's lines have.
inline std::string ended(const Subject& s, const std::string& line) {
  return !s.text.lines.empty() && endsWithCr(s.text.lines.front()) ? line + "\r" : line;
}

} // namespace voluta::test
