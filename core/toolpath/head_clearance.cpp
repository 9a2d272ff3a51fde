#include "toolpath/head_clearance.h"

#include "base/units.h"
#include "geometry/convex_polygon.h"
#include "geometry/least_turn.h"

#include <algorithm>
#include <cmath>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kAround = 32;      // points on a section's rim
constexpr double kRimStep = 2.0; // mm along the platform's edge
} // namespace

HeadClearance::HeadClearance(const process::Process& process, std::vector<Vector2d> platform)
    : platform_(std::move(platform)) {
  const auto head = process::erodedHead(process.head, process.contactToleranceMm);
  for (std::size_t i = 1; i < head.sections.size(); ++i) {
    const auto &a = head.sections[i - 1], &b = head.sections[i];
    if (b.zMm > a.zMm)
      frusta_.push_back({{0, 0, -a.zMm}, {0, 0, -b.zMm}, a.radiusMm, b.radiusMm});
  }
  shapes_.assign(frusta_.begin(), frusta_.end());
  for (std::size_t i = 0; i < platform_.size(); ++i) {
    const Vector2d a = platform_[i], ab = platform_[(i + 1) % platform_.size()] - a;
    const int n = std::max(1, static_cast<int>(std::ceil(ab.norm() / kRimStep)));
    for (int k = 0; k < n; ++k)
      rim_.push_back(a + ab * k / n);
  }
}

bool HeadClearance::clears(const collision::GrowingPart& part, const Vector3d& tip,
                           const Vector3d& direction, std::size_t before, double marginMm) const {
  if (!clearsPlatform(tip, direction))
    return false;
  Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
  work_T_tool.linear() = geometry::leastTurn(Vector3d::UnitZ(), -direction).toRotationMatrix();
  work_T_tool.translation() = tip;
  return std::ranges::none_of(shapes_, [&](const robot::Shape& shape) {
    return part.headTouches(shape, work_T_tool, marginMm, before);
  });
}

bool HeadClearance::clearsPlatform(const Vector3d& tip, const Vector3d& d) const {
  if (platform_.empty())
    return true;
  const double tilt = std::sqrt(std::max(0.0, 1 - d.z() * d.z()));
  const Vector3d u = d.unitOrthogonal(), v = d.cross(u);
  for (const robot::Frustum& f : frusta_) {
    const double z0 = tip.z() - f.p0.z() * d.z() - f.r0 * tilt;
    const double z1 = tip.z() - f.p1.z() * d.z() - f.r1 * tilt;
    if (z0 >= 0 && z1 >= 0)
      continue;
    for (const auto& [p, r] : {std::pair{f.p0, f.r0}, std::pair{f.p1, f.r1}})
      for (int k = 0; k < kAround; ++k) {
        const double a = 2 * base::kPi * k / kAround;
        const Vector3d q = tip - p.z() * d + r * (std::cos(a) * u + std::sin(a) * v);
        if (q.z() < 0 && geometry::inConvexPolygon(platform_, q.head<2>()))
          return false;
      }
    for (const Vector2d& r : rim_) {
      const Vector3d q = Vector3d(r.x(), r.y(), 0) - tip;
      const double along = q.dot(d), from = -f.p0.z(), to = -f.p1.z();
      if (along <= from || along >= to)
        continue;
      const double radius = f.r0 + (f.r1 - f.r0) * (along - from) / (to - from);
      if ((q - along * d).squaredNorm() < radius * radius)
        return false;
    }
  }
  return true;
}

} // namespace voluta::toolpath
