// A circular arc through three points, as robot controllers and G-code interpolate it at constant
// speed.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::program {

struct Arc {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(); // unit vector from the centre to the start
  Eigen::Vector3d v = Eigen::Vector3d::UnitY(); // unit vector, direction of motion at the start
  double radiusMm = 0.0;
  double sweepRad = 0.0; // > 0

  double lengthMm() const { return radiusMm * sweepRad; }
  // Return the point at `angleRad` from the start, and the unit direction of motion there.
  Eigen::Vector3d at(double angleRad) const;
  Eigen::Vector3d directionAt(double angleRad) const;
  // Returns the angle of a point's projection from the start, in (-pi, pi].
  double angleOf(const Eigen::Vector3d& point) const;
  // Returns the distance of a point from the circle.
  double distanceMm(const Eigen::Vector3d& point) const;
};

// Returns the arc from `from` via `via` to `to`; nullopt if the points are on a line or coincide.
std::optional<Arc> arcThrough(const Eigen::Vector3d& from, const Eigen::Vector3d& via,
                              const Eigen::Vector3d& to);

// Returns the arc about `centre` from `from` to `to` in the plane normal to `axis`,
// counterclockwise about it; a whole circle if both ends coincide. nullopt if the radius is 0.
// The end's own distance from the centre is ignored.
std::optional<Arc> arcAbout(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis,
                            const Eigen::Vector3d& from, const Eigen::Vector3d& to);

// Returns points at equal steps along the arc, without its ends, such that chords between
// neighbours are within 0.0005 mm of it.
std::vector<Eigen::Vector3d> pointsAlong(const Arc& arc);

} // namespace voluta::program
