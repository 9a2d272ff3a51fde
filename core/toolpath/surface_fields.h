// Distance fields along a surface, and isolines.
#pragma once

#include "toolpath/patch_surface.h"

#include <limits>
#include <vector>

namespace voluta::toolpath {

// A short segment on a triangle, from which distances are measured.
struct SourceSegment {
  Eigen::Vector3d a, b;
  int triangle;
};

std::vector<SourceSegment> boundarySegments(const PatchSurface& surface);
// Boundary segments by kind: the part's surface, and seams to other patches.
struct BoundaryParts {
  std::vector<SourceSegment> surface, seams;
};
BoundaryParts boundaryParts(const PatchSurface& surface);
std::vector<SourceSegment> segmentsOf(const PatchSurface& surface,
                                      const std::vector<SurfaceCurve>& curves);

// Per vertex, the distance along the surface to the nearest source [mm]; `farMm` if it is larger or
// there is no source. The nearest segment propagates from vertex to vertex, so that folds that are
// close only in space do not interact. Its chord is bent into the circular arc that leaves both
// tangent planes at its ends: exact on planes, cylinders across and spheres, third order in length
// over radius elsewhere. `onwards`: per vertex, whether the nearest segment propagates beyond it;
// empty: everywhere. Vertices where it does not propagate have distances only if they are next to a
// source or to a vertex where it does.
struct SegmentDistances {
  std::vector<double> mm;
  std::vector<int> nearest; // of the sources; -1 if none is within farMm
};
SegmentDistances nearestSegments(const PatchSurface& surface,
                                 const std::vector<SourceSegment>& sources, double farMm,
                                 const std::vector<char>& onwards = {});
// Returns only the distances of nearestSegments().
std::vector<double> distanceToSegments(const PatchSurface& surface,
                                       const std::vector<SourceSegment>& sources, double farMm,
                                       const std::vector<char>& onwards = {});

// Per vertex, the signed distance along the surface to its intersection with the plane normal . x =
// offset, by fast marching (Kimmel & Sethian 1998): a function of unit gradient. Empty if the plane
// does not intersect the surface. normal: unit.
std::vector<double> distanceToSection(const PatchSurface& surface, const Eigen::Vector3d& normal,
                                      double offset);

// Returns the curves where the linear interpolation of `values` (per vertex) equals `level`; larger
// values are to the left, seen against the triangles' normals. Deterministic order.
std::vector<SurfaceCurve> isolines(const PatchSurface& surface, const std::vector<double>& values,
                                   double level);

// Isolines at many levels, low + (k + 1/2) spacing for k below count. Each level visits only the
// triangles that it may cross. Keeps references to both arguments. Precondition: spacing > 0.
class EvenIsolines {
public:
  EvenIsolines(const PatchSurface& surface, const std::vector<double>& values, double low,
               double spacing, int count);
  std::vector<SurfaceCurve> curvesAt(int k) const;

private:
  const PatchSurface& s_;
  const std::vector<double>& values_;
  double low_, spacing_;
  std::vector<std::size_t> start_, triangle_; // triangles per level
};

} // namespace voluta::toolpath
