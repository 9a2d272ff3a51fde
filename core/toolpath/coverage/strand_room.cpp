#include "toolpath/coverage/strand_room.h"

#include "base/index.h"
#include "toolpath/coverage/segment_grid.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using base::at;

struct Place {
  std::size_t curve;
  double along; // From the curve's start to the segment's [mm]
};
} // namespace

std::vector<std::vector<double>> strandRoom(const std::vector<SurfaceCurve>& curves,
                                            double reachMm) {
  constexpr double kSamePart = 1.5;
  std::vector<SegmentGrid::Segment> segments;
  std::vector<Place> places;
  std::vector<double> length(curves.size(), 0.0);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = curves[c].points;
    for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < points.size(); ++i) {
      segments.push_back({points[i].position, points[(i + 1) % points.size()].position});
      places.push_back({c, length[c]});
      length[c] += (segments.back().b - segments.back().a).norm();
    }
  }
  const SegmentGrid grid(segments, reachMm);
  std::vector<std::vector<double>> room(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c) {
    double along = 0.0;
    const auto& points = curves[c].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0)
        along += (points[i].position - points[i - 1].position).norm();
      double minimum = reachMm;
      grid.forEachWithin(points[i].position, reachMm, [&](int segment, double, double distance) {
        const Place& other = places[at(segment)];
        const double between = std::abs(other.along - along);
        const double apart = curves[c].closed ? std::min(between, length[c] - between) : between;
        if (other.curve != c || apart > kSamePart * reachMm)
          minimum = std::min(minimum, distance);
      });
      room[c].push_back(minimum);
    }
  }
  return room;
}

} // namespace voluta::toolpath
