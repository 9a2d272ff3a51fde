#include "toolpath/cells.h"

#include "toolpath/segment_grid.h"

#include <Eigen/Geometry>

namespace voluta::toolpath {

Cells shareOut(const PatchSurface& s, const std::vector<SurfaceCurve>& curves, double reachMm,
               int halvings) {
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
  int last = -1;
  const auto sample = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double area,
                          double thickness) {
    const SegmentGrid::Hit hit = grid.nearest(p, last);
    last = hit.segment;
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
  struct Corner {
    Eigen::Vector3d position;
    double thicknessMm;
  };
  const auto between = [](const Corner& a, const Corner& b) {
    return Corner{0.5 * (a.position + b.position), 0.5 * (a.thicknessMm + b.thicknessMm)};
  };
  const auto sampleIn = [&](const auto& self, const Corner& a, const Corner& b, const Corner& c,
                            const Eigen::Vector3d& normal, double area, int halved) -> void {
    if (halved > 1) {
      const Corner ab = between(a, b), bc = between(b, c), ca = between(c, a);
      self(self, ab, bc, ca, normal, area / 4, halved - 1);
      self(self, a, ab, ca, normal, area / 4, halved - 1);
      self(self, ab, b, bc, normal, area / 4, halved - 1);
      self(self, ca, bc, c, normal, area / 4, halved - 1);
      return;
    }
    const auto weighted = [&](double wa, double wb, double wc) {
      const double sum = wa + wb + wc;
      sample((wa * a.position + wb * b.position + wc * c.position) / sum, normal,
             halved > 0 ? area / 4 : area,
             (wa * a.thicknessMm + wb * b.thicknessMm + wc * c.thicknessMm) / sum);
    };
    weighted(1, 1, 1);
    if (halved > 0) {
      weighted(4, 1, 1);
      weighted(1, 4, 1);
      weighted(1, 1, 4);
    }
  };
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) {
      const auto v = static_cast<std::size_t>(s.triangles[t][k]);
      return Corner{s.position[v], s.thicknessMm[v]};
    };
    sampleIn(sampleIn, corner(0), corner(1), corner(2), s.triangleNormal[t], s.triangleArea[t],
             halvings);
  }
  for (CellShare& share : cells.share)
    for (std::size_t i = 0; i < share.areaMm2.size(); ++i)
      if (share.areaMm2[i] > 0)
        share.lateralMm[i] /= share.areaMm2[i];
  return cells;
}

} // namespace voluta::toolpath
