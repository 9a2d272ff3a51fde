#include "substrate/rod_surface.h"

#include "base/units.h"
#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::substrate {

namespace {
constexpr double kRodChordMm = 1e-3;
}

RodSurface::RodSurface(const platform::RodShape& rod) : rod_(rod), distance_(distanceFrom(rod)) {}

RodSurface::RodSurface(const platform::RodShape& rod,
                       std::shared_ptr<const geometry::TriangleMesh> body)
    : rod_(rod), body_(std::move(body)), query_(std::make_shared<geometry::MeshQuery>(*body_)),
      distance_(nearestOf({distanceFrom(rod), distanceFrom(*body_)})) {
  for (const Eigen::Vector3d& p : body_->vertices)
    beyondMm_ = std::max(beyondMm_, p.tail<2>().norm() + 1.0);
}

double RodSurface::radiusAt(double x, double angle) const {
  const double rod = platform::radiusAt(rod_, x, angle);
  if (!query_)
    return rod;
  const Eigen::Vector3d out(0.0, std::cos(angle), std::sin(angle));
  const Eigen::Vector3d axis(x, 0.0, 0.0);
  const auto hit = query_->firstHit(axis + beyondMm_ * out, axis);
  return hit ? std::max(rod, (1.0 - hit->t) * beyondMm_) : rod;
}

double RodSurface::over(const Eigen::Vector3d& p) const {
  return p.tail<2>().norm() - radiusAt(p.x(), std::atan2(p.z(), p.y()));
}

platform::RadiusRange RodSurface::radiiBetween(double x0, double x1) const {
  platform::RadiusRange range = platform::radiiBetween(rod_, x0, x1);
  if (!query_)
    return range;
  constexpr int kAround = 360;
  const int steps = std::max(1, static_cast<int>(std::ceil((x1 - x0) / kSampleMm)));
  double minimum = range.maxMm, maximum = range.maxMm;
  bool any = false;
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; k < kAround; ++k) {
      // Not at the ends, which may be end faces of the body.
      const double x = x0 + (x1 - x0) * (i + 0.5) / (steps + 1);
      const double r = radiusAt(x, 2.0 * base::kPi * k / kAround);
      minimum = any ? std::min(minimum, r) : r;
      maximum = std::max(maximum, r);
      any = true;
    }
  return {minimum, maximum};
}

std::vector<geometry::TriangleMesh> RodSurface::solids() const {
  std::vector<geometry::TriangleMesh> all{platform::meshOf(rod_, kRodChordMm)};
  if (body_)
    all.push_back(*body_);
  return all;
}

} // namespace voluta::substrate
