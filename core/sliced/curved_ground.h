// Maps level tool-paths onto a cylinder or a sphere.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace voluta::sliced {

enum class GroundShape { Plate, Plane, Cylinder, Sphere };

// A ground whose highest point (lowest, if it is hollow) is the origin. Plate and plane leave
// points as they are.
struct CurvedGround {
  GroundShape shape = GroundShape::Plate;
  double radiusMm = 100.0;  // < 0: hollow, e.g. the inside of a cylinder. Not 0
  bool keepsAngles = false; // true: layers grow with the radius; false: lengths stay

  // Where a level point goes, and how lengths change there.
  struct Mapped {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity(); // Of directions
    // Lengths grow by `along` in the direction `axis` (level, unit), by `across` normal to it.
    Eigen::Vector2d axis = Eigen::Vector2d::UnitX();
    double along = 1.0, across = 1.0;
  };
  // z: height above the ground. The cylinder's axis is parallel to x: (x, y, z) goes to the angle
  // y / r about it at radius r = radiusMm + z; with keepsAngles the angle is y / radiusMm. On a
  // sphere the same holds for the distance from the z axis.
  Mapped map(const Eigen::Vector3d& level) const;
  // Returns the angle from the vertical [rad], >= 0.
  double angleAt(const Eigen::Vector3d& level) const;
  bool isCurved() const { return shape == GroundShape::Cylinder || shape == GroundShape::Sphere; }
};

// Returns the factor of a bead's hatch, i.e. of the distance to its neighbours, where it runs in
// the level direction `direction` (not zero).
double hatchFactor(const CurvedGround::Mapped& mapped, const Eigen::Vector2d& direction);

} // namespace voluta::sliced
