#include "pipeline/cell_plate.h"

#include "base/error.h"
#include "base/parameters.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "modes/region_supports.h"
#include "project/platform.h"
#include "toolpath/prime_path.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {

using Eigen::Vector2d;

constexpr double kRoomMm = 3.0;     // Margin around the foot and the supports
constexpr double kStandingMm = 0.5; // Above the part's lowest point

} // namespace

std::vector<Vector2d> footOf(const geometry::TriangleMesh& part) {
  const double lowest = geometry::bounds(part).min().z();
  std::vector<Vector2d> points;
  for (const Eigen::Vector3d& v : part.vertices)
    if (v.z() <= lowest + kStandingMm)
      points.emplace_back(v.head<2>());
  return geometry::convexPolygon(std::move(points));
}

std::vector<Vector2d> largestPlate(const robot::Cell& cell) {
  return cell.plates().empty() ? std::vector<Vector2d>()
                               : project::Platform(cell.plates().back()).plateAround({});
}

PlateNeeds plateNeeds(const modes::ModeChoices& in) {
  const base::ParameterValues& values = in.values;
  const std::string prime = values.text("prime");
  return {.supports = modes::supportsSomewhere(in),
          .prime = prime != "none",
          .primeIsRing = prime == "skirt",
          .primeLengthMm = values.number("primeLengthMm"),
          .primeBeadMm = std::max(toolpath::kPrimeFromEdgeMm, values.number("beadWidthMm")),
          .brimMm = values.number("brimWidthMm")};
}

std::vector<Vector2d> cellPlate(const robot::Cell& cell, const geometry::TriangleMesh& part,
                                const PlateNeeds& needs) {
  if (cell.plates().empty())
    throw base::Error(base::ErrorCode::Usage,
                      base::message("cell {cell} has no plates"_text, cell.id()), {},
                      "give `--platform disc:DIAMETER`, or another platform"_text);
  std::vector<Vector2d> points;
  if (needs.supports)
    for (const Eigen::Vector3d& v : part.vertices)
      points.emplace_back(v.head<2>());
  else
    points = footOf(part);
  const std::vector<Vector2d> withBrim = geometry::convexPolygon(points, kRoomMm + needs.brimMm);
  points = geometry::convexPolygon(std::move(points), kRoomMm);
  std::vector<Vector2d> plate, carrying;
  const auto carries = [&plate](const std::vector<Vector2d>& all) {
    return std::ranges::all_of(
        all, [&](const Vector2d& p) { return geometry::inConvexPolygon(plate, p); });
  };
  for (const std::string& text : cell.plates()) {
    plate = project::Platform(text).plateAround({});
    if (!carries(points))
      continue;
    if (carries(withBrim) &&
        (!needs.prime || toolpath::hasRoomForPrime(plate, part.vertices, needs.primeIsRing,
                                                   needs.primeLengthMm, needs.primeBeadMm)))
      return plate;
    if (carrying.empty())
      carrying = plate;
  }
  return carrying.empty() ? plate : carrying;
}

} // namespace voluta::pipeline
