#include "record/table.h"

#include "base/error.h"
#include "base/lower_case.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace voluta::record {

namespace {

// A table with commas may have blanks in its names: only the first kind that occurs separates.
char separatorOf(std::string_view line) {
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != std::string_view::npos)
      return separator;
  return ' ';
}

std::string_view trimmed(std::string_view word) {
  constexpr std::string_view kAround = " \t\r\"\xEF\xBB\xBF";
  word.remove_prefix(std::min(word.find_first_not_of(kAround), word.size()));
  return word.substr(0, word.find_last_not_of(kAround) + 1);
}

std::vector<std::string_view> wordsOf(std::string_view line, char separator) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(separator), line.size());
    const std::string_view word = trimmed(line.substr(0, end));
    if (separator != ' ' || !word.empty())
      words.push_back(word);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  if (!words.empty() && words.back().empty()) // A separator at the end of the line
    words.pop_back();
  return words;
}

double numberOf(std::string_view word) {
  double value = 0.0;
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  return status == std::errc{} && end == word.data() + word.size() && std::isfinite(value)
             ? value
             : std::numeric_limits<double>::quiet_NaN();
}

[[noreturn]] void refuse(const base::Message& why, std::string_view source, long long line) {
  throw base::Error(base::ErrorCode::UnusableInput, why, base::lineOf(source, line));
}

} // namespace

std::optional<std::size_t> Table::column(std::initializer_list<std::string_view> anyOf) const {
  for (const std::string_view wanted : anyOf)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (base::lowerCase(names[i]) == base::lowerCase(wanted))
        return i;
  return std::nullopt;
}

std::vector<std::size_t> Table::columns(std::string_view prefix, std::string_view suffix) const {
  for (const int first : {0, 1}) {
    std::vector<std::size_t> found;
    while (const auto at = column({std::string(prefix) +
                                   std::to_string(first + static_cast<int>(found.size())) +
                                   std::string(suffix)}))
      found.push_back(*at);
    if (!found.empty())
      return found;
  }
  return {};
}

double Table::at(std::size_t row, std::size_t column) const {
  const double value = rows[row][column];
  if (std::isnan(value))
    refuse(base::message("no number in column '{column}'"_text, names[column]), source, lines[row]);
  return value;
}

Table readTable(std::string_view text, std::string_view source) {
  Table table;
  table.source = source;
  char separator = ' ';
  bool cutShort = false;
  for (long long line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const bool isLast = end >= text.size();
    const std::string_view content = text.substr(0, std::min(text.substr(0, end).find('#'), end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (trimmed(content).empty())
      continue;
    if (table.names.empty()) {
      separator = separatorOf(content);
      for (const std::string_view word : wordsOf(content, separator))
        table.names.emplace_back(word);
      continue;
    }
    const std::vector<std::string_view> words = wordsOf(content, separator);
    if (words.size() != table.names.size()) {
      cutShort = isLast && words.size() < table.names.size();
      if (!cutShort)
        refuse(base::message("{found} values in a row instead of {wanted}, as there are names"_text,
                             words.size(), table.names.size()),
               source, line);
      continue;
    }
    std::vector<double>& row = table.rows.emplace_back();
    for (const std::string_view word : words)
      row.push_back(numberOf(word));
    table.lines.push_back(line);
  }
  if (table.rows.empty())
    throw base::Error(base::ErrorCode::UnusableInput,
                      "no rows of numbers below a row of names"_text, std::string(source));
  return table;
}

} // namespace voluta::record
