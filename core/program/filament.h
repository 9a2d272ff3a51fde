// Filament: the one that an extruder without its own is taken to have, and how hot a material is
// printed.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

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

// Between which a nozzle prints a material; makers' data sheets and what print heads stand.
std::pair<double, double> nozzleRange(std::string_view material);

// A usual nozzle temperature of a material, degrees C, assumed: a process says nothing about it.
std::optional<int> nozzleCelsius(std::string_view material);

} // namespace voluta::program
