#include "program/filament.h"

#include "base/units.h"

#include <algorithm>

namespace voluta::program {

double filamentArea(double diameterMm) {
  return base::kPi / 4.0 * diameterMm * diameterMm;
}

double FilamentCount::to(double mm) {
  mm_ = mm;
  const double out = std::max(0.0, mm_ - farthestMm_);
  farthestMm_ += out;
  return out;
}

void FilamentCount::set(double mm) {
  farthestMm_ += mm - mm_;
  mm_ = mm;
}

std::pair<double, double> nozzleRange(std::string_view material) {
  if (material == "PLA")
    return {170.0, 250.0};
  if (material == "PETG")
    return {200.0, 280.0};
  if (material == "ABS")
    return {200.0, 290.0};
  return {100.0, 450.0};
}

std::optional<int> nozzleCelsius(std::string_view material) {
  if (material == "PLA")
    return 210;
  if (material == "PETG")
    return 240;
  if (material == "ABS")
    return 245;
  return std::nullopt;
}

} // namespace voluta::program
