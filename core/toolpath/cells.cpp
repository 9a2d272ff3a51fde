#include "toolpath/cells.h"

#include "toolpath/segment_grid.h"

#include <Eigen/Geometry>

namespace voluta::toolpath {

Cells shareOut(const PatchSurface& s, const std::vector<SurfaceCurve>& curves, double reachMm,
               bool fine) {
  Cells cells;
  cells.share.resize(curves.size());
  std::vector<SegmentGrid::Segment> segments;
  std::vector<std::pair<std::size_t, std::size_t>> owner;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    const std::size_t n = points.size() - (curves[c].closed ? 0 : 1);
    cells.share[c].areaMm2.assign(n, 0.0);
    cells.share[c].volumeMm3.assign(n, 0.0);
    cells.share[c].lateralMm.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      segments.push_back({points[i].position, points[(i + 1) % points.size()].position});
      owner.emplace_back(c, i);
    }
  }
  const SegmentGrid grid(std::move(segments), reachMm);
  const auto sample = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double area,
                          double thickness) {
    const SegmentGrid::Hit hit = grid.nearest(p);
    if (hit.segment < 0) {
      cells.orphanMm2 += area;
      return;
    }
    const auto [c, i] = owner[static_cast<std::size_t>(hit.segment)];
    CellShare& share = cells.share[c];
    share.areaMm2[i] += area;
    share.volumeMm3[i] += area * thickness;
    const auto& points = curves[c].points;
    if (!curves[c].closed && i == 0 && hit.t <= 0)
      share.beyondMm2[0] += area;
    else if (!curves[c].closed && i + 2 == points.size() && hit.t >= 1)
      share.beyondMm2[1] += area;
    const Eigen::Vector3d along = points[(i + 1) % points.size()].position - points[i].position;
    const double length = along.norm();
    if (length > 1e-9)
      share.lateralMm[i] += area * normal.cross(along / length).dot(p - hit.point);
  };
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(s.triangles[t][k]); };
    const Eigen::Vector3d &a = s.position[corner(0)], &b = s.position[corner(1)],
                          &c = s.position[corner(2)];
    const double ha = s.thicknessMm[corner(0)], hb = s.thicknessMm[corner(1)],
                 hc = s.thicknessMm[corner(2)];
    const double area = s.triangleArea[t];
    const Eigen::Vector3d middle = (a + b + c) / 3;
    const double height = (ha + hb + hc) / 3;
    if (!fine) {
      sample(middle, s.triangleNormal[t], area, height);
      continue;
    }
    sample(middle, s.triangleNormal[t], area / 4, height);
    sample((4 * a + b + c) / 6, s.triangleNormal[t], area / 4, (4 * ha + hb + hc) / 6);
    sample((a + 4 * b + c) / 6, s.triangleNormal[t], area / 4, (ha + 4 * hb + hc) / 6);
    sample((a + b + 4 * c) / 6, s.triangleNormal[t], area / 4, (ha + hb + 4 * hc) / 6);
  }
  for (CellShare& share : cells.share)
    for (std::size_t i = 0; i < share.areaMm2.size(); ++i)
      if (share.areaMm2[i] > 0)
        share.lateralMm[i] /= share.areaMm2[i];
  return cells;
}

} // namespace voluta::toolpath
