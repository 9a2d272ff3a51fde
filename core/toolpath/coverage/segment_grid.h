// Finds the nearest of a set of short segments.
#pragma once

#include "voxel/voxel_grid.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace voluta::toolpath {

class SegmentGrid {
public:
  struct Segment {
    Eigen::Vector3d a, b;
  };
  struct Hit {
    int segment = -1;
    double t = 0.0; // 0 at a, 1 at b
    double distanceMm = 0.0;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
  };
  SegmentGrid(const std::vector<Segment>& segments, double reachMm);

  // Returns the nearest segment within the reach, the first of equals; segment -1 if there is none.
  // `likely`: a segment that may be near, such as the previous point's. It only speeds up the
  // search.
  Hit nearest(const Eigen::Vector3d& p, int likely = -1) const;
  // Calls f(segment, t, distance) for every segment within `radiusMm` <= reach; may call it more
  // than once for a segment.
  template <typename F> void forEachWithin(const Eigen::Vector3d& p, double radiusMm, F&& f) const {
    visit(p, radiusMm, [&](int i) {
      const auto [t, squared] = measure(i, p);
      if (squared <= radiusMm * radiusMm)
        f(i, t, std::sqrt(squared));
    });
  }

private:
  template <typename F> void visit(const Eigen::Vector3d& p, double radius, F&& f) const {
    Eigen::Vector3i lo, hi;
    for (int k = 0; k < 3; ++k) {
      const double first = (p[k] - radius - low_[k]) * inverse_;
      const double last = (p[k] + radius - low_[k]) * inverse_;
      if (last < 0.0)
        return;
      lo[k] = static_cast<int>(std::max(0.0, first));
      hi[k] = std::min(size_[k] - 1, static_cast<int>(last));
    }
    for (int z = lo.z(); z <= hi.z(); ++z)
      for (int y = lo.y(); y <= hi.y(); ++y)
        for (int x = lo.x(); x <= hi.x(); ++x) {
          const auto c = cellAt(x, y, z);
          for (int i = start_[c]; i < start_[c + 1]; ++i)
            f(entry_[static_cast<std::size_t>(i)]);
        }
  }
  std::size_t cellAt(int x, int y, int z) const {
    return voxel::VoxelGrid{.size = size_}.index(x, y, z);
  }
  // Returns the parameter (0 to 1) of the segment's nearest point to p, and the squared distance.
  std::pair<double, double> measure(int segment, const Eigen::Vector3d& p) const {
    const Ray& s = rays_[static_cast<std::size_t>(segment)];
    const Eigen::Vector3d off = p - s.a;
    const double t = std::clamp(s.ab.dot(off) * s.inverse, 0.0, 1.0);
    return {t, (off - t * s.ab).squaredNorm()};
  }

  struct Ray {
    Eigen::Vector3d a, ab;
    double inverse; // 1 / squared length
  };
  std::vector<Ray> rays_;
  double reach_, cell_, inverse_ = 0.0; // mm, mm, 1/mm
  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<int> start_, entry_;
};

} // namespace voluta::toolpath
