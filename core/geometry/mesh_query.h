// Distance, inside and intersection queries of points and segments against a fixed mesh.
#pragma once

#include "geometry/far_field.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

namespace voluta::geometry {

// Spatial queries on a mesh that does not change. Copies the data it needs; every query is const
// and safe from many threads at once, with results independent of the number of threads. Works on
// any triangle soup: connectivity is not used. Queries on an empty mesh find nothing, and every
// point is outside.
class MeshQuery {
public:
  // Builds a bounding volume hierarchy (binned surface area heuristic), O(n log n). Kind of mesh: a
  // Surface, which encloses nothing, has no winding number, and so neither inside() nor
  // signedDistance() (Error{Internal}).
  enum class Of { Solid, Surface };
  // Precondition (Error{Internal}): indices in range, coordinates finite.
  explicit MeshQuery(const TriangleMesh& mesh, Of what = Of::Solid);

  struct Closest {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();           // on the mesh, mm
    int triangle = -1;                                         // -1: none within
    double distance = std::numeric_limits<double>::infinity(); // mm; infinite if none
  };
  // Returns the nearest point of the mesh within maxDistance (mm, inclusive).
  Closest closest(const Eigen::Vector3d& p,
                  double maxDistance = std::numeric_limits<double>::infinity()) const;

  // Generalised winding number: 1 inside a closed mesh that faces outward, 0 outside and in a
  // cavity whose shell faces inward; a fraction near holes; overlapping shells add up. Far clusters
  // are approximated by a second order expansion, near triangles are exact (Barill et al., Fast
  // Winding Numbers for Soups and Clouds, SIGGRAPH 2018, eq. 14-19); error below 1e-2.
  double windingNumber(const Eigen::Vector3d& p) const;

  // windingNumber > 1/2: correct for closed and almost closed meshes.
  bool inside(const Eigen::Vector3d& p) const { return windingNumber(p) > 0.5; }

  // Distance to the surface, negative inside. +infinity for an empty mesh.
  double signedDistance(const Eigen::Vector3d& p) const;

  struct Hit {
    double t = 0.0; // in [0,1] along a -> b
    int triangle = -1;
  };
  // Returns the first crossing of segment a-b with the mesh; of equal t the triangle with the
  // lowest index.
  std::optional<Hit> firstHit(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

  // Replaces `out` by all crossings, sorted by t, then by triangle. The sides of the edges are
  // decided exactly (after shearing the segment onto an axis: Woop et al., Watertight Ray/Triangle
  // Intersection, JCGT 2013) and ties by a symbolic shift of the segment, so a line through an edge
  // or a vertex of a closed mesh crosses it an even number of times. A triangle that contains the
  // segment's direction is not crossed.
  void hits(const Eigen::Vector3d& a, const Eigen::Vector3d& b, std::vector<Hit>& out) const;

private:
  struct Node {
    Eigen::Vector3d low, high;
    int first = 0; // leaf: first triangle; inner: left child (the right one is first + 1)
    int count = 0; // leaf: number of triangles; inner: 0
  };
  struct Triangle {
    Eigen::Vector3d a, b, c;
  };

  void build(const TriangleMesh& mesh);
  void expandClusters();

  std::vector<Node> nodes_;
  std::vector<FarField> clusters_;  // one per node
  std::vector<Triangle> triangles_; // in the order of the leaves
  std::vector<int> index_;          // index in the mesh of each
};

} // namespace voluta::geometry
