#include "planar/slicing/section_paths.h"

#include <cmath>
#include <vector>

namespace voluta::planar {

using ClipperLib::Path;
using ClipperLib::Paths;

Paths cleaned(Paths paths) {
  ClipperLib::CleanPolygons(paths, kCleanMm * kPathUnits);
  std::erase_if(paths, [](const Path& path) { return path.size() < 3; });
  return paths;
}

Paths loopsOf(const Section& section, const PlaneFrame& frame) {
  std::vector<std::vector<int>> next(section.points.size());
  for (const auto& [a, b] : section.edges)
    next[static_cast<std::size_t>(a)].push_back(b);
  Paths loops;
  for (std::size_t start = 0; start < next.size(); ++start)
    while (!next[start].empty()) {
      Path loop;
      for (auto at = start; !next[at].empty();) {
        const Eigen::Vector3d& p = section.points[at];
        loop.emplace_back(std::llround(kPathUnits * frame.across.dot(p)),
                          std::llround(kPathUnits * frame.along.dot(p)));
        const int to = next[at].back();
        next[at].pop_back();
        at = static_cast<std::size_t>(to);
      }
      loops.push_back(std::move(loop));
    }
  return loops;
}

Section sectionOf(const Paths& paths, const Plane& plane, const PlaneFrame& frame) {
  Section out;
  out.plane = plane;
  for (const Path& path : paths) {
    const auto first = static_cast<int>(out.points.size()), n = static_cast<int>(path.size());
    for (const ClipperLib::IntPoint& p : path)
      out.points.push_back(static_cast<double>(p.X) / kPathUnits * frame.across +
                           static_cast<double>(p.Y) / kPathUnits * frame.along +
                           plane.offsetMm * plane.normal);
    for (int i = 0; i < n; ++i)
      out.edges.push_back({first + i, first + (i + 1) % n});
  }
  return out;
}

Section filledByWinding(const Section& section) {
  const PlaneFrame frame = frameOf(section.plane.normal);
  // Strictly simple: no point occurs twice, so that the resulting section does not touch itself.
  ClipperLib::Clipper clipper(ClipperLib::ioStrictlySimple);
  clipper.AddPaths(loopsOf(section, frame), ClipperLib::ptSubject, true);
  Paths out;
  clipper.Execute(ClipperLib::ctUnion, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return sectionOf(cleaned(std::move(out)), section.plane, frame);
}

} // namespace voluta::planar
