#include "collision/polyhedron_distance.h"

#include "base/error.h"
#include "base/units.h"

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <vector>

namespace voluta::collision {

using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

constexpr int kSides = 48;
constexpr double kMinRadius = 1e-3; // FCL requires a polygon, not a point, at the tip of a cone

// Two rings of n vertices each, bottom counter-clockwise seen from above, and their faces.
std::shared_ptr<fcl::Convexd> drum(std::vector<Vector3d> vertices, int n) {
  auto faces = std::make_shared<std::vector<int>>();
  faces->push_back(n);
  for (int i = n - 1; i >= 0; --i)
    faces->push_back(i);
  faces->push_back(n);
  for (int i = 0; i < n; ++i)
    faces->push_back(n + i);
  for (int i = 0; i < n; ++i)
    faces->insert(faces->end(), {4, i, (i + 1) % n, n + (i + 1) % n, n + i});
  return std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Vector3d>>(std::move(vertices)), n + 2, faces);
}

std::shared_ptr<fcl::Convexd> around(const robot::Frustum& f) {
  Vector3d u = f.p1 - f.p0;
  u = u.norm() > 0.0 ? Vector3d(u.normalized()) : Vector3d(Vector3d::UnitZ());
  const Vector3d x = u.unitOrthogonal(), y = u.cross(x);
  const double outward = 1.0 / std::cos(base::kPi / kSides);
  std::vector<Vector3d> vertices;
  for (const auto& [centre, radius] : {std::pair(f.p0, f.r0), std::pair(f.p1, f.r1)})
    for (int i = 0; i < kSides; ++i) {
      const double a = 2.0 * base::kPi * i / kSides;
      vertices.push_back(centre + outward * std::max(radius, kMinRadius) *
                                      (std::cos(a) * x + std::sin(a) * y));
    }
  return drum(std::move(vertices), kSides);
}

std::shared_ptr<fcl::Convexd> around(const robot::Prism& p) {
  std::vector<Vector3d> vertices;
  for (const double z : {p.zMin, p.zMax})
    for (const Eigen::Vector2d& corner : p.polygon)
      vertices.emplace_back(corner.x(), corner.y(), z);
  return drum(std::move(vertices), static_cast<int>(p.polygon.size()));
}

std::shared_ptr<fcl::Convexd> around(const robot::Box& b) {
  std::vector<Vector3d> vertices;
  for (const double z : {-1.0, 1.0})
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
      vertices.push_back(b.frame_T_box * Vector3d(x * b.half.x(), y * b.half.y(), z * b.half.z()));
  return drum(std::move(vertices), 4);
}

std::shared_ptr<fcl::Convexd> around(const robot::Capsule&) {
  base::require(false, "capsules have distances of their own");
  return nullptr;
}

} // namespace

struct Polyhedron::Impl {
  std::shared_ptr<fcl::Convexd> convex;
};

Polyhedron::Polyhedron(const robot::Shape& shape)
    : impl_(std::make_unique<Impl>(
          Impl{std::visit([](const auto& s) { return around(s); }, shape)})) {}
Polyhedron::~Polyhedron() = default;
Polyhedron::Polyhedron(Polyhedron&&) noexcept = default;

double Polyhedron::distance(const Polyhedron& a, const Isometry3d& frame_T_a, const Polyhedron& b,
                            const Isometry3d& frame_T_b) {
  fcl::DistanceRequestd request;
  request.enable_nearest_points = false;
  request.enable_signed_distance = false;
  request.gjk_solver_type = fcl::GJKSolverType::GST_LIBCCD;
  fcl::DistanceResultd result;
  return fcl::distance(a.impl_->convex.get(), frame_T_a, b.impl_->convex.get(), frame_T_b, request,
                       result);
}

} // namespace voluta::collision
