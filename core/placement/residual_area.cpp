#include "placement/residual_area.h"

#include "base/units.h"
#include "geometry/convex_polygon.h"
#include "geometry/edges.h"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

namespace voluta::placement {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kPathUnits = 1e6; // of Clipper's integers, per mm

std::vector<Vector2d> projected(const geometry::TriangleMesh& mesh, const ProjectionPlane& plane) {
  std::vector<Vector2d> out;
  out.reserve(mesh.vertices.size());
  for (const Vector3d& v : mesh.vertices)
    out.emplace_back(plane * v);
  return out;
}

// Returns the loops of edges between faces that look towards the viewer and others. Every point of
// the projection is enclosed at least once, counter-clockwise.
ClipperLib::Paths silhouette(const geometry::TriangleMesh& mesh,
                             const std::vector<Vector2d>& points) {
  const auto at = [&](int v) -> const Vector2d& { return points[static_cast<std::size_t>(v)]; };
  std::vector<bool> towards;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector2d u = at(b) - at(a), v = at(c) - at(a);
    towards.push_back(u.x() * v.y() - u.y() * v.x() > 0.0);
  }
  std::vector<std::vector<int>> next(points.size());
  const std::vector<geometry::HalfEdge> sides = geometry::sortedHalfEdges(mesh);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    int net = 0; // faces towards the viewer that run from low to high, less those that run back
    for (std::size_t i = begin; i < end; ++i)
      if (const auto t = static_cast<std::size_t>(sides[i].triangle); towards[t])
        net += sides[i].forward ? 1 : -1;
    for (; net > 0; --net)
      next[static_cast<std::size_t>(sides[begin].low)].push_back(sides[begin].high);
    for (; net < 0; ++net)
      next[static_cast<std::size_t>(sides[begin].high)].push_back(sides[begin].low);
  });
  ClipperLib::Paths loops;
  for (std::size_t start = 0; start < next.size(); ++start)
    while (!next[start].empty()) {
      ClipperLib::Path loop;
      for (std::size_t v = start; !next[v].empty();) {
        loop.emplace_back(std::llround(kPathUnits * points[v].x()),
                          std::llround(kPathUnits * points[v].y()));
        const int to = next[v].back();
        next[v].pop_back();
        v = static_cast<std::size_t>(to);
      }
      loops.push_back(std::move(loop));
    }
  return loops;
}

struct MinAreaAngle {
  double angleRad = 0.0;
  std::size_t tried = 0;
};

// Returns the angle of the least bounding rectangle.
MinAreaAngle minAreaAngle(const std::vector<Vector2d>& hull, bool quarterTurns,
                          const std::function<bool(double angleRad)>& allowed) {
  constexpr double kStays = 0.998, kEqual = 1e-9; // of the area
  MinAreaAngle out;
  const double present = rectangleArea(hull, 0.0);
  double best = 0.0, minimum = present;
  const auto consider = [&](double degrees) {
    if (!allowed(base::degreesToRadians(degrees)))
      return;
    ++out.tried;
    const double area = rectangleArea(hull, base::degreesToRadians(degrees));
    if (area < (1.0 - kEqual) * minimum) {
      minimum = area;
      best = degrees;
    }
  };
  for (int degrees = quarterTurns ? 90 : 1; degrees <= 90; ++degrees) {
    consider(-degrees);
    if (degrees < 90)
      consider(degrees);
  }
  for (const double step : {0.1, 0.01}) {
    if (quarterTurns)
      break;
    const double from = best;
    for (int i = 1; i <= 10; ++i) {
      consider(from - step * i);
      consider(from + step * i);
    }
  }
  if (minimum < kStays * present)
    out.angleRad = base::degreesToRadians(best);
  return out;
}

} // namespace

ProjectionPlane xyPlane() {
  return (ProjectionPlane() << 1, 0, 0, 0, 1, 0).finished();
}

ProjectionPlane xzPlane() {
  return (ProjectionPlane() << 1, 0, 0, 0, 0, 1).finished();
}

double outlineArea(const geometry::TriangleMesh& mesh, const ProjectionPlane& plane) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(silhouette(mesh, projected(mesh, plane)), ClipperLib::ptSubject, true);
  ClipperLib::PolyTree outlines;
  clipper.Execute(ClipperLib::ctUnion, outlines, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  double area = 0.0;
  for (const ClipperLib::PolyNode* outline : outlines.Childs)
    area += std::abs(ClipperLib::Area(outline->Contour));
  return area / (kPathUnits * kPathUnits);
}

double rectangleArea(const std::vector<Vector2d>& points, double angleRad) {
  const Eigen::Rotation2Dd by(angleRad);
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : points)
    box.extend(by * p);
  return box.isEmpty() ? 0.0 : box.volume();
}

ResidualAreas residualAreas(const geometry::TriangleMesh& mesh, const Matrix3d& rotation) {
  const auto on = [&](const ProjectionPlane& axes) {
    const ProjectionPlane plane = axes * rotation;
    return std::max(0.0, rectangleArea(projected(mesh, plane), 0.0) - outlineArea(mesh, plane));
  };
  return {on(xyPlane()), on(xzPlane())};
}

ResidualRotation minResidualRotation(const geometry::TriangleMesh& mesh, bool quarterTurns,
                                     const std::function<bool(const Matrix3d&)>& allowed) {
  ResidualRotation out;
  const auto hullOn = [&](const ProjectionPlane& plane) {
    return geometry::convexPolygon(projected(mesh, plane));
  };
  // The outline's area does not depend on the angle, so that the rectangle decides.
  const MinAreaAngle z = minAreaAngle(hullOn(xyPlane()), quarterTurns, [](double) { return true; });
  const Eigen::Quaterniond aboutZ(Eigen::AngleAxisd(z.angleRad, Vector3d::UnitZ()));
  // A positive rotation about y is clockwise on XZ.
  const auto with = [&](double angleRad) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(-angleRad, Vector3d::UnitY()) * aboutZ);
  };
  const MinAreaAngle y =
      minAreaAngle(hullOn(xzPlane() * aboutZ.toRotationMatrix()), quarterTurns,
                   [&](double angleRad) { return allowed(with(angleRad).toRotationMatrix()); });
  out.rotation = with(y.angleRad).normalized();
  out.tried = z.tried + y.tried;
  out.before = residualAreas(mesh, Matrix3d::Identity());
  out.after = residualAreas(mesh, out.rotation.toRotationMatrix());
  return out;
}

} // namespace voluta::placement
