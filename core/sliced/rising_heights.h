// Heights of beads that rise along their path, e.g. a spiral vase: from the beads below.
#pragma once

#include "sliced/sliced_file.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace voluta::sliced {

// The tops of beads, as they are printed. A layer of such a bead has no height of its own: the
// slicer states one, but the first turn begins at height 0 on the layer below.
class BeadTops {
public:
  // `widthMm`: the usual width of a bead; from 0.05 to 50 mm are used.
  explicit BeadTops(double widthMm) : reachMm_(kReach * std::clamp(widthMm, 0.05, 50.0)) {}

  // Adds a path. Returns, if it rises, the height of the bead on the way to each of its points, 0
  // for the first; empty otherwise. A height is the distance down to the highest earlier bead less
  // than half a width away, or to z = 0; `statedMm` (0: not known) where there is none within 2.5
  // usual heights. Beads stay narrower than 1.5 usual widths. `areasMm2`: of the section on the way
  // to each point. Precondition: `areasMm2` has as many entries as the path has points.
  std::vector<double> add(const SlicedPath& path, const std::vector<double>& areasMm2,
                          double statedMm);

private:
  static constexpr double kReach = 0.6;
  static constexpr std::size_t kLevel = static_cast<std::size_t>(-1);
  struct Sample {
    Eigen::Vector3d at;
    std::size_t path; // kLevel: of a level stretch, on which the same path may begin to rise
  };
  struct Waiting {
    Sample sample;
    double alongMm;
  };

  std::int64_t cellOf(double x, double y) const;
  // Returns the height above the bead below; negative: there is none.
  double gapBelow(const Eigen::Vector3d& point, double minMm) const;
  void release(double alongMm);

  const double reachMm_;
  std::size_t path_ = 0;
  std::deque<Waiting> waiting_; // Too near, along the path, to be below what follows
  std::unordered_map<std::int64_t, Sample> latest_;
};

} // namespace voluta::sliced
