#include "planar/plate_contact.h"

#include "geometry/convex_polygon.h"
#include "geometry/measures.h"
#include "planar/head_reach.h"

#include <algorithm>

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
  return geometry::convexPolygon(std::move(points), std::max(0.0, platform.marginMm));
}

std::vector<Eigen::Vector2d> plateOf(const std::vector<Piece>& pieces,
                                     const PlanarOptions& options) {
  for (const Piece& piece : pieces)
    if (piece.baseTag == kPlate)
      return plateUnder(piece, options);
  return options.platform.polygon;
}

std::vector<Eigen::Vector3d> carrierSamples(const PlanarPlatform& platform, double spacingMm) {
  std::vector<Eigen::Vector3d> points;
  for (const StemFrustum& frustum : platform.stem) {
    const auto more = frustumSamples(frustum.lowMm, frustum.highMm, frustum.lowRadiusMm,
                                     frustum.highRadiusMm, spacingMm);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

std::vector<Eigen::Vector3d> withPlate(std::vector<Eigen::Vector3d> points, const Piece& piece,
                                       const PlanarOptions& options, double spacingMm) {
  if (piece.baseTag != kPlate)
    return points;
  for (const auto& more :
       {plateSamples(plateUnder(piece, options), options.platform.thicknessMm, spacingMm),
        carrierSamples(options.platform, spacingMm)})
    points.insert(points.end(), more.begin(), more.end());
  return points;
}

PlanarOptions withLessContact(const PlanarOptions& options) {
  constexpr double kLess = 0.4;
  PlanarOptions less = options;
  less.keptContact *= options.keptContact < 1.0 ? kLess : 1.0;
  less.keptHull *= options.keptHull < 1.0 ? kLess : 1.0;
  return less;
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
