#include "pipeline/cell_plate.h"

#include "base/error.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "project/platform.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

using Eigen::Vector2d;

constexpr double kRoomMm = 3.0;     // about what stands on a plate
constexpr double kStandingMm = 0.5; // a part's lowest points, as far as they count as its foot

} // namespace

std::vector<Vector2d> cellPlate(const robot::Cell& cell, const geometry::TriangleMesh& part,
                                bool supports) {
  if (cell.plates().empty())
    throw base::Error(base::ErrorCode::Usage,
                      base::message("cell {cell} comes without plates"_text, cell.id()), {},
                      "give --platform disc:DIAMETER, or another platform"_text);
  const double lowest = geometry::bounds(part).min().z();
  std::vector<Vector2d> points;
  for (const Eigen::Vector3d& v : part.vertices)
    if (supports || v.z() <= lowest + kStandingMm)
      points.emplace_back(v.head<2>());
  points = geometry::convexPolygon(std::move(points), kRoomMm);
  std::vector<Vector2d> plate;
  for (const std::string& text : cell.plates()) {
    plate = project::Platform(text).plateAround({});
    if (std::all_of(points.begin(), points.end(),
                    [&](const Vector2d& p) { return geometry::inConvexPolygon(plate, p); }))
      break;
  }
  return plate;
}

} // namespace voluta::pipeline
