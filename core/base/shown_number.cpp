#include "base/shown_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <string>

namespace voluta::base {

ShownNumber shownNumber(double value, int digits) {
  constexpr double kMin = 1e-9;
  digits = std::max(digits, 1);
  if (!std::isfinite(value))
    return {value, 0};
  if (std::abs(value) < kMin)
    return {};
  // Formatted as "3.48e+03", because the library rounds and gives the exponent after rounding.
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  const std::size_t point = std::min(text.find('.'), e);
  const std::size_t last = text.find_last_not_of("0.", e - 1);
  const int significant =
      last == std::string::npos || last < point ? 0 : static_cast<int>(last - point);
  int exponent = 0;
  std::from_chars(text.data() + e + (text[e + 1] == '+' ? 2 : 1), text.data() + text.size(),
                  exponent);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return {rounded, std::max(0, significant - exponent)};
}

double roundedBeyond(double value, double limit, int decimals) {
  constexpr double kOnGrid = 1e-6;
  const double scale = std::pow(10.0, decimals);
  const double rounded = std::round(value * scale) / scale;
  if (value < limit && rounded >= limit)
    return (std::ceil(limit * scale - kOnGrid) - 1.0) / scale;
  if (value > limit && rounded <= limit)
    return (std::floor(limit * scale + kOnGrid) + 1.0) / scale;
  return rounded;
}

} // namespace voluta::base
