// Velocities at the points of a path that a controller runs through by position, velocity and time
// (PVT): between two points each coordinate is the cubic that has both values and velocities there
// (Hermite).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voluta::program {

// Position in mm, and whatever turns in degrees.
using PvtVector = Eigen::Matrix<double, 6, 1>;

// One motion: what changes, and its seconds (> 0).
struct PvtMotion {
  PvtVector way = PvtVector::Zero();
  double seconds = 0.0;
};

// How far the cubic leaves the even motion: across the way of the first three coordinates, mm; and
// the largest difference along it, by share of the way (0 where there is none).
struct PvtDeviation {
  double acrossMm = 0.0;
  double alongShare = 0.0;
};
PvtDeviation pvtDeviation(const PvtMotion& motion, const PvtVector& from, const PvtVector& to);

// Does coordinate k, an angle, stay near its even turn with these velocities at both ends, degrees
// a second? True of all velocities below and of 0.
bool pvtTurnsEvenly(const PvtMotion& motion, int k, double from, double to);

// The velocity at the point between two motions: their parabola's, less where one of them would
// leave its line by more than `toleranceMm`, run at more than half as fast again as it should or
// turn unevenly.
PvtVector pvtVelocity(const PvtMotion& in, const PvtMotion& out, double toleranceMm);

} // namespace voluta::program
