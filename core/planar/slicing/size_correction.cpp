#include "planar/slicing/size_correction.h"

#include "planar/slicing/section_paths.h"

namespace voluta::planar {

namespace {
using ClipperLib::Path;
using ClipperLib::Paths;

// Chords of rounded corners stay this close to their arcs.
constexpr double kArcMm = 0.005;

Paths moved(const Paths& paths, double outwardsMm) {
  if (outwardsMm == 0.0)
    return paths;
  constexpr double kMiterLimit = 4.0; // Sharper corners than about 29 degrees are cut off
  return geometry::offsetPaths(
      paths, outwardsMm,
      {.arcMm = kArcMm, .corners = ClipperLib::jtMiter, .miterLimit = kMiterLimit});
}

// Returns an outline with its own holes, all moved.
Paths movedRegion(const ClipperLib::PolyNode& outline, const SizeCorrection& correction) {
  Paths holes;
  for (const ClipperLib::PolyNode* hole : outline.Childs) {
    holes.push_back(hole->Contour);
    ClipperLib::ReversePath(holes.back());
  }
  ClipperLib::Clipper cut(ClipperLib::ioStrictlySimple);
  cut.AddPaths(moved({outline.Contour}, correction.outlineMm), ClipperLib::ptSubject, true);
  cut.AddPaths(moved(holes, correction.holeMm), ClipperLib::ptClip, true);
  Paths out;
  cut.Execute(ClipperLib::ctDifference, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return out;
}

Section scaled(Section section, const SizeCorrection& correction, const Eigen::Vector2d& centre) {
  const Eigen::Array2d factor(correction.scaleX, correction.scaleY);
  for (Eigen::Vector3d& p : section.points)
    p.head<2>() = centre + (factor * (p.head<2>() - centre).array()).matrix();
  return section;
}
} // namespace

Section corrected(const Section& section, const SizeCorrection& correction,
                  const Eigen::Vector2d& centre) {
  constexpr double kUpright = 1.0 - 1e-9;
  if (correction.isNeutral() || section.empty() || section.plane.normal.z() < kUpright)
    return section;
  const Section larger = scaled(section, correction, centre);
  if (correction.outlineMm == 0.0 && correction.holeMm == 0.0)
    return larger;
  const PlaneFrame frame = frameOf(section.plane.normal);
  ClipperLib::Clipper clean(ClipperLib::ioStrictlySimple);
  clean.AddPaths(loopsOf(larger, frame), ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clean.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd);
  // Each region alone: an island in a hole is a region of its own.
  ClipperLib::Clipper all(ClipperLib::ioStrictlySimple);
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node; node = node->GetNext())
    if (!node->IsHole())
      all.AddPaths(movedRegion(*node, correction), ClipperLib::ptSubject, true);
  Paths out;
  all.Execute(ClipperLib::ctUnion, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  // Coarser than this, the chords of a circle would make a hole smaller than it was.
  constexpr double kFineMm = 0.001;
  ClipperLib::CleanPolygons(out, kFineMm * kPathUnits);
  std::erase_if(out, [](const Path& path) { return path.size() < 3; });
  return sectionOf(out, section.plane, frame);
}

} // namespace voluta::planar
