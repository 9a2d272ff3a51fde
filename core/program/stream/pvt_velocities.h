// Velocities at the points of a path for controllers that interpolate position, velocity and time
// (PVT): between two points each coordinate is the cubic with both values and velocities there
// (Hermite).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::program {

// Position in mm, orientation coordinates in degrees.
using PvtVector = Eigen::Matrix<double, 6, 1>;

// One motion: the change of the coordinates and its duration in seconds (> 0).
struct PvtMotion {
  PvtVector displacement = PvtVector::Zero();
  double seconds = 0.0;
};

// Deviation of the cubic from uniform motion: lateral, for the first three coordinates [mm]; and
// the maximum along the path, as a share of its length (0 if it has none).
struct PvtDeviation {
  double acrossMm = 0.0;
  double alongShare = 0.0;
};
PvtDeviation pvtDeviation(const PvtMotion& motion, const PvtVector& from, const PvtVector& to);

// Returns whether the angle k stays close to its uniform rotation with these velocities at both
// ends [degrees/s]. True for all velocities of pvtVelocity() and for 0.
bool pvtTurnsEvenly(const PvtMotion& motion, int k, double from, double to);

// How the stated velocity at the point between two motions fits that of pvtVelocity().
struct PvtFit {
  double statedMmPerS = 0.0, suitsMmPerS = 0.0;
  bool isSpeedSuitable = true, isDirectionSuitable = true; // the latter of the angles, too
  bool reverses = false; // position or angles go against the suitable velocity
};
PvtFit pvtFit(const PvtVector& stated, const PvtMotion& in, const PvtMotion& out,
              double toleranceMm);

// Returns the velocity at the point between two motions: that of the parabola through them, reduced
// if either motion would deviate from its line by more than `toleranceMm`, exceed its mean speed by
// more than half, or turn unevenly.
PvtVector pvtVelocity(const PvtMotion& in, const PvtMotion& out, double toleranceMm);

} // namespace voluta::program
