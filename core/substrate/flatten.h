// Circles whose curvature changes from layer to layer: from a half cylinder towards a plane.
#pragma once

#include <limits>
#include <vector>

namespace voluta::substrate {

// A circle in a section across the cylinder's axis, its centre straight below its top; a plane
// where the radius is infinite. mm.
struct FlatteningCircle {
  double topMm = 0.0; // height of its highest point
  double radiusMm = std::numeric_limits<double>::infinity();

  bool isPlane() const { return radiusMm == std::numeric_limits<double>::infinity(); }
  double centreMm() const { return topMm - radiusMm; } // height; not of a plane
};

// `layers` + 1 circles from `start` outwards: each layer is topThicknessMm thick at the top and
// sideThicknessMm at the polar angle sideAngle of the circle below it (radians from the horizontal,
// in (0, pi/2)), measured along that circle's radius (Castelli 2020, 5.2.3). The published rule,
// for tests to hold levels to; plans go by flatteningToPlane. Preconditions: a start that is no
// plane, positive thicknesses, layers >= 0. Throws Error{UnusableInput} naming the layer after
// which no such circle exists.
std::vector<FlatteningCircle> flatteningCircles(const FlatteningCircle& start,
                                                double topThicknessMm, double sideThicknessMm,
                                                double sideAngle, int layers);

// `layers` + 1 circles from `start` to one of endRadiusMm, a plane unless it is given: heights over
// the chord of half width halfChordMm change by equal steps, while the top rises by topThicknessMm
// a layer. At the chord's ends layers are (change of height over the chord) / layers thicker than
// at the top, upwards. Preconditions: a start that is no plane, topThicknessMm > 0, layers >= 1.
// Throws Error{UnusableInput} where the chord is wider than either circle.
std::vector<FlatteningCircle>
flatteningToPlane(const FlatteningCircle& start, double halfChordMm, double topThicknessMm,
                  int layers, double endRadiusMm = std::numeric_limits<double>::infinity());

// From the first circle to the second along the first one's radius at polar angle `alpha` (radians
// from the horizontal; the top is at pi/2), mm (Castelli 2020, 5.2.3). NaN where that never meets
// the second. Precondition: `from` is no plane.
double thicknessAt(const FlatteningCircle& from, const FlatteningCircle& to, double alpha);

} // namespace voluta::substrate
