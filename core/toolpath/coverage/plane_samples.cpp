#include "toolpath/coverage/plane_samples.h"

#include "base/error.h"
#include "base/index.h"
#include "base/mixed_bits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>

namespace voluta::toolpath {

namespace {
using base::at;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kMaxCells = 1 << 24;

// Returns two pseudo-random numbers in [0, 1), determined by `number`.
Eigen::Vector2f placeInCell(std::uint64_t number) {
  const std::uint64_t z = base::mixedBits((number + 1) * 0x9e3779b97f4a7c15U);
  constexpr float kUnit = 1.0F / (1 << 24);
  return {kUnit * static_cast<float>(z >> 40U), kUnit * static_cast<float>(z & 0xffffffU)};
}

constexpr std::size_t kTile = 64; // Cells after which the point positions repeat

std::vector<Eigen::Vector2f> placesInTile(float pitch) {
  std::vector<Eigen::Vector2f> places(kTile * kTile);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = pitch * placeInCell(i);
  return places;
}

// Determines on which side of an edge points are, four at a time: >= 0 is to the left. Evaluated
// with the edge's ends in a fixed order, so that two triangles that share the edge agree about each
// point.
class EdgeSide {
public:
  EdgeSide(const std::array<int, 3>& corners, const std::array<Vector2d, 3>& places,
           std::size_t k) {
    const std::size_t next = (k + 1) % 3;
    const bool forwards = corners[k] < corners[next];
    const Eigen::Vector2f from = places[forwards ? k : next].cast<float>(),
                          to = places[forwards ? next : k].cast<float>();
    sign_ = forwards ? 1.0F : -1.0F;
    x_ = from.x();
    y_ = from.y();
    alongX_ = to.x() - from.x();
    alongY_ = to.y() - from.y();
  }
  Floats of(const Floats& x, const Floats& y) const {
    return sign_ * (alongX_ * (y - y_) - alongY_ * (x - x_));
  }

private:
  float sign_, x_, y_, alongX_, alongY_;
};

// Returns twice the signed area of a b p; positive to the left of a b.
double side(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}
} // namespace

std::optional<PlaneSamples> PlaneSamples::of(const PatchSurface& s, double sampleMm2,
                                             const std::vector<char>& leftOut) {
  base::require(sampleMm2 > 0, "samples stand for an area");
  base::require(leftOut.empty() || leftOut.size() == s.triangles.size(),
                "samples are left out by triangles");
  if (!s.planeNormal)
    return std::nullopt;
  PlaneSamples p;
  p.normal_ = *s.planeNormal;
  p.across_ = p.normal_.unitOrthogonal();
  p.up_ = p.normal_.cross(p.across_);
  p.offsetMm_ = p.normal_.dot(s.position.front());
  p.pitch_ = std::sqrt(sampleMm2);
  Vector2d high = Vector2d::Constant(-INFINITY);
  p.low_ = -high;
  for (const Vector3d& v : s.position) {
    const Vector2d q(p.across_.dot(v), p.up_.dot(v));
    p.low_ = p.low_.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Vector2d cells = ((high - p.low_) / p.pitch_).array().floor() + 1.0;
  if (!(cells.prod() <= kMaxCells))
    return std::nullopt;
  p.size_ = cells.cast<int>();
  p.paint(s, leftOut);
  const auto inside =
      std::ranges::count_if(p.triangle_, [](int triangle) { return triangle >= 0; });
  if (inside == 0)
    return std::nullopt;
  double areaMm2 = s.areaMm2;
  for (std::size_t t = 0; t < leftOut.size(); ++t)
    areaMm2 -= leftOut[t] ? s.triangleArea[t] : 0.0;
  p.areaMm2_ = areaMm2 / static_cast<double>(inside);
  return p;
}

void PlaneSamples::paint(const PatchSurface& s, const std::vector<char>& leftOut) {
  const std::size_t n = at(size_.x()) * at(size_.y());
  x_.resize(n + kLanes - 1);
  y_.resize(n + kLanes - 1);
  triangle_.assign(n, -1);
  thicknessMm_.assign(n, 0.0F);
  const auto pitch = static_cast<float>(pitch_);
  const std::vector<Eigen::Vector2f> tile = placesInTile(pitch);
  for (int y = 0; y < size_.y(); ++y) {
    const Eigen::Vector2f* places = &tile[at(y) % kTile * kTile];
    const std::size_t row = at(y) * at(size_.x());
    for (int x = 0; x < size_.x(); ++x) {
      const Eigen::Vector2f& place = places[at(x) % kTile];
      x_[row + at(x)] = pitch * static_cast<float>(x) + place.x();
      y_[row + at(x)] = pitch * static_cast<float>(y) + place.y();
    }
  }
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    if (!leftOut.empty() && leftOut[t])
      continue;
    const auto& corners = s.triangles[t];
    const Vector2d a = flat(s.position[at(corners[0])]), b = flat(s.position[at(corners[1])]),
                   c = flat(s.position[at(corners[2])]);
    const double twice = side(a, b, c);
    if (!(twice > 0.0))
      continue;
    const Vector2d minimum = a.cwiseMin(b).cwiseMin(c) / pitch_,
                   maximum = a.cwiseMax(b).cwiseMax(c) / pitch_;
    const int x0 = std::max(0, static_cast<int>(minimum.x())),
              x1 = std::min(size_.x() - 1, static_cast<int>(maximum.x())),
              y0 = std::max(0, static_cast<int>(minimum.y())),
              y1 = std::min(size_.y() - 1, static_cast<int>(maximum.y()));
    const std::array<Vector2d, 3> places{a, b, c};
    // Often constant: skip the interpolation then.
    const double thickness = s.thicknessMm[at(corners[0])];
    const bool isEven =
        thickness == s.thicknessMm[at(corners[1])] && thickness == s.thicknessMm[at(corners[2])];
    const EdgeSide ab(corners, places, 0), bc(corners, places, 1), ca(corners, places, 2);
    for (int y = y0; y <= y1; ++y) {
      const std::size_t end = at(y) * at(size_.x()) + at(x1) + 1;
      for (std::size_t four = at(y) * at(size_.x()) + at(x0); four < end; four += kLanes) {
        const auto qx = base::load<Floats>(&x_[four]), qy = base::load<Floats>(&y_[four]);
        const Floats inside = base::min(base::min(ab.of(qx, qy), bc.of(qx, qy)), ca.of(qx, qy));
        for (std::size_t lane = 0; lane < std::min(end - four, kLanes); ++lane) {
          const std::size_t cell = four + lane;
          if (inside[lane] < 0.0F || triangle_[cell] >= 0)
            continue;
          triangle_[cell] = static_cast<int>(t);
          thicknessMm_[cell] = static_cast<float>(thickness);
          if (isEven)
            continue;
          const Vector2d q(x_[cell], y_[cell]);
          const double u = side(b, c, q), v = side(c, a, q), w = twice - u - v;
          thicknessMm_[cell] = static_cast<float>((u * s.thicknessMm[at(corners[0])] +
                                                   v * s.thicknessMm[at(corners[1])] +
                                                   w * s.thicknessMm[at(corners[2])]) /
                                                  twice);
        }
      }
    }
  }
}

SurfaceSample PlaneSamples::sample(std::size_t cell) const {
  const Vector2d q = Vector2d(x_[cell], y_[cell]) + low_;
  return {q.x() * across_ + q.y() * up_ + offsetMm_ * normal_,
          static_cast<double>(thicknessMm_[cell]), areaMm2_,
          static_cast<std::size_t>(triangle_[cell])};
}

} // namespace voluta::toolpath
