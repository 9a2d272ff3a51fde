// The filament that an extruder without its own is assumed to have.
#pragma once

#include <string_view>

namespace voluta::program {

inline constexpr double kFilamentDiameterMm = 1.75;
inline constexpr int kFilamentDecimals = 5; // of its length, mm
inline constexpr std::string_view kDiameterNote = "filament diameter ";

// mm2; mm3 a mm of filament.
double filamentArea(double diameterMm = kFilamentDiameterMm);

// A length of filament that a program counts on: what was drawn back comes out of no nozzle before
// it was returned.
class FilamentCount {
public:
  double mm() const { return mm_; }
  // It goes on to `mm`; so much comes out of the nozzle, mm.
  double to(double mm);
  // It is counted from `mm` on, though nothing moves.
  void set(double mm);
  double drawnBackMm() const { return farthestMm_ - mm_; }

private:
  double mm_ = 0.0, farthestMm_ = 0.0;
};

} // namespace voluta::program
