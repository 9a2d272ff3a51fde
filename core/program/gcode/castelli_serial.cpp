#include "program/gcode/castelli_serial.h"

#include "base/units.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace voluta::program {

namespace {
constexpr double kUsPerS = 1e6;

// Returns motor steps per mm³ of material: filament length per volume times steps per mm.
double stepsPerMm3() {
  return kCastelliStepsPerMm / (base::kPi / 4.0 * kCastelliFilamentMm * kCastelliFilamentMm);
}
} // namespace

long long castelliHalfPeriodUs(double mm3PerS) {
  const double steps = std::abs(mm3PerS) * stepsPerMm3();
  if (!(steps > 0.0))
    return 0;
  const long long us = std::max(1LL, std::llround(kUsPerS / (2.0 * steps)));
  return mm3PerS < 0.0 ? -us : us;
}

double castelliFlowMm3PerS(long long halfPeriodUs) {
  return halfPeriodUs == 0 ? 0.0
                           : kUsPerS / (2.0 * static_cast<double>(halfPeriodUs) * stepsPerMm3());
}

double castelliWritten(double mm3PerS) {
  return castelliFlowMm3PerS(castelliHalfPeriodUs(mm3PerS));
}

std::string castelliFlowText(double mm3PerS) {
  return joined({"G", std::to_string(castelliHalfPeriodUs(mm3PerS)), "n"});
}

std::string castelliFanText(double share) {
  return joined({"F", std::to_string(std::lround(share * kCastelliFullFan)), "n"});
}

std::string castelliHeatText(int celsius) {
  return joined({"M", std::to_string(celsius), "n"});
}

std::optional<CastelliCommand> readCastelli(std::string_view text) {
  CastelliCommand command;
  if (text.size() < 3 || text.size() > kCastelliMaxBytes || text.back() != 'n' ||
      std::string_view("GMTFR").find(text.front()) == std::string_view::npos)
    return std::nullopt;
  command.word = text.front();
  const std::string_view digits = text.substr(1, text.size() - 2);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), command.value);
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  if (!whole || (command.value < 0 && command.word != 'G'))
    return std::nullopt;
  return command;
}

} // namespace voluta::program
