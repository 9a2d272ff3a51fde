#include "program/common/rounded_settings.h"

#include <array>
#include <cmath>

namespace voluta::program {

namespace {
constexpr std::array kSteps = {1.0, 1.2, 1.4, 1.7, 2.0, 2.4, 2.8,
                               3.4, 4.0, 4.8, 5.6, 6.7, 8.0, 10.0};
constexpr double kSlack = 1e-9; // a step maps to itself
} // namespace

double steppedUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : kSteps)
    if (step * decade * (1.0 + kSlack) >= value)
      return step * decade;
  return 10.0 * decade;
}

double steppedDown(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  double found = decade;
  for (const double step : kSteps)
    if (step * decade <= value * (1.0 + kSlack))
      found = step * decade;
  return found;
}

} // namespace voluta::program
