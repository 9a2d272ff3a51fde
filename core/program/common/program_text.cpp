#include "program/common/program_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace voluta::program {

namespace {
constexpr double kPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
} // namespace

void appendFixed(std::string& out, double value, int decimals, bool trim) {
  std::int64_t scaled = std::llround(value * kPowers[decimals]);
  if (scaled < 0) {
    out.push_back('-');
    scaled = -scaled;
  }
  char digits[24];
  int count = 0;
  for (; scaled > 0 || count <= decimals; scaled /= 10)
    digits[count++] = static_cast<char>('0' + scaled % 10);
  int last = 0; // digits below this one are trailing zeros
  if (trim)
    while (last < decimals && digits[last] == '0')
      ++last;
  for (int i = count - 1; i >= last; --i) {
    out.push_back(digits[i]);
    if (i == decimals && i > last)
      out.push_back('.');
  }
}

std::string fixedText(double value, int decimals) {
  std::string text;
  appendFixed(text, value, decimals, true);
  return text;
}

std::size_t findUnquoted(std::string_view text, std::string_view mark) {
  constexpr std::size_t kNone = std::string_view::npos;
  for (std::size_t from = 0;;) {
    const std::size_t at = text.find(mark, from), quote = text.substr(0, at).find('"', from);
    if (quote == kNone)
      return at;
    const std::size_t closing = text.find('"', quote + 1);
    if (closing == kNone)
      return kNone;
    from = closing + 1;
  }
}

double roundedTo(double value, int decimals) {
  return static_cast<double>(std::llround(value * kPowers[decimals])) / kPowers[decimals];
}

int decimalsFor(double value, int significantDigits) {
  const int magnitude = static_cast<int>(std::floor(std::log10(std::max(value, 1e-12))));
  return std::clamp(significantDigits - 1 - magnitude, 0, 9);
}

std::string identifierOf(std::string_view name) {
  std::string id;
  for (const char c : name.substr(0, std::min<std::size_t>(name.size(), 31)))
    id.push_back(isLetter(c) || isDigit(c) ? c : '_');
  if (id.empty() || isDigit(id.front()))
    id.insert(id.begin(), 'p');
  id.resize(std::min<std::size_t>(id.size(), 31));
  return id;
}

std::string joined(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces)
    text += piece;
  return text;
}

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && blank(text.back()))
    text.remove_suffix(1);
  return text;
}

namespace {
bool takeFormatted(std::string_view& text, double& value, std::chars_format format) {
  std::string_view rest = text;
  if (rest.size() > 1 && rest[0] == '+' && (isDigit(rest[1]) || rest[1] == '.'))
    rest.remove_prefix(1);
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value, format);
  if (error != std::errc() || !std::isfinite(value))
    return false;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  text = rest;
  return true;
}
} // namespace

std::optional<int> wholeNumber(double value, int minimum, int maximum) {
  if (!(value >= minimum && value <= maximum) || value != std::floor(value))
    return std::nullopt;
  return static_cast<int>(value);
}

std::optional<int> parseWholeNumber(std::string_view text, int minimum, int maximum) {
  double value = 0.0;
  if (!std::ranges::all_of(text, isDigit) || !parseNumber(text, value))
    return std::nullopt;
  return wholeNumber(value, minimum, maximum);
}

bool takeNumber(std::string_view& text, double& value) {
  return takeFormatted(text, value, std::chars_format::general);
}

bool takeDecimal(std::string_view& text, double& value) {
  return takeFormatted(text, value, std::chars_format::fixed);
}

bool parseNumber(std::string_view text, double& value) {
  return takeNumber(text, value) && text.empty();
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty())
    return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  ++number_;
  return true;
}

void Defects::add(std::size_t file, std::size_t line, base::Message reason) {
  if (list_.size() + 1 < kMaxDefects)
    list_.push_back({file, line, std::move(reason)});
  else if (list_.size() + 1 == kMaxDefects)
    list_.push_back({file, line, "further defects from here on are not listed"_text});
}

bool primes(const std::vector<std::string>& lines, std::size_t i) {
  constexpr std::size_t kLines = 4;
  const auto isRemark = [&](std::size_t k) { return trimmed(lines[k]).ends_with(" prime"); };
  if (lines[i].find("; prime") != std::string::npos)
    return true;
  for (std::size_t k = i; k-- > 0 && i - k <= kLines;)
    if (isRemark(k))
      return true;
  return false;
}

} // namespace voluta::program
