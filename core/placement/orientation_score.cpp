#include "placement/orientation_score.h"

#include "base/error.h"
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
      leastContact_(kLeastContact * std::pow(std::abs(geometry::volume(mesh)), 2.0 / 3.0)) {
  base::require(!mesh.empty() && contactDepthMm > 0.0, "OrientationMeasure: facets, a depth > 0");
  normal_.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    normal_.push_back(
        0.5 * (mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)));
}

OrientationScore OrientationMeasure::of(const Eigen::Matrix3d& turn) const {
  const Eigen::Vector3d up = turn.row(2).transpose();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::vector<double> z(mesh_.vertices.size());
  for (std::size_t v = 0; v < z.size(); ++v)
    z[v] = up.dot(mesh_.vertices[v]);
  for (const auto& triangle : mesh_.triangles)
    for (const int v : triangle) {
      low = std::min(low, z[static_cast<std::size_t>(v)]);
      high = std::max(high, z[static_cast<std::size_t>(v)]);
    }
  OrientationScore out;
  out.heightMm = high - low;
  for (std::size_t t = 0; t < normal_.size(); ++t) {
    const double down = -up.dot(normal_[t]);
    if (down <= 0.0)
      continue;
    double middle = 0.0;
    for (const int v : mesh_.triangles[t])
      middle += z[static_cast<std::size_t>(v)] / 3.0;
    const double area = normal_[t].norm();
    if (middle - low <= depth_)
      out.contactMm2 += down;
    else if (down > sine_ * area)
      out.riskyMm2 += area;
  }
  out.stands = out.contactMm2 >= leastContact_;
  return out;
}

std::vector<Eigen::Vector3d> OrientationMeasure::flatPlaces(std::size_t most) const {
  constexpr double kSteps = 30.0; // of a unit normal's coordinates
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
  sorted.resize(std::min(most, sorted.size()));
  for (Eigen::Vector3d& n : sorted)
    n.normalize();
  return sorted;
}

} // namespace voluta::placement
