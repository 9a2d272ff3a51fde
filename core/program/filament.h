// Filament assumed for extruders without their own.
#pragma once

#include <string_view>

namespace voluta::program {

inline constexpr double kFilamentDiameterMm = 1.75;
inline constexpr int kFilamentDecimals = 5; // of its length in mm
inline constexpr std::string_view kDiameterNote = "filament diameter ";

// Cross-section [mm2], i.e. mm3 per mm of filament.
double filamentArea(double diameterMm = kFilamentDiameterMm);

// Tracks a program's filament length: after a retraction no material leaves the nozzle until the
// filament is returned.
class FilamentCount {
public:
  double mm() const { return mm_; }
  // Moves it to `mm`; returns the length [mm] that leaves the nozzle.
  double to(double mm);
  // Sets the counter to `mm` without moving filament.
  void set(double mm);
  double drawnBackMm() const { return farthestMm_ - mm_; }

private:
  double mm_ = 0.0, farthestMm_ = 0.0;
};

} // namespace voluta::program
