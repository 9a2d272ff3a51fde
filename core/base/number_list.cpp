#include "base/number_list.h"

#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace voluta::base {

namespace {
std::vector<double> readRow(std::string_view line, const Message& place) {
  constexpr std::string_view kBetween = ",; \t\r";
  line = line.substr(0, line.find('#'));
  std::vector<double> row;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(kBetween), line.size()));
    if (line.empty())
      return row;
    const std::string_view word = line.substr(0, line.find_first_of(kBetween));
    double value = 0.0;
    const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (status != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      throw Error(ErrorCode::UnusableInput, message("'{word}' is not a number"_text, word), place);
    row.push_back(value);
    line.remove_prefix(word.size());
  }
}
} // namespace

std::vector<std::vector<double>> readRows(std::string_view text, std::string_view source) {
  std::vector<std::vector<double>> rows;
  for (long long line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const Message place = lineOf(source, line);
    std::vector<double> row = readRow(text.substr(0, end), place);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.empty())
      continue;
    if (!rows.empty() && row.size() != rows.front().size())
      throw Error(ErrorCode::UnusableInput,
                  message("{found} numbers in a row instead of {wanted} as in the first"_text,
                          row.size(), rows.front().size()),
                  place);
    rows.push_back(std::move(row));
  }
  return rows;
}

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
