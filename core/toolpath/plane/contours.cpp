#include "toolpath/plane/contours.h"

#include "geometry/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}
} // namespace

Contours::Contours(const ClipperLib::Paths& paths) {
  double highest = -INFINITY;
  lowest_ = INFINITY;
  for (const ClipperLib::Path& path : paths) {
    if (path.size() < 3)
      continue;
    Contour contour;
    for (const ClipperLib::IntPoint& p : path)
      contour.points.push_back(geometry::pointMm(p));
    contour.points.push_back(contour.points.front());
    contour.arc = geometry::arcLengths(
        contour.points.size(), [&](std::size_t i) -> const Vector2d& { return contour.points[i]; });
    for (std::size_t i = 0; i + 1 < contour.points.size(); ++i) {
      edges_.push_back({contours_.size(), i});
      lowest_ = std::min(lowest_, contour.points[i].y());
      highest = std::max(highest, contour.points[i].y());
    }
    contours_.push_back(std::move(contour));
  }
  if (edges_.empty())
    return;
  const auto count = std::max<std::size_t>(1, edges_.size() / 2);
  rowMm_ = std::max(1e-3, (highest - lowest_) / static_cast<double>(count));
  rows_.resize(count);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Contour& contour = contours_[edges_[e].contour];
    const auto [low, high] =
        std::minmax(contour.points[edges_[e].first].y(), contour.points[edges_[e].first + 1].y());
    for (std::size_t row = rowOf(low); row <= rowOf(high); ++row)
      rows_[row].push_back(e);
  }
}

std::size_t Contours::rowOf(double y) const {
  const double row = std::clamp((y - lowest_) / rowMm_, 0.0, static_cast<double>(rows_.size() - 1));
  return static_cast<std::size_t>(row);
}

bool Contours::contains(const Vector2d& place) const {
  if (edges_.empty())
    return false;
  bool isInside = false;
  for (const std::size_t e : rows_[rowOf(place.y())]) {
    const Contour& contour = contours_[edges_[e].contour];
    const Vector2d &p = contour.points[edges_[e].first], &q = contour.points[edges_[e].first + 1];
    if ((p.y() > place.y()) != (q.y() > place.y()) &&
        place.x() < p.x() + (q.x() - p.x()) * (place.y() - p.y()) / (q.y() - p.y()))
      isInside = !isInside;
  }
  return isInside;
}

std::vector<Contours::Crossing> Contours::crossings(const Vector2d& a, const Vector2d& b) const {
  std::vector<Crossing> all;
  if (edges_.empty())
    return all;
  const Vector2d along = b - a;
  const auto [low, high] = std::minmax(a.y(), b.y());
  for (std::size_t row = rowOf(low); row <= rowOf(high); ++row)
    for (const std::size_t e : rows_[row]) {
      const Contour& contour = contours_[edges_[e].contour];
      const std::size_t i = edges_[e].first;
      const Vector2d &p = contour.points[i], &q = contour.points[i + 1];
      if (row > rowOf(low) && row > rowOf(std::min(p.y(), q.y())))
        continue; // seen in the row before
      const double left = cross(along, p - a), right = cross(along, q - a);
      if ((left > 0.0) == (right > 0.0))
        continue;
      const double onEdge = left / (left - right);
      const Vector2d there = p + onEdge * (q - p);
      const double share = (there - a).dot(along) / along.squaredNorm();
      if (share >= 0.0 && share < 1.0)
        all.push_back(
            {share,
             {edges_[e].contour, contour.arc[i] + onEdge * (contour.arc[i + 1] - contour.arc[i])}});
    }
  std::ranges::sort(all, {}, &Crossing::share);
  return all;
}

Vector2d Contours::at(const Contour& contour, double arcMm) const {
  const geometry::PolylinePlace place = geometry::placeAtLength(contour.arc, arcMm);
  return contour.points[place.segment] +
         place.share * (contour.points[place.segment + 1] - contour.points[place.segment]);
}

std::vector<Vector2d> Contours::between(std::size_t c, double fromMm, double toMm) const {
  const Contour& contour = contours_[c];
  const double length = contour.arc.back();
  std::vector<Vector2d> points{at(contour, fromMm)};
  const auto add = [&](double after, double before) {
    for (auto i = std::ranges::upper_bound(contour.arc, after);
         i != contour.arc.end() && *i < before; ++i)
      points.push_back(contour.points[static_cast<std::size_t>(i - contour.arc.begin())]);
  };
  if (toMm < fromMm) {
    add(fromMm, length);
    points.push_back(contour.points.front());
    add(0.0, toMm);
  } else
    add(fromMm, toMm);
  points.push_back(at(contour, toMm));
  return points;
}

} // namespace voluta::toolpath
