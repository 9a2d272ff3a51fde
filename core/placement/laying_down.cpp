#include "placement/laying_down.h"

#include "base/units.h"
#include "curved/convex_hull.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "geometry/symmetric_axes.h"
#include "placement/residual_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace voluta::placement {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kRegressions = 3, kMaxRounds = 10;
constexpr double kBetter = 1.0 - 1e-6; // of an area or a volume
constexpr double kSettledRad = base::degreesToRadians(0.01);

// A plane of projection, and the axis about which the part turns in it: from `first` to `second`.
struct Plane {
  int first, second, axis;
};
constexpr Plane kXy{0, 1, 2}, kYz{1, 2, 0}, kZx{2, 0, 1};

// Returns the vertices of the part's convex hull; all vertices of a flat part.
std::vector<Vector3d> hullOf(const geometry::TriangleMesh& part) {
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  const double perMm = (curved::kLatticeLimit - 1.0) / std::max(box.sizes().maxCoeff(), 1e-9);
  std::vector<Vector3d> used;
  for (const Vector3d& v : part.vertices)
    if (box.contains(v)) // others belong to no triangle
      used.push_back(v);
  std::vector<curved::LatticePoint> points;
  for (const Vector3d& v : used)
    points.emplace_back((perMm * (v - box.center())).array().round());
  std::vector<bool> isCorner(used.size());
  bool any = false;
  for (const curved::HullFacet& facet : curved::convexHull(points))
    for (const auto corner : facet.corner)
      any = isCorner[static_cast<std::size_t>(corner)] = true;
  if (!any)
    return used;
  std::vector<Vector3d> hull;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (isCorner[i])
      hull.push_back(used[i]);
  return hull;
}

std::vector<Vector2d> outline(const std::vector<Vector3d>& hull, const Matrix3d& rotation,
                              int first, int second) {
  std::vector<Vector2d> points;
  for (const Vector3d& v : hull)
    points.emplace_back(rotation.row(first).dot(v), rotation.row(second).dot(v));
  return geometry::convexPolygon(std::move(points));
}

// Returns the slope of the regression line through the middles of a convex polygon's sections at
// equal distances along its first axis.
double slopeOfMiddles(const std::vector<Vector2d>& polygon) {
  constexpr int kSections = 50;
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : polygon)
    box.extend(p);
  double sumProduct = 0.0, sumSquare = 0.0;
  for (int k = 0; k < kSections; ++k) {
    const double away = ((k + 0.5) / kSections - 0.5) * box.sizes().x(),
                 at = box.center().x() + away;
    double ends = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.x() <= at) != (b.x() <= at))
        ends += a.y() + (at - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
    }
    sumProduct += away * 0.5 * ends; // the distances' mean is 0
    sumSquare += away * away;
  }
  return sumSquare > 0.0 ? sumProduct / sumSquare : 0.0;
}

// Returns the angle of the regression line from the nearer axis: counter-clockwise in the plane.
double regressionAngle(const std::vector<Vector3d>& hull, const Matrix3d& rotation,
                       const Plane& plane) {
  std::vector<Vector2d> polygon = outline(hull, rotation, plane.first, plane.second);
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : polygon)
    box.extend(p);
  if (box.isEmpty() || box.sizes().minCoeff() <= 0.0)
    return 0.0;
  // Sections across the longer side give the better line.
  const bool isUpright = box.sizes().y() > box.sizes().x();
  if (isUpright)
    for (Vector2d& p : polygon)
      p = {p.y(), -p.x()};
  return std::atan(slopeOfMiddles(polygon));
}

// Returns the angle of the least rectangle around a convex polygon, from -45 to 45 degrees.
double rectangleAngle(const std::vector<Vector2d>& polygon) {
  constexpr double kQuarter = 0.25 * base::kTwoPi;
  double best = 0.0, minimum = rectangleArea(polygon, 0.0);
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 2; ++i) {
    const Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double angle = std::atan2(side.y(), side.x()),
                 nearest = angle - kQuarter * std::round(angle / kQuarter);
    const double area = rectangleArea(polygon, -nearest);
    if (area < kBetter * minimum) {
      minimum = area;
      best = nearest;
    }
  }
  return best;
}

Matrix3d about(int axis, double angleRad) {
  return Eigen::AngleAxisd(angleRad, Vector3d::Unit(axis)).toRotationMatrix();
}

Eigen::AlignedBox3d boxOf(const std::vector<Vector3d>& hull, const Matrix3d& rotation) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : hull)
    box.extend(rotation * v);
  return box;
}

// Returns the rotation of the points' principal axes to x, y and z.
Matrix3d principalAxes(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points)
    mean += p / static_cast<double>(points.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Vector3d& p : points)
    spread += (p - mean) * (p - mean).transpose();
  Matrix3d rotation = geometry::symmetricAxes(spread).axes.transpose();
  if (rotation.determinant() < 0.0)
    rotation.row(2) *= -1.0;
  return rotation;
}

// Returns the quarter turns after which the box's greatest side is along x and the least along z.
Matrix3d sidesInOrder(const Vector3d& sizes) {
  std::array<int, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, [&](int a, int b) { return sizes[a] > sizes[b]; });
  Matrix3d rotation = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    rotation(i, axes[static_cast<std::size_t>(i)]) = 1.0;
  if (rotation.determinant() < 0.0)
    rotation.row(2) *= -1.0;
  return rotation;
}

// Turns the part until the least rectangles around its projections are parallel to the axes.
// Returns the number of rounds.
int settle(const std::vector<Vector3d>& hull, std::initializer_list<Plane> planes,
           Matrix3d& rotation) {
  int rounds = 0;
  for (double greatest = 2.0 * kSettledRad; greatest > kSettledRad && rounds < kMaxRounds;
       ++rounds) {
    greatest = 0.0;
    for (const Plane& plane : planes) {
      const double angle = rectangleAngle(outline(hull, rotation, plane.first, plane.second));
      rotation = about(plane.axis, -angle) * rotation;
      greatest = std::max(greatest, std::abs(angle));
    }
  }
  return rounds;
}

} // namespace

MillingOrientation millingOrientation(const geometry::TriangleMesh& part) {
  const std::vector<Vector3d> hull = hullOf(part);
  Matrix3d rotation = Matrix3d::Identity();
  for (int k = 0; k < kRegressions; ++k)
    for (const Plane& plane : {kZx, kXy, kYz})
      rotation = about(plane.axis, -regressionAngle(hull, rotation, plane)) * rotation;
  MillingOrientation out;
  out.rounds = settle(hull, {kXy, kYz}, rotation);
  settle(hull, {kXy, kYz, kZx}, rotation);
  Matrix3d other = principalAxes(hull);
  settle(hull, {kXy, kYz, kZx}, other);
  if (boxOf(hull, other).volume() < kBetter * boxOf(hull, rotation).volume())
    rotation = other;
  rotation = sidesInOrder(boxOf(hull, rotation).sizes()) * rotation;

  // minResidualRotation() is in the source's axes.
  Matrix3d ours_T_source;
  ours_T_source << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Matrix3d inSource = ours_T_source.transpose() * rotation;
  geometry::TriangleMesh rotated = part;
  for (Vector3d& v : rotated.vertices)
    v = inSource * v;
  const ResidualRotation residual =
      minResidualRotation(rotated, false, [](const Matrix3d&) { return true; });
  rotation = ours_T_source * residual.rotation.toRotationMatrix() * inSource;

  const Eigen::AlignedBox3d present = boxOf(hull, Matrix3d::Identity());
  if (boxOf(hull, rotation).volume() >= kBetter * present.volume())
    rotation = sidesInOrder(present.sizes());
  const double volume = std::abs(geometry::volume(part));
  out.rotation = Eigen::Quaterniond(rotation).normalized();
  out.scrapBeforeMm3 = present.volume() - volume;
  out.scrapMm3 = boxOf(hull, rotation).volume() - volume;
  return out;
}

} // namespace voluta::placement
