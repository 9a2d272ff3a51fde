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

} // namespace voluta::program
