#include "toolpath/plane/plane_patch.h"

#include "base/index.h"
#include "geometry/boundary.h"
#include "geometry/least_turn.h"
#include "layers/level_surface.h"
#include "layers/region_fill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

using base::at;

constexpr double kSameMm = 1e-6, kSameDirection = 1e-9;

using Coordinates = std::pair<ClipperLib::cInt, ClipperLib::cInt>;

Coordinates coordinatesOf(const ClipperLib::IntPoint& p) {
  return {p.X, p.Y};
}

bool areEqual(const std::vector<Vector3d>& directions) {
  return std::ranges::all_of(directions, [&](const Vector3d& d) {
    return (d - directions.front()).squaredNorm() < kSameDirection * kSameDirection;
  });
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

bool areAll(const std::vector<double>& values, double wanted, double within) {
  return std::ranges::all_of(values, [&](double v) { return std::abs(v - wanted) <= within; });
}
} // namespace

ClipperLib::Paths PlanePatch::contours() const {
  ClipperLib::Paths all = outline;
  all.insert(all.end(), seams.begin(), seams.end());
  return all;
}

std::optional<PlanePatch> planePatch(const layers::Patch& patch) {
  const std::vector<Vector3d>& vertices = patch.surface.vertices;
  if (patch.surface.empty() || !patch.chart.empty() || !areEqual(patch.direction) ||
      !areEqual(patch.clearDirection))
    return std::nullopt;
  PlanePatch plane;
  plane.direction = patch.direction.front();
  plane.clearDirection = patch.clearDirection.front();
  std::vector<double> heights;
  for (const Vector3d& vertex : vertices)
    heights.push_back(plane.direction.dot(vertex));
  plane.heightMm = medianOf(heights);
  plane.thicknessMm = medianOf(patch.thicknessMm);
  plane.isEven = areAll(heights, plane.heightMm, kSameMm) &&
                 areAll(patch.thicknessMm, plane.thicknessMm, kSameMm);
  if (!areAll(heights, plane.heightMm, plane.thicknessMm))
    return std::nullopt;
  plane.plane_R_work =
      geometry::shortestRotation(plane.direction, Vector3d::UnitZ()).toRotationMatrix();
  for (const std::vector<int>& loop : geometry::boundaryLoops(patch.surface)) {
    const auto inner = std::ranges::count_if(
        loop, [&](int v) { return !patch.innerRim.empty() && patch.innerRim[at(v)] != 0; });
    if (inner != 0 && inner != std::ssize(loop))
      return std::nullopt;
    ClipperLib::Path path;
    for (const int v : loop)
      path.push_back(geometry::pathPoint((plane.plane_R_work * vertices[at(v)]).head<2>()));
    std::ranges::reverse(path); // boundaryLoops() runs opposite to the triangles
    (inner == 0 ? plane.outline : plane.seams).push_back(std::move(path));
  }
  return plane;
}

std::optional<layers::Patch> patchOver(const ClipperLib::Paths& area, const PlanePatch& plane,
                                       const layers::Patch& like) {
  layers::Patch patch;
  layers::takePlace(patch, like);
  std::map<Coordinates, int> number;
  std::vector<Vector2d> points;
  std::vector<std::array<int, 2>> edges;
  for (const ClipperLib::Path& path : area) {
    std::vector<int> loop;
    for (const ClipperLib::IntPoint& p : path) {
      const auto [known, isNew] =
          number.try_emplace(coordinatesOf(p), static_cast<int>(points.size()));
      if (isNew)
        points.push_back(geometry::pointMm(p));
      loop.push_back(known->second);
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (const int a = loop[i], b = loop[(i + 1) % loop.size()]; a != b)
        edges.push_back({a, b});
  }
  const auto triangles = layers::fillRegion(points, edges);
  if (!triangles)
    return std::nullopt;
  if (triangles->empty())
    return patch;
  std::set<Coordinates> onOutline;
  for (const ClipperLib::Path& path : plane.outline)
    for (const ClipperLib::IntPoint& p : path)
      onOutline.insert(coordinatesOf(p));
  patch.surface.triangles = *triangles;
  for (const Vector2d& p : points) {
    patch.surface.vertices.push_back(plane.place(p));
    patch.innerRim.push_back(onOutline.contains(coordinatesOf(geometry::pathPoint(p))) ? 0 : 1);
  }
  if (std::ranges::find(patch.innerRim, 1) == patch.innerRim.end())
    patch.innerRim.clear();
  patch.thicknessMm.assign(points.size(), plane.thicknessMm);
  patch.direction.assign(points.size(), plane.direction);
  patch.clearDirection.assign(points.size(), plane.clearDirection);
  return patch;
}

} // namespace voluta::toolpath
