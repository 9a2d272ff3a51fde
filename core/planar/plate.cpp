#include "planar/plate.h"

#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "planar/head_reach.h"

#include <cmath>
#include <numbers>

namespace voluta::planar {

namespace {

double cross(const Eigen::Vector2d& o, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

double polygonArea(const std::vector<Eigen::Vector2d>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon[0], polygon[i], polygon[i + 1]);
  return 0.5 * twice;
}

} // namespace

std::vector<Eigen::Vector2d> plateUnder(const Piece& piece, const PlanarOptions& options) {
  const PlanarPlatform& platform = options.platform;
  if (!platform.polygon.empty() || piece.baseTag != kPlate)
    return platform.polygon;
  std::vector<Eigen::Vector2d> points;
  const std::vector<std::uint8_t> stands = standsOn(piece, options.rule);
  for (std::size_t t = 0; t < stands.size(); ++t)
    for (int k = 0; stands[t] && k < 3; ++k)
      points.push_back(piece.solid.mesh.corner(t, k).head<2>());
  points = geometry::convexPolygon(std::move(points));
  if (platform.marginMm <= 0.0)
    return points;
  // Sum with a polygon about the disc of the margin.
  constexpr int kSides = 16;
  const double radius = platform.marginMm / std::cos(std::numbers::pi / kSides);
  std::vector<Eigen::Vector2d> wider;
  for (const Eigen::Vector2d& p : points)
    for (int i = 0; i < kSides; ++i) {
      const double turn = std::numbers::pi * (2 * i + 1) / kSides;
      wider.emplace_back(p + radius * Eigen::Vector2d(std::cos(turn), std::sin(turn)));
    }
  return geometry::convexPolygon(std::move(wider));
}

std::vector<Eigen::Vector2d> plateOf(const std::vector<Piece>& pieces,
                                     const PlanarOptions& options) {
  for (const Piece& piece : pieces)
    if (piece.baseTag == kPlate)
      return plateUnder(piece, options);
  return options.platform.polygon;
}

std::vector<Eigen::Vector3d> withPlate(std::vector<Eigen::Vector3d> points, const Piece& piece,
                                       const PlanarOptions& options, double spacingMm) {
  if (piece.baseTag != kPlate)
    return points;
  const auto add = [&](const std::vector<Eigen::Vector3d>& more) {
    points.insert(points.end(), more.begin(), more.end());
  };
  add(plateSamples(plateUnder(piece, options), options.platform.thicknessMm, spacingMm));
  for (const StemFrustum& frustum : options.platform.stem)
    add(frustumSamples(frustum.lowMm, frustum.highMm, frustum.lowRadiusMm, frustum.highRadiusMm,
                       spacingMm));
  return points;
}

Footing footingOf(const Piece& piece, const RiskRule& rule) {
  return footingBelow(piece, standsOn(piece, rule), {Eigen::Vector3d::UnitZ(), 1e300});
}

Footing footingBelow(const Piece& piece, const std::vector<std::uint8_t>& stands,
                     const Plane& plane) {
  Footing out;
  std::vector<Eigen::Vector2d> points;
  for (std::size_t t = 0; t < stands.size(); ++t) {
    if (!stands[t])
      continue;
    bool all = true;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d& c = piece.solid.mesh.corner(t, k);
      if (plane.heightOf(c) <= 0.0)
        points.push_back(c.head<2>());
      else
        all = false;
    }
    out.contactMm2 += all ? geometry::triangleArea(piece.solid.mesh, t) : 0.0;
  }
  out.hullMm2 = polygonArea(geometry::convexPolygon(std::move(points)));
  return out;
}

} // namespace voluta::planar
