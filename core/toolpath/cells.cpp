#include "toolpath/cells.h"

#include "toolpath/segment_grid.h"
#include "toolpath/surface_samples.h"

#include <Eigen/Geometry>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {

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
    grid_.emplace(segments, reachMm);
  }

  void add(const SurfaceSample& sample, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d& p = sample.position;
    const double area = sample.areaMm2;
    const SegmentGrid::Hit hit = grid_->nearest(p, last_);
    last_ = hit.segment;
    if (hit.segment < 0) {
      cells_.orphanMm2 += area;
      return;
    }
    const auto [c, i] = owner_[static_cast<std::size_t>(hit.segment)];
    CellShare& share = cells_.share[c];
    share.areaMm2[i] += area;
    share.volumeMm3[i] += area * sample.thicknessMm;
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

  Cells finish() {
    for (CellShare& share : cells_.share)
      for (std::size_t i = 0; i < share.areaMm2.size(); ++i)
        if (share.areaMm2[i] > 0)
          share.lateralMm[i] /= share.areaMm2[i];
    return std::move(cells_);
  }

private:
  const std::vector<SurfaceCurve>& curves_;
  Cells cells_;
  std::vector<std::pair<std::size_t, std::size_t>> owner_; // of a segment: curve, its place there
  std::optional<SegmentGrid> grid_;
  int last_ = -1;
};

} // namespace

Cells shareOut(const PatchSurface& s, const std::vector<SurfaceCurve>& curves, double reachMm,
               double sampleMm2) {
  Sharer sharer(curves, reachMm);
  forEachSample(s, sampleMm2, [&](const SurfaceSample& sample) {
    sharer.add(sample, s.triangleNormal[sample.triangle]);
  });
  return sharer.finish();
}

} // namespace voluta::toolpath
