// Parallel lines in a plane, and their stretches inside contours.
#pragma once

#include "geometry/polygon_paths.h"

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace voluta::toolpath {

struct ContourEdge {
  Eigen::Vector2d from, to;
};
std::vector<ContourEdge> edgesOf(const ClipperLib::Paths& paths);

using Interval = std::pair<double, double>;

class ScanLines {
public:
  // `count` lines in a direction [rad, from x towards y], `spacingMm` apart; the first one crosses
  // the axis across them at `firstMm`.
  ScanLines(double directionRad, double firstMm, double spacingMm, std::size_t count);
  // Lines over all of the contours: as many as fit in their width, at least one, the outermost half
  // a spacing inside. The spacing is nearest to `wantedMm`. Precondition: edges.
  static ScanLines over(const std::vector<ContourEdge>& edges, double directionRad,
                        double wantedMm);

  // Returns the stretches of each line inside contours, ascending.
  std::vector<std::vector<Interval>> inside(const std::vector<ContourEdge>& contours) const;

  std::size_t count() const { return count_; }
  double spacingMm() const { return spacingMm_; }
  // Returns the place at `alongMm` on a line; a share of a line is between it and the next.
  Eigen::Vector2d place(double line, double alongMm) const {
    return alongMm * along_ + (firstMm_ + line * spacingMm_) * across_;
  }

private:
  Eigen::Vector2d along_, across_;
  double firstMm_, spacingMm_;
  std::size_t count_;
};

// Returns the union of the stretches of one line, ascending.
std::vector<Interval> mergedIntervals(std::vector<Interval> stretches);

} // namespace voluta::toolpath
