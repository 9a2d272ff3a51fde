#include "program/krl/krl_externals.h"

#include "base/units.h"
#include "program/krl/krl.h"
#include "program/rapid/rapid_tokens.h"

#include <cmath>
#include <string>

namespace voluta::program {

namespace {
constexpr double kMax = 1e7; // degrees, mm
} // namespace

std::optional<base::Message> KrlExternals::take(const KrlValue& target, bool rotatesBase,
                                                plan::ProgramMotion& motion) {
  const std::optional<std::size_t> own = extruder();
  const std::size_t carrying = underRobot();
  for (std::size_t k = 0; k < at_.size(); ++k) {
    const auto value = krlNumber(target, kKrlExternal[k]);
    if (k == own && !value)
      return "the extruder's axis is missing"_text;
    if (!value)
      continue;
    if (!(std::abs(*value) <= kMax))
      return "an external axis far outside any limit"_text;
    if (!rotatesBase && k >= carrying && k != own && at_[k] && *at_[k] != *value)
      return "an external axis that moves no work object is not supported"_text;
    at_[k] = value;
  }
  if (rotatesBase && (!at_[0] || own == std::size_t{0}))
    return "E1 is missing: an external axis moves the base"_text;
  const std::size_t limit = rotatesBase ? at_.size() : carrying;
  for (std::size_t k = 0; k < limit && at_[k] && k != own; ++k)
    motion.externals.push_back(base::degreesToRadians(*at_[k]));
  if (motion.externals.size() < carrying)
    return "an axis that carries the robot is missing"_text;
  return std::nullopt;
}

std::size_t KrlExternals::underRobot() const {
  const auto number = variables_.number(inSmallLetters(kKrlUnderRobot));
  return number && *number >= 1.0 && *number <= 6.0 ? static_cast<std::size_t>(*number) : 0;
}

std::optional<std::size_t> KrlExternals::extruder() const {
  const auto number = variables_.number(inSmallLetters(kKrlExtruder));
  if (!number || !(*number >= 1.0 && *number <= 6.0))
    return std::nullopt;
  return static_cast<std::size_t>(*number) - 1;
}

double KrlExternals::extruderMm() const {
  return at_[extruder().value()].value_or(0.0);
}

double KrlExternals::extruderPercent() const {
  return variables_.number("$vel_extax[" + std::to_string(*extruder() + 1) + "]").value_or(100.0);
}

bool KrlExternals::extruderIsSlowed() const {
  return extruderPercent() < 100.0;
}

void KrlExternals::zeroExtruder() {
  if (const auto own = extruder())
    at_[*own] = 0.0;
}

std::optional<double> KrlExternals::extruderAlone(const KrlValue& target) const {
  const auto own = extruder();
  return own && target.numbers.size() == 1 ? krlNumber(target, kKrlExternal[*own]) : std::nullopt;
}

std::optional<double> KrlExternals::feed(double mm) {
  const double percent = extruderPercent(), distance = std::abs(mm - extruderMm());
  if (!(std::abs(mm) <= kMax) || !(percent > 0.0 && percent <= 100.0))
    return std::nullopt;
  at_[*extruder()] = mm;
  return distance / (kKrlExtruderMmPerS * percent / 100.0);
}

} // namespace voluta::program
