// Words and numbers of a text file, a line at a time.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// The number that `word` is, whole, in any locale; beyond double's range infinity.
std::optional<double> numberOf(std::string_view word);
std::optional<long long> integerOf(std::string_view word);

// Hands out the lines of a text cut into words (white space between), without what follows '#'.
// Lines end with LF, CR or both.
class LineScanner {
public:
  explicit LineScanner(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  // The next line, blank or not; false at the end.
  bool nextLine(std::vector<std::string_view>& words);
  // The next line that has words; false at the end.
  bool nextFilledLine(std::vector<std::string_view>& words);
  int line() const { return line_; }           // of the last one handed out, from 1
  std::size_t position() const { return at_; } // of the byte after it

private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 0;
};

} // namespace voluta::geometry
