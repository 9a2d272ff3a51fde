#include "planar/parting/pin_places.h"

#include "geometry/boundary.h"
#include "geometry/mesh_query.h"
#include "geometry/polygon_paths.h"
#include "planar/parting/joint_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::planar {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kCandidatesAcross = 40; // of an outline, along its longer side

struct SectionFrame {
  PlaneFrame axes;
  Plane plane;
  Vector2d to2d(const Vector3d& p) const { return {axes.across.dot(p), axes.along.dot(p)}; }
  Vector3d to3d(const Vector2d& p) const {
    return p.x() * axes.across + p.y() * axes.along + plane.offsetMm * plane.normal;
  }
};

Paths outlinesOf(const geometry::TriangleMesh& section, const SectionFrame& frame) {
  Paths loops;
  for (const std::vector<int>& loop : geometry::boundaryLoops(section)) {
    Path path;
    for (const int v : loop)
      path.push_back(
          geometry::pathPoint(frame.to2d(section.vertices[static_cast<std::size_t>(v)])));
    loops.push_back(std::move(path));
  }
  ClipperLib::Clipper clipper;
  clipper.AddPaths(loops, ClipperLib::ptSubject, true);
  Paths out;
  clipper.Execute(ClipperLib::ctUnion, out, ClipperLib::pftEvenOdd);
  return out;
}

bool isInside(const Paths& region, const ClipperLib::IntPoint& point) {
  bool inside = false;
  for (const Path& path : region)
    inside = inside != (ClipperLib::PointInPolygon(point, path) != 0);
  return inside;
}

std::vector<Vector2d> candidatesIn(const Paths& region) {
  std::vector<Vector2d> out;
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Path& path : region)
    for (const auto& point : path) {
      low = low.cwiseMin(geometry::pointMm(point));
      high = high.cwiseMax(geometry::pointMm(point));
    }
  if (!(low.x() <= high.x()))
    return out;
  const double step = std::max((high - low).maxCoeff() / kCandidatesAcross, 1e-3);
  const Vector2d middle = 0.5 * (low + high);
  const int acrossHalf = static_cast<int>(0.5 * (high - low).x() / step) + 1;
  const int alongHalf = static_cast<int>(0.5 * (high - low).y() / step) + 1;
  for (int j = -alongHalf; j <= alongHalf; ++j)
    for (int i = -acrossHalf; i <= acrossHalf; ++i) {
      const Vector2d p = middle + step * Vector2d(i, j);
      if (isInside(region, geometry::pathPoint(p)))
        out.push_back(p);
    }
  return out;
}

// Returns whether a wall is left everywhere around a hole of both halves. A point of the surface
// that is nearest to the axis between two of its points, at a distance d, is at most
// hypot(d, step / 2) from the nearer one.
bool leavesWall(const geometry::MeshQuery& surface, const Vector3d& at, const Vector3d& normal,
                const PinRoom& room) {
  const int steps = static_cast<int>(std::ceil(4.0 * room.depthMm / room.wallMm));
  const double step = room.depthMm / steps;
  const double needed = std::hypot(room.radiusMm + room.wallMm, 0.5 * step);
  for (int k = -steps; k <= steps; ++k) {
    const Vector3d on = at + (room.depthMm * k / steps) * normal;
    if (surface.closest(on, needed).triangle >= 0)
      return false;
  }
  return true;
}

// Returns up to `count` candidates far from each other, at least `apartMm`; one alone is in the
// middle.
std::vector<Vector2d> spread(const std::vector<Vector2d>& candidates, int count, double apartMm) {
  if (candidates.empty())
    return {};
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : candidates)
    middle += p / static_cast<double>(candidates.size());
  const auto from = [&](const Vector2d& p) { return (p - middle).norm(); };
  std::vector<double> nearest(candidates.size());
  std::ranges::transform(candidates, nearest.begin(), from);
  if (count == 1)
    return {
        candidates[static_cast<std::size_t>(std::ranges::min_element(nearest) - nearest.begin())]};
  std::vector<Vector2d> chosen;
  while (static_cast<int>(chosen.size()) < count) {
    const auto best = std::ranges::max_element(nearest);
    if (!chosen.empty() && *best < apartMm)
      break;
    const Vector2d next = candidates[static_cast<std::size_t>(best - nearest.begin())];
    const bool isFirst = chosen.empty();
    chosen.push_back(next);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double d = (candidates[i] - next).norm();
      nearest[i] = isFirst ? d : std::min(nearest[i], d);
    }
  }
  return chosen.size() > 1 ? chosen : spread(candidates, 1, apartMm);
}

} // namespace

std::vector<Vector3d> pinPlaces(const geometry::TriangleMesh& part,
                                const geometry::TriangleMesh& section, const Plane& plane,
                                const PinRoom& room) {
  const SectionFrame frame{jointAxes(plane.normal), plane};
  Paths left = outlinesOf(section, frame);
  const geometry::MeshQuery surface(part, geometry::MeshQuery::Of::Surface);
  Paths outer;
  for (const Path& path : left)
    if (ClipperLib::Area(path) > 0.0)
      outer.push_back(path);
  std::ranges::stable_sort(outer, {}, [](const Path& path) { return ClipperLib::Area(path); });
  std::vector<std::vector<Vector3d>> found;
  for (const Path& outline : outer) { // smaller ones first: they may lie in holes of larger ones
    const Paths region = geometry::combined(left, {outline}, ClipperLib::ctIntersection);
    left = geometry::combined(left, {outline}, ClipperLib::ctDifference);
    std::vector<Vector2d> best;
    for (const double wallsLeft : {4.0, 2.0, 1.0}) { // not close to the edge where there is room
      std::vector<Vector2d> candidates = candidatesIn(
          geometry::offsetPaths(region, -(room.radiusMm + wallsLeft * room.wallMm), {}));
      std::erase_if(candidates, [&](const Vector2d& p) {
        return !leavesWall(surface, frame.to3d(p), plane.normal, room);
      });
      std::vector<Vector2d> chosen =
          spread(candidates, room.count, 2.0 * (2.0 * room.radiusMm + room.wallMm));
      if (chosen.size() > best.size())
        best = std::move(chosen);
      if (static_cast<int>(best.size()) >= room.count)
        break;
    }
    found.emplace_back();
    for (const Vector2d& p : best)
      found.back().push_back(frame.to3d(p));
  }
  std::vector<Vector3d> places;
  for (auto outline = found.rbegin(); outline != found.rend(); ++outline)
    places.insert(places.end(), outline->begin(), outline->end());
  return places;
}

} // namespace voluta::planar
