#include "geometry/polygon_paths.h"

#include <cmath>

namespace voluta::geometry {

using ClipperLib::Path;
using ClipperLib::Paths;

ClipperLib::IntPoint pathPoint(const Eigen::Vector2d& mm) {
  return {std::llround(kPathUnits * mm.x()), std::llround(kPathUnits * mm.y())};
}

Eigen::Vector2d pointMm(const ClipperLib::IntPoint& point) {
  return Eigen::Vector2d(static_cast<double>(point.X), static_cast<double>(point.Y)) / kPathUnits;
}

Paths united(const Paths& paths) {
  return combined(paths, {}, ClipperLib::ctUnion);
}

Paths combined(const Paths& a, const Paths& b, ClipperLib::ClipType how) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(a, ClipperLib::ptSubject, true);
  clipper.AddPaths(b, ClipperLib::ptClip, true);
  Paths out;
  clipper.Execute(how, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return out;
}

Paths offsetPaths(const Paths& paths, double byMm, const OffsetStyle& style) {
  ClipperLib::ClipperOffset offset(style.miterLimit, style.arcMm * kPathUnits);
  offset.AddPaths(paths, style.corners, style.ends);
  Paths out;
  offset.Execute(out, byMm * kPathUnits);
  return out;
}

double areaMm2(const Paths& paths) {
  double sum = 0.0;
  for (const Path& path : paths)
    sum += ClipperLib::Area(path);
  return sum / (kPathUnits * kPathUnits);
}

} // namespace voluta::geometry
