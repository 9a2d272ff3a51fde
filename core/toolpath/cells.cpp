#include "toolpath/cells.h"

#include "toolpath/segment_grid.h"

#include <Eigen/Geometry>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {

struct Corner {
  Eigen::Vector3d position;
  double thicknessMm;
};
Corner between(const Corner& a, const Corner& b) {
  return {0.5 * (a.position + b.position), 0.5 * (a.thicknessMm + b.thicknessMm)};
}

// Gives samples of a surface to the nearest segment of the curves.
class Sharer {
public:
  Sharer(const std::vector<SurfaceCurve>& curves, double reachMm) : curves_(curves) {
    cells_.share.resize(curves.size());
    std::vector<SegmentGrid::Segment> segments;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto& points = curves[c].points;
      const std::size_t n = points.size() - (curves[c].closed ? 0 : 1);
      cells_.share[c].areaMm2.assign(n, 0.0);
      cells_.share[c].volumeMm3.assign(n, 0.0);
      cells_.share[c].lateralMm.assign(n, 0.0);
      for (std::size_t i = 0; i < n; ++i) {
        segments.push_back({points[i].position, points[(i + 1) % points.size()].position});
        owner_.emplace_back(c, i);
      }
    }
    grid_.emplace(std::move(segments), reachMm);
  }

  // A triangle, halved so often: four samples in each of the last pieces, one where there is none.
  void add(const Corner& a, const Corner& b, const Corner& c, const Eigen::Vector3d& normal,
           double area, int halved) {
    if (halved > 1) {
      const Corner ab = between(a, b), bc = between(b, c), ca = between(c, a);
      add(ab, bc, ca, normal, area / 4, halved - 1);
      add(a, ab, ca, normal, area / 4, halved - 1);
      add(ab, b, bc, normal, area / 4, halved - 1);
      add(ca, bc, c, normal, area / 4, halved - 1);
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
  }

  Cells finish() {
    for (CellShare& share : cells_.share)
      for (std::size_t i = 0; i < share.areaMm2.size(); ++i)
        if (share.areaMm2[i] > 0)
          share.lateralMm[i] /= share.areaMm2[i];
    return std::move(cells_);
  }

private:
  void sample(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double area,
              double thickness) {
    const SegmentGrid::Hit hit = grid_->nearest(p, last_);
    last_ = hit.segment;
    if (hit.segment < 0) {
      cells_.orphanMm2 += area;
      return;
    }
    const auto [c, i] = owner_[static_cast<std::size_t>(hit.segment)];
    CellShare& share = cells_.share[c];
    share.areaMm2[i] += area;
    share.volumeMm3[i] += area * thickness;
    const auto& points = curves_[c].points;
    if (!curves_[c].closed && i == 0 && hit.t <= 0)
      share.beyondMm2[0] += area;
    else if (!curves_[c].closed && i + 2 == points.size() && hit.t >= 1)
      share.beyondMm2[1] += area;
    const Eigen::Vector3d along = points[(i + 1) % points.size()].position - points[i].position;
    const double length = along.norm();
    if (length > 1e-9)
      share.lateralMm[i] += area * normal.cross(along / length).dot(p - hit.point);
  }

  const std::vector<SurfaceCurve>& curves_;
  Cells cells_;
  std::vector<std::pair<std::size_t, std::size_t>> owner_; // of a segment: curve, its place there
  std::optional<SegmentGrid> grid_;
  int last_ = -1;
};

} // namespace

Cells shareOut(const PatchSurface& s, const std::vector<SurfaceCurve>& curves, double reachMm,
               int halvings) {
  Sharer sharer(curves, reachMm);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto corner = [&](std::size_t k) {
      const auto v = static_cast<std::size_t>(s.triangles[t][k]);
      return Corner{s.position[v], s.thicknessMm[v]};
    };
    sharer.add(corner(0), corner(1), corner(2), s.triangleNormal[t], s.triangleArea[t], halvings);
  }
  return sharer.finish();
}

} // namespace voluta::toolpath
