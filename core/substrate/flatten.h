// Circles whose curvature changes from layer to layer: from a half cylinder towards a plane.
#pragma once

#include <limits>
#include <vector>

namespace voluta::substrate {

// A circle in the cross-section of the cylinder, with its centre straight below its top; a plane if
// the radius is infinite [mm].
struct FlatteningCircle {
  double topMm = 0.0; // Height of its highest point
  double radiusMm = std::numeric_limits<double>::infinity();

  bool isPlane() const { return radiusMm == std::numeric_limits<double>::infinity(); }
  // Height of the centre; undefined for a plane
  double centreMm() const { return topMm - radiusMm; }
};

// Returns `layers` + 1 circles from `start` to a circle of endRadiusMm, by default a plane. Their
// heights over the chord of half width halfChordMm change in equal steps, while the top rises by
// topThicknessMm per layer. At the chord's ends, layers are (change of height over the chord) /
// layers thicker than at the top, measured vertically. Preconditions: `start` is not a plane,
// topThicknessMm > 0, layers >= 1. Throws Error{UnusableInput} if the chord is wider than either
// circle.
std::vector<FlatteningCircle>
flatteningToPlane(const FlatteningCircle& start, double halfChordMm, double topThicknessMm,
                  int layers, double endRadiusMm = std::numeric_limits<double>::infinity());

// Returns the distance [mm] from the first circle to the second along the first one's radius at
// polar angle `alpha` (radians from the horizontal; the top is at pi/2) (Castelli 2020, 5.2.3). NaN
// if the radius does not intersect the second circle. Precondition: `from` is not a plane.
double thicknessAt(const FlatteningCircle& from, const FlatteningCircle& to, double alpha);

} // namespace voluta::substrate
