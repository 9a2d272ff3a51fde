#include "geometry/formats/text_scanner.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

namespace voluta::geometry {

std::optional<double> numberOf(std::string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size())
    return std::nullopt;
  if (error == std::errc::result_out_of_range)
    return std::numeric_limits<double>::infinity();
  return error == std::errc{} ? std::optional(value) : std::nullopt;
}

std::optional<long long> integerOf(std::string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || end != word.data() + word.size() || error != std::errc{})
    return std::nullopt;
  return value;
}

bool LineScanner::nextLine(std::vector<std::string_view>& words) {
  words.clear();
  if (at_ >= text_.size())
    return false;
  std::size_t end = at_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r')
    ++end;
  std::string_view rest = text_.substr(at_, end - at_);
  const bool isPair = text_.substr(end, 2) == "\r\n";
  at_ = std::min(end + (isPair ? 2 : 1), text_.size());
  ++line_;
  rest = rest.substr(0, rest.find('#'));
  const auto blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  for (auto it = rest.begin(); it != rest.end();) {
    it = std::find_if_not(it, rest.end(), blank);
    const auto last = std::find_if(it, rest.end(), blank);
    if (it != last)
      words.emplace_back(it, last);
    it = last;
  }
  return true;
}

bool LineScanner::nextFilledLine(std::vector<std::string_view>& words) {
  while (nextLine(words))
    if (!words.empty())
      return true;
  return false;
}

} // namespace voluta::geometry
