// Assessment of a part's orientation from its facets alone.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::placement {

struct OrientationScore {
  double contactMm2 = 0.0; // projected area of the facets that face down within the contact depth
  double riskyMm2 = 0.0;   // of facets that overhang by more than the angle, without the contact
  double heightMm = 0.0;
  double middleMm = 0.0; // height of the volume's centroid
  bool stands = false;   // the contact is at least kMinContact of volume^(2/3)
};

// For comparison: a ball of 100,000 voxels has 0.08 at a depth of one voxel, the tip of an ear
// 0.01.
inline constexpr double kMinContact = 0.02;

class OrientationMeasure {
public:
  // contactDepthMm > 0: height above the plate up to which facets count as contact. overhangRad: a
  // facet of normal n is risky if n_z + sin(overhangRad) < 0 (RoboFDM, eq. 1). Precondition
  // (Error{Internal}): mesh not empty. It must stay unchanged while this is used.
  OrientationMeasure(const geometry::TriangleMesh& mesh, double contactDepthMm, double overhangRad);

  // Returns the score of the mesh rotated by `rotation` and placed on the plate.
  OrientationScore of(const Eigen::Matrix3d& rotation) const;
  const Eigen::Vector3d& centre() const { return centre_; }
  // Returns whether the part is stable: the volume's centroid is above the hull of the contact.
  bool balances(const Eigen::Matrix3d& rotation) const;

  // Returns the direction that a part with the direction `down` (unit) down settles to on a flat
  // place: the mean normal of the contact's facets within a degree, if they are at least half of
  // the contact; else `down`.
  Eigen::Vector3d settled(const Eigen::Vector3d& down) const;

  // Returns outward normals of the mesh's largest flat places, largest first, at most `maxCount`;
  // facets within about two degrees of each other count as one place.
  std::vector<Eigen::Vector3d> flatPlaces(std::size_t maxCount) const;

private:
  // Along `up`: the height of each triangle's centroid, and the minimum and maximum height of the
  // mesh.
  struct Heights {
    std::vector<double> middle;
    double low, high;
  };
  Heights heights(const Eigen::Vector3d& up) const;

  const geometry::TriangleMesh& mesh_;
  double depth_, sine_, minContact_;
  std::vector<Eigen::Vector3d> normal_; // times the facet's area
  Eigen::Vector3d centre_;              // of the volume
};

} // namespace voluta::placement
