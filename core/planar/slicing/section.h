// Where parallel planes meet a closed mesh.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::planar {

// The region that a plane cuts out of a solid, by its boundary. mm.
struct Section {
  Plane plane;
  std::vector<Eigen::Vector3d> points; // on the mesh's edges or vertices
  // Pairs of indices into points, the region to the left seen against the plane's normal. Loops
  // are closed: a point begins as many edges as it ends.
  std::vector<std::array<int, 2>> edges;

  bool empty() const { return edges.empty(); }
};

// Area inside the section's edges, mm2 (of the polygon, exact but for rounding).
double areaOf(const Section& section);

// Sections of one mesh by planes across one direction: each costs what its plane meets. The mesh
// must stay as it is.
class Sections {
public:
  // `closed` faces outward; `normal` is a unit vector. Precondition (Error{Internal}): a mesh that
  // is not empty.
  Sections(const geometry::TriangleMesh& closed, const Eigen::Vector3d& normal);

  // What lies on the plane itself counts as above it, so a face along the plane has its section
  // where the solid is under it. Safe from many threads.
  Section at(double offsetMm) const;

  double lowestMm() const { return lowest_; }
  double highestMm() const { return highest_; }

private:
  const geometry::TriangleMesh& mesh_;
  Eigen::Vector3d normal_;
  std::vector<double> height_; // of the vertices
  double lowest_ = 0.0, highest_ = 0.0, onPlane_ = 0.0;
  // Triangles by the slab of heights that they begin in; each is listed in every slab it meets.
  double slab_ = 1.0;
  std::vector<std::vector<int>> slabs_;
};

} // namespace voluta::planar
