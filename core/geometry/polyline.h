// Polylines by arc length: lengths, and places at a length. `pointAt(i)` is vertex i [mm].
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace voluta::geometry {

// A place between the vertices `segment` and `segment` + 1.
struct PolylinePlace {
  std::size_t segment = 0;
  double share = 0.0; // of the segment's length, 0 to 1
};

// Returns the length [mm] of a polyline of `count` vertices; 0 for fewer than two.
template <typename PointAt> double polylineLength(std::size_t count, const PointAt& pointAt) {
  double length = 0.0;
  for (std::size_t i = 1; i < count; ++i)
    length += (pointAt(i) - pointAt(i - 1)).norm();
  return length;
}

// Returns the arc length [mm] from the first vertex to each. Precondition: count > 0.
template <typename PointAt>
std::vector<double> arcLengths(std::size_t count, const PointAt& pointAt) {
  std::vector<double> lengths(count, 0.0);
  for (std::size_t i = 1; i < count; ++i)
    lengths[i] = lengths[i - 1] + (pointAt(i) - pointAt(i - 1)).norm();
  return lengths;
}

// Returns the place at an arc length [mm]; an end of the polyline if it is shorter. `lengths` are
// those of arcLengths(), of two vertices or more. The search begins at the segment `near`, which is
// fast for increasing lengths.
inline PolylinePlace placeAtLength(std::span<const double> lengths, double mm,
                                   std::size_t near = 0) {
  constexpr std::size_t kSteps = 8; // before the search halves
  const std::size_t last = lengths.size() - 2;
  std::size_t i = std::min(near, last);
  const std::size_t until = std::min(i + kSteps, last);
  if (lengths[i] <= mm)
    while (i < until && mm >= lengths[i + 1])
      ++i;
  if (lengths[i] > mm || (i < last && mm >= lengths[i + 1])) {
    const auto after = std::ranges::upper_bound(lengths, mm) - lengths.begin();
    i = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - 1, 0)), last);
  }
  const double length = lengths[i + 1] - lengths[i];
  return {i, length > 0.0 ? std::clamp((mm - lengths[i]) / length, 0.0, 1.0) : 1.0};
}

// Returns the place `mm` after the first vertex; nullopt if the polyline is no longer than that.
template <typename PointAt>
std::optional<PolylinePlace> placeAfter(double mm, std::size_t count, const PointAt& pointAt) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const double length = (pointAt(i + 1) - pointAt(i)).norm();
    if (length > mm)
      return PolylinePlace{i, mm / length};
    mm -= length;
  }
  return std::nullopt;
}

} // namespace voluta::geometry
