#include "sampled_distance.h"

#include "base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::test {

namespace {

using Eigen::Vector3d;

double boxDistance(const Vector3d& p, const Vector3d& half) {
  const Vector3d out = p.cwiseAbs() - half;
  return out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff());
}

double signedDistanceTo(const Vector3d& p, const robot::Capsule& c) {
  const Vector3d axis = c.p1 - c.p0;
  const double length2 = axis.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - c.p0).dot(axis) / length2, 0.0, 1.0) : 0.0;
  return (p - c.p0 - t * axis).norm() - c.radius;
}

double signedDistanceTo(const Vector3d& p, const robot::Box& b) {
  return boxDistance(b.frame_T_box.inverse(Eigen::Isometry) * p, b.half);
}

// In the half plane (along, away from the axis): a trapezium with corners (0,0) (0,r0) (h,r1)
// (h,0).
double signedDistanceTo(const Vector3d& p, const robot::Frustum& f) {
  const Vector3d axis = (f.p1 - f.p0).normalized();
  const double h = (f.p1 - f.p0).norm(), z = (p - f.p0).dot(axis);
  const double r = (p - f.p0 - z * axis).norm();
  const auto toSegment = [&](double z0, double r0, double z1, double r1) {
    const double dz = z1 - z0, dr = r1 - r0, l2 = dz * dz + dr * dr;
    const double t = l2 > 0.0 ? std::clamp(((z - z0) * dz + (r - r0) * dr) / l2, 0.0, 1.0) : 0.0;
    return std::hypot(z - z0 - t * dz, r - r0 - t * dr);
  };
  const double edge =
      std::min({toSegment(0, 0, 0, f.r0), toSegment(0, f.r0, h, f.r1), toSegment(h, f.r1, h, 0)});
  const bool inside = z >= 0.0 && z <= h && r <= f.r0 + (f.r1 - f.r0) * z / h;
  return inside ? -edge : edge;
}

double signedDistanceTo(const Vector3d& p, const robot::Prism& prism) {
  double across = -std::numeric_limits<double>::infinity();
  const std::size_t n = prism.polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = prism.polygon[i], &b = prism.polygon[(i + 1) % n];
    const Eigen::Vector2d out = Eigen::Vector2d(b.y() - a.y(), a.x() - b.x()).normalized();
    across = std::max(across, out.dot(p.head<2>() - a));
  }
  const double along = std::max(prism.zMin - p.z(), p.z() - prism.zMax);
  return std::hypot(std::max(across, 0.0), std::max(along, 0.0)) +
         std::min(0.0, std::max(across, along));
}

int steps(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

void addSamples(const robot::Capsule& c, double spacing, std::vector<Sample>& out) {
  const double length = (c.p1 - c.p0).norm();
  const int n = length > 0.0 ? steps(length, spacing) : 0;
  for (int i = 0; i <= n; ++i)
    out.push_back({n == 0 ? c.p0 : Vector3d(c.p0 + (c.p1 - c.p0) * i / n), c.radius});
}

void addSamples(const robot::Box& b, double spacing, std::vector<Sample>& out) {
  const Eigen::Vector3i n(steps(2 * b.half.x(), spacing), steps(2 * b.half.y(), spacing),
                          steps(2 * b.half.z(), spacing));
  for (int i = 0; i <= n.x(); ++i)
    for (int j = 0; j <= n.y(); ++j)
      for (int k = 0; k <= n.z(); ++k)
        if (i == 0 || i == n.x() || j == 0 || j == n.y() || k == 0 || k == n.z())
          out.push_back({b.frame_T_box * Vector3d(b.half.x() * (2.0 * i / n.x() - 1),
                                                  b.half.y() * (2.0 * j / n.y() - 1),
                                                  b.half.z() * (2.0 * k / n.z() - 1)),
                         0.0});
}

void addSamples(const robot::Frustum& f, double spacing, std::vector<Sample>& out) {
  const Vector3d axis = (f.p1 - f.p0).normalized();
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const int n = steps((f.p1 - f.p0).norm(), spacing);
  for (int i = 0; i <= n; ++i) {
    const double r = f.r0 + (f.r1 - f.r0) * i / n;
    const int around = std::max(8, steps(2 * base::kPi * r, spacing));
    for (int k = 0; k < around; ++k) {
      const double a = 2 * base::kPi * k / around;
      out.push_back({f.p0 + (f.p1 - f.p0) * i / n + r * (std::cos(a) * u + std::sin(a) * v), 0.0});
    }
  }
}

void addSamples(const robot::Prism& p, double spacing, std::vector<Sample>& out) {
  const std::size_t n = p.polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = p.polygon[i], &b = p.polygon[(i + 1) % n];
    const int along = steps((b - a).norm(), spacing);
    for (int k = 0; k < along; ++k)
      for (double z : {p.zMin, p.zMax}) {
        const Eigen::Vector2d edge = a + (b - a) * k / along;
        out.push_back({Vector3d(edge.x(), edge.y(), z), 0.0});
      }
  }
}

} // namespace

double signedDistance(const Vector3d& point, const robot::Shape& shape) {
  return std::visit([&](const auto& s) { return signedDistanceTo(point, s); }, shape);
}

std::vector<Sample> samplesOf(const robot::Body& body, double spacingMm) {
  std::vector<Sample> out;
  for (const robot::Shape& shape : body.shapes)
    std::visit([&](const auto& s) { addSamples(s, spacingMm, out); }, shape);
  return out;
}

double sampledDistance(const std::vector<Sample>& samples, const Eigen::Isometry3d& samplesPose,
                       const robot::Body& body, const Eigen::Isometry3d& bodyPose, double floorMm) {
  double minimum = std::numeric_limits<double>::infinity();
  const Eigen::Isometry3d body_T_samples = bodyPose.inverse() * samplesPose;
  for (const Sample& sample : samples) {
    const Vector3d p = body_T_samples * sample.point;
    for (const robot::Shape& shape : body.shapes)
      minimum = std::min(minimum, signedDistance(p, shape) - sample.radius);
    if (minimum <= floorMm)
      return minimum;
  }
  return minimum;
}

} // namespace voluta::test
