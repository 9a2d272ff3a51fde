// Queries of points and segments against a triangle or a segment.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace voluta::geometry {

// Returns the point of triangle abc nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
// Correct for degenerate triangles too.
Eigen::Vector3d closestPointOnTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b, const Eigen::Vector3d& c);

// Returns the distance of p from the segment ab, which may be a point.
double distanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b);

// Signed solid angle of abc seen from p, in (-2 pi, 2 pi]; positive if p is behind a
// counter-clockwise triangle (van Oosterom and Strackee 1983, eq. 8).
double solidAngle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                  const Eigen::Vector3d& c);

// A segment prepared for tests against many triangles.
class SegmentTest {
public:
  // Precondition: finite ends. A segment of length zero crosses nothing.
  SegmentTest(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

  // Returns the parameter t of the crossing with abc, in [0,1]; guarantees as in MeshQuery::hits.
  std::optional<double> cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                              const Eigen::Vector3d& c) const;
  // Returns whether the part of the segment with t in [0, tMax] may touch the box; never wrongly
  // false.
  bool mayTouch(const Eigen::Vector3d& low, const Eigen::Vector3d& high, double tMax) const;

private:
  Eigen::Vector3d shear(const Eigen::Vector3d& p) const;

  Eigen::Vector3d from_, step_, inverse_;
  int kx_ = 0, ky_ = 1, kz_ = 2;
  double sx_ = 0.0, sy_ = 0.0, sz_ = 0.0, pad_ = 0.0;
  bool point_ = false;
};

} // namespace voluta::geometry
