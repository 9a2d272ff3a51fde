#include "placement/orientation_score.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/convex_polygon.h"
#include "geometry/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace voluta::placement {

OrientationMeasure::OrientationMeasure(const geometry::TriangleMesh& mesh, double contactDepthMm,
                                       double overhangRad)
    : mesh_(mesh), depth_(contactDepthMm), sine_(std::sin(overhangRad)),
      minContact_(kMinContact * std::pow(std::abs(geometry::volume(mesh)), 2.0 / 3.0)) {
  base::require(!mesh.empty() && contactDepthMm > 0.0, "OrientationMeasure: facets, a depth > 0");
  normal_.reserve(mesh.triangles.size());
  const Eigen::Vector3d middle = geometry::bounds(mesh).center();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double volume = 0.0; // six times the volume
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d a = mesh.corner(t, 0) - middle, b = mesh.corner(t, 1) - middle,
                          c = mesh.corner(t, 2) - middle;
    normal_.push_back(0.5 * (b - a).cross(c - a));
    const double six = a.dot(b.cross(c));
    sum += six / 4.0 * (a + b + c);
    volume += six;
  }
  centre_ = std::abs(volume) > 1e-9 ? Eigen::Vector3d(middle + sum / volume) : middle;
}

OrientationMeasure::Heights OrientationMeasure::heights(const Eigen::Vector3d& up) const {
  Heights out{{}, std::numeric_limits<double>::infinity(), 0.0};
  out.high = -out.low;
  out.middle.reserve(mesh_.triangles.size());
  std::vector<double> z(mesh_.vertices.size());
  for (std::size_t v = 0; v < z.size(); ++v)
    z[v] = up.dot(mesh_.vertices[v]);
  for (const auto& triangle : mesh_.triangles) {
    double middle = 0.0;
    for (const int v : triangle) {
      const double at = z[static_cast<std::size_t>(v)];
      out.low = std::min(out.low, at);
      out.high = std::max(out.high, at);
      middle += at / 3.0;
    }
    out.middle.push_back(middle);
  }
  return out;
}

OrientationScore OrientationMeasure::of(const Eigen::Matrix3d& rotation) const {
  const Eigen::Vector3d up = rotation.row(2).transpose();
  const Heights z = heights(up);
  OrientationScore out;
  out.heightMm = z.high - z.low;
  out.middleMm = up.dot(centre_) - z.low;
  for (std::size_t t = 0; t < normal_.size(); ++t) {
    const double down = -up.dot(normal_[t]);
    if (down <= 0.0)
      continue;
    const double area = normal_[t].norm();
    if (z.middle[t] - z.low <= depth_)
      out.contactMm2 += down;
    else if (down > sine_ * area)
      out.riskyMm2 += area;
  }
  out.stands = out.contactMm2 >= minContact_;
  return out;
}

bool OrientationMeasure::balances(const Eigen::Matrix3d& rotation) const {
  const Heights z = heights(rotation.row(2).transpose());
  std::vector<Eigen::Vector2d> touching;
  for (std::size_t t = 0; t < normal_.size(); ++t)
    if (rotation.row(2).dot(normal_[t]) < 0.0 && z.middle[t] - z.low <= depth_)
      for (int k = 0; k < 3; ++k)
        touching.emplace_back((rotation * mesh_.corner(t, k)).head<2>());
  return geometry::inConvexPolygon(geometry::convexPolygon(std::move(touching)),
                                   (rotation * centre_).head<2>());
}

Eigen::Vector3d OrientationMeasure::settled(const Eigen::Vector3d& down) const {
  const double near = std::cos(base::degreesToRadians(1.0));
  const Heights z = heights(-down);
  Eigen::Vector3d flat = Eigen::Vector3d::Zero();
  double contact = 0.0;
  for (std::size_t t = 0; t < normal_.size(); ++t) {
    const double facing = down.dot(normal_[t]);
    if (facing <= 0.0 || z.middle[t] - z.low > depth_)
      continue;
    contact += facing;
    if (facing >= near * normal_[t].norm())
      flat += normal_[t];
  }
  return flat.norm() >= 0.5 * contact && contact > 0.0 ? flat.normalized() : down;
}

std::vector<Eigen::Vector3d> OrientationMeasure::flatPlaces(std::size_t maxCount) const {
  constexpr double kSteps = 30.0; // per unit of a normal's coordinates
  std::map<std::array<int, 3>, Eigen::Vector3d> places;
  for (const Eigen::Vector3d& n : normal_) {
    const double area = n.norm();
    if (area == 0.0)
      continue;
    std::array<int, 3> key{};
    for (int a = 0; a < 3; ++a)
      key[static_cast<std::size_t>(a)] = static_cast<int>(std::lround(kSteps * n[a] / area));
    places.try_emplace(key, Eigen::Vector3d::Zero()).first->second += n;
  }
  std::vector<Eigen::Vector3d> sorted;
  for (const auto& [key, sum] : places)
    sorted.push_back(sum);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.squaredNorm() > b.squaredNorm(); });
  sorted.resize(std::min(maxCount, sorted.size()));
  for (Eigen::Vector3d& n : sorted)
    n.normalize();
  return sorted;
}

} // namespace voluta::placement
