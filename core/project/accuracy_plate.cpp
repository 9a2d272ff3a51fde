#include "project/accuracy_plate.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/edges.h"
#include "planar/slicing/region_mesh.h"

#include <cmath>

namespace voluta::project {

namespace {
using Eigen::Vector2d;

// Closed contours as points and edges.
struct Contours {
  std::vector<Vector2d> points;
  std::vector<std::array<int, 2>> edges;

  void add(const std::vector<Vector2d>& loop) {
    const auto first = static_cast<int>(points.size()), count = static_cast<int>(loop.size());
    points.insert(points.end(), loop.begin(), loop.end());
    for (int i = 0; i < count; ++i)
      edges.push_back({first + i, first + (i + 1) % count});
  }
};

// Chords stay within 0.001 mm of the circle.
std::vector<Vector2d> arc(const Vector2d& centre, double radius, double fromDeg, double toDeg,
                          int steps) {
  std::vector<Vector2d> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = base::degreesToRadians(fromDeg + (toDeg - fromDeg) * i / steps);
    points.push_back(centre + radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

std::vector<Vector2d> rectangle(const Vector2d& low, const Vector2d& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

Contours contoursOf(const AccuracyPlate& plate) {
  constexpr double kHoleFromEndMm = 12.0, kSlotBehindMm = 11.0;
  constexpr int kCornerSteps = 48, kHoleSteps = 192;
  const Vector2d high(0.5 * plate.lengthMm, 0.5 * plate.widthMm), low = -high;
  Contours contours;
  std::vector<Vector2d> outline{low};
  for (const Vector2d& p : arc({high.x() - plate.cornerMm, low.y() + plate.cornerMm},
                               plate.cornerMm, -90.0, 0.0, kCornerSteps))
    outline.push_back(p);
  outline.push_back(high);
  outline.emplace_back(low.x(), high.y());
  contours.add(outline);
  const Vector2d hole(low.x() + kHoleFromEndMm, 0.0);
  std::vector<Vector2d> circle = arc(hole, 0.5 * plate.holeDiameterMm, 0.0, 360.0, kHoleSteps);
  circle.pop_back();
  contours.add(circle);
  const double slotX = hole.x() + kSlotBehindMm;
  contours.add(rectangle({slotX, -0.5 * plate.slotWidthMm},
                         {slotX + plate.slotLengthMm, 0.5 * plate.slotWidthMm}));
  return contours;
}
} // namespace

AccuracyPlate accuracyPlate(double lengthMm) {
  constexpr double kShortestMm = 50.0, kLongMm = 200.0;
  base::require(lengthMm >= kShortestMm, "accuracyPlate: long enough for its hole and slot");
  AccuracyPlate plate;
  plate.lengthMm = lengthMm;
  plate.slotLengthMm = lengthMm - (lengthMm < kLongMm ? 40.0 : 50.0);
  return plate;
}

geometry::TriangleMesh accuracyPlateMesh(const AccuracyPlate& plate) {
  constexpr double kEdgeMm = 20.0;
  const Contours contours = contoursOf(plate);
  const auto region = planar::meshRegion(contours.points, contours.edges, kEdgeMm);
  base::require(region.has_value(), "accuracyPlateMesh: contours that do not cross");
  geometry::TriangleMesh mesh;
  const auto count = static_cast<int>(region->points.size());
  for (const double z : {0.0, plate.heightMm})
    for (const Vector2d& p : region->points)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  geometry::TriangleMesh top; // for its boundary
  top.vertices = mesh.vertices;
  for (const auto& [a, b, c] : region->triangles) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({count + a, count + b, count + c});
    top.triangles.push_back({a, b, c});
  }
  const std::vector<geometry::HalfEdge> edges = geometry::sortedHalfEdges(top);
  geometry::forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 1)
      return;
    const geometry::HalfEdge& e = edges[begin];
    const int a = e.forward ? e.low : e.high, b = e.forward ? e.high : e.low;
    mesh.triangles.push_back({a, b, count + b});
    mesh.triangles.push_back({a, count + b, count + a});
  });
  return mesh;
}

} // namespace voluta::project
