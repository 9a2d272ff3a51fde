// Closed contours in a plane that answer which places they contain, and where a line crosses them.
#pragma once

#include "geometry/polygon_paths.h"

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::toolpath {

// A place on a contour.
struct ContourPlace {
  std::size_t contour = 0;
  double arcMm = 0.0; // from the contour's first point
};

// Thread-safe after construction.
class Contours {
public:
  // `paths`: outlines and holes; a place is inside if it is inside an odd number of them.
  explicit Contours(const ClipperLib::Paths& paths);

  bool contains(const Eigen::Vector2d& place) const;

  struct Crossing {
    double share = 0.0; // of the segment's length
    ContourPlace place;
  };
  // Returns where the segment from `a` to `b` crosses the contours, ascending by share.
  std::vector<Crossing> crossings(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

  double lengthMm(std::size_t contour) const { return contours_[contour].arc.back(); }
  // Returns the points of a contour between two arc lengths, in its direction, with both ends.
  std::vector<Eigen::Vector2d> between(std::size_t contour, double fromMm, double toMm) const;

private:
  struct Contour {
    std::vector<Eigen::Vector2d> points; // the first one is repeated at the end
    std::vector<double> arc;             // per point
  };
  struct Edge {
    std::size_t contour, first;
  };
  std::size_t rowOf(double y) const;
  Eigen::Vector2d at(const Contour& contour, double arcMm) const;

  std::vector<Contour> contours_;
  std::vector<Edge> edges_;
  double lowest_ = 0.0, rowMm_ = 1.0;
  std::vector<std::vector<std::size_t>> rows_; // edges per row
};

} // namespace voluta::toolpath
