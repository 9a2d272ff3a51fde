// Distances along a surface, and curves of equal value.
#pragma once

#include "toolpath/patch_surface.h"

#include <limits>
#include <vector>

namespace voluta::toolpath {

// A short segment on a triangle: what distances are measured to.
struct SourceSegment {
  Eigen::Vector3d a, b;
  int triangle;
};

std::vector<SourceSegment> boundarySegments(const PatchSurface& surface);
// The same by what they are: the part's surface, and seams to other patches.
struct BoundaryParts {
  std::vector<SourceSegment> surface, seams;
};
BoundaryParts boundaryParts(const PatchSurface& surface);
std::vector<SourceSegment> segmentsOf(const PatchSurface& surface,
                                      const std::vector<SurfaceCurve>& curves);

// Per vertex, the distance along the surface to the nearest source, mm; `farMm` where it is
// further or there is no source. The nearest segment travels from vertex to vertex (so folds that
// only come near through space don't meet), and the chord to it is bent into the circular arc that
// leaves both tangent planes at its ends: exact on planes, cylinders across and spheres, third
// order in the length over the radius elsewhere.
// `onwards`: per vertex, does the nearest segment travel on from it; empty: everywhere. Where it
// does not, distances are known next to sources and to where it does.
struct SegmentDistances {
  std::vector<double> mm;
  std::vector<int> nearest; // of the sources; -1 where there is none as near
};
SegmentDistances nearestSegments(const PatchSurface& surface,
                                 const std::vector<SourceSegment>& sources, double farMm,
                                 const std::vector<char>& onwards = {});
// The distances of these.
std::vector<double> distanceToSegments(const PatchSurface& surface,
                                       const std::vector<SourceSegment>& sources, double farMm,
                                       const std::vector<char>& onwards = {});

// Per vertex, the signed distance along the surface to its section with the plane
// normal . x = offset, by fast marching (Kimmel & Sethian 1998): a function of unit gradient.
// Empty when the plane misses the surface. normal: unit.
std::vector<double> distanceToSection(const PatchSurface& surface, const Eigen::Vector3d& normal,
                                      double offset);

// Curves where the linear interpolation of `values` (per vertex) is `level`; larger values lie to
// the left, seen against the triangles' normals. Deterministic order.
std::vector<SurfaceCurve> isolines(const PatchSurface& surface, const std::vector<double>& values,
                                   double level);

// The same at many levels, low + (k + 1/2) spacing for k below count: each looks at the triangles
// that it may cross, not at all of them. Keeps references to both. Precondition: spacing > 0.
class EvenIsolines {
public:
  EvenIsolines(const PatchSurface& surface, const std::vector<double>& values, double low,
               double spacing, int count);
  std::vector<SurfaceCurve> curvesAt(int k) const;

private:
  const PatchSurface& s_;
  const std::vector<double>& values_;
  double low_, spacing_;
  std::vector<std::size_t> start_, triangle_; // per level, its triangles
};

} // namespace voluta::toolpath
