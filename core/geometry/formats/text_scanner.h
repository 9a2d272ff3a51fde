// Reads words and numbers of a text file line by line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// Returns the number if the whole word is one, independent of the locale; infinity beyond double's
// range.
std::optional<double> numberOf(std::string_view word);
std::optional<long long> integerOf(std::string_view word);

// Splits the lines of a text into words separated by white space, without comments after '#'. Lines
// end with LF, CR or both.
class LineScanner {
public:
  explicit LineScanner(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  // Reads the next line, which may be empty; returns false at the end.
  bool nextLine(std::vector<std::string_view>& words);
  // Reads the next line that has words; returns false at the end.
  bool nextFilledLine(std::vector<std::string_view>& words);
  int line() const { return line_; }           // of the last line read, 1-based
  std::size_t position() const { return at_; } // of the byte after it

private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 0;
};

} // namespace voluta::geometry
