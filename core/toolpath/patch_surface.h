// A patch refined until its triangles are small compared to a bead, with the data needed to cover
// it.
#pragma once

#include "layers/layer_stack.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// A point on a triangle of a PatchSurface [mm].
struct SurfacePoint {
  Eigen::Vector3d position;
  int triangle;
};

// A curve on the surface. A closed one continues from its last point to its first.
struct SurfaceCurve {
  std::vector<SurfacePoint> points;
  bool closed = false;
};

struct PatchSurface {
  std::vector<Eigen::Vector3d> position; // per vertex, mm
  std::vector<Eigen::Vector3d> normal;   // per vertex, unit, of the refined surface
  std::vector<double> thicknessMm;       // per vertex
  std::vector<Eigen::Vector3d> direction, clearDirection; // per vertex, unit
  std::vector<std::uint8_t> seam; // per vertex, layers::Patch::innerRim; empty: nowhere
  layers::Chart chart;            // layers::Patch::chart; empty: none
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> triangleArea;            // mm2
  std::vector<Eigen::Vector3d> triangleNormal; // unit, zero for degenerate triangles
  std::vector<std::array<int, 3>> boundary;    // vertex, next vertex, triangle
  std::vector<std::uint8_t> isOnBoundary;      // per vertex
  // Unit normal, if all triangles are coplanar and face the same way.
  std::optional<Eigen::Vector3d> planeNormal;
  // Returns whether boundary edge i is inside the part, where another patch continues.
  bool isSeam(std::size_t i) const {
    return !seam.empty() && seam[static_cast<std::size_t>(boundary[i][0])] != 0 &&
           seam[static_cast<std::size_t>(boundary[i][1])] != 0;
  }
  double areaMm2 = 0.0;
  double volumeMm3 = 0.0; // area x thickness

  // Triangles around a vertex.
  const int* ringBegin(int vertex) const {
    return ring_.data() + ringStart_[static_cast<std::size_t>(vertex)];
  }
  const int* ringEnd(int vertex) const {
    return ring_.data() + ringStart_[static_cast<std::size_t>(vertex) + 1];
  }

  // Returns the barycentric coordinates of a point in its triangle, clamped to it.
  Eigen::Vector3d barycentric(const SurfacePoint& p) const;
  double interpolate(const std::vector<double>& values, const SurfacePoint& p) const;
  // Interpolated and normalised.
  Eigen::Vector3d interpolate(const std::vector<Eigen::Vector3d>& values,
                              const SurfacePoint& p) const;
  // Returns the surface point nearest to `point`, found by descent from triangle `start`. Correct
  // if `point` is closer to the surface than its radius of curvature and not many triangles away.
  // On planar surfaces it walks across the edges that separate the triangle from the point.
  SurfacePoint project(const Eigen::Vector3d& point, int start) const;

  // Refines the patch by splitting edges until none is longer than `edgeMm`. Preconditions:
  // per-vertex arrays of the patch match its vertices; edgeMm > 0.
  static PatchSurface refine(const layers::Patch& patch, double edgeMm);
  // As refine(), but only edges between two marked vertices are split; vertices that halve such an
  // edge are marked too. Precondition: one mark per vertex.
  PatchSurface refinedAt(std::vector<char> marks, double edgeMm) const;

private:
  void link();
  int crossedTowards(const Eigen::Vector3d& point, int triangle) const;
  bool isFootInside(int triangle, const Eigen::Vector3d& point, const Eigen::Vector3d& q) const;
  std::vector<int> ringStart_, ring_;
};

} // namespace voluta::toolpath
