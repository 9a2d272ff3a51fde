// Sections of a closed mesh by parallel planes.
#pragma once

#include "geometry/triangle_mesh.h"
#include "planar/plane.h"

#include <Eigen/Core>
#include <array>
#include <vector>

namespace voluta::planar {

// The region in which a plane intersects a solid, given by its boundary [mm].
struct Section {
  Plane plane;
  std::vector<Eigen::Vector3d> points; // on the mesh's edges or vertices
  // Pairs of indices into points; the region is to the left, seen against the plane's normal. Loops
  // are closed: each point starts as many edges as it ends.
  std::vector<std::array<int, 2>> edges;

  bool empty() const { return edges.empty(); }
};

// Returns the area inside the section's edges [mm²], exact up to rounding.
double areaOf(const Section& section);

// Computes sections of one mesh by planes perpendicular to one direction; the cost of a section
// depends only on the triangles it intersects. The mesh must stay unchanged.
class Sections {
public:
  // `closed` faces outward; `normal` is a unit vector. Precondition (Error{Internal}): the mesh is
  // not empty.
  Sections(const geometry::TriangleMesh& closed, const Eigen::Vector3d& normal);

  // Points on the plane count as above it, so a face in the plane has a section if the solid is
  // below it. Thread-safe.
  Section at(double offsetMm) const;

  double lowestMm() const { return lowest_; }
  double highestMm() const { return highest_; }

private:
  const geometry::TriangleMesh& mesh_;
  Eigen::Vector3d normal_;
  std::vector<double> height_; // of the vertices
  double lowest_ = 0.0, highest_ = 0.0, onPlane_ = 0.0;
  // Triangles by slabs of height; each is listed in every slab it intersects.
  double slab_ = 1.0;
  std::vector<std::vector<int>> slabs_;
};

} // namespace voluta::planar
