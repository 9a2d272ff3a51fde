// How a turned part would stand: what can be told from its facets alone.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::placement {

struct OrientationScore {
  double contactMm2 = 0.0; // of facets that face down within the contact depth, seen from above
  double riskyMm2 = 0.0;   // of facets that overhang by more than the angle, but for the contact
  double heightMm = 0.0;
  double middleMm = 0.0; // height of the volume's centre
  bool stands = false;   // the contact is at least kLeastContact of volume^(2/3)
};

// A ball as big as 100,000 voxels has 0.08 at a depth of one voxel, the tip of an ear 0.01.
inline constexpr double kLeastContact = 0.02;

class OrientationMeasure {
public:
  // contactDepthMm > 0: height above the plate up to which material counts as lying on it.
  // overhangRad: a facet of normal n is risky where n_z + sin(overhangRad) < 0 (RoboFDM, eq. 1).
  // Precondition (Error{Internal}): mesh not empty. It stays as it is while this is used.
  OrientationMeasure(const geometry::TriangleMesh& mesh, double contactDepthMm, double overhangRad);

  // Of the mesh turned by `turn` and put on the plate.
  OrientationScore of(const Eigen::Matrix3d& turn) const;
  const Eigen::Vector3d& centre() const { return centre_; }
  // Does it stay so by itself: is the volume's centre over the hull of the contact?
  bool balances(const Eigen::Matrix3d& turn) const;

  // A part that rests with the direction `down` (unit) down settles on what is flat there: the mean
  // normal of the contact's facets within a degree, where they are half of the contact or more;
  // else `down`.
  Eigen::Vector3d settled(const Eigen::Vector3d& down) const;

  // Outward normals of the mesh's largest flat places, the largest first, at most `most`; facets
  // within about two degrees of each other count as one.
  std::vector<Eigen::Vector3d> flatPlaces(std::size_t most) const;

private:
  // Along `up`, of each triangle's middle; and the least and most of any of them.
  struct Heights {
    std::vector<double> middle;
    double low, high;
  };
  Heights heights(const Eigen::Vector3d& up) const;

  const geometry::TriangleMesh& mesh_;
  double depth_, sine_, leastContact_;
  std::vector<Eigen::Vector3d> normal_; // times the facet's area
  Eigen::Vector3d centre_;              // of the volume
};

} // namespace voluta::placement
