#include "planar/head_reach.h"

#include "base/units.h"
#include "geometry/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace voluta::planar {

using Eigen::Vector3d;

std::vector<Vector3d> surfaceSamples(const geometry::TriangleMesh& mesh, double spacingMm) {
  std::vector<Vector3d> points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vector3d &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const double longest =
        std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
    const int n = std::clamp(static_cast<int>(std::ceil(longest / spacingMm)), 1, 200);
    // Samples are the centres of n^2 similar triangles; slivers get only as many as their area
    // requires.
    const double area = geometry::triangleArea(mesh, t);
    const int every =
        std::max(1, static_cast<int>(n * n * spacingMm * spacingMm / (2.0 * area + 1e-9) / 4.0));
    int at = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j, ++at)
        if (at % every == 0)
          points.push_back(a + (b - a) * ((i + 1.0 / 3.0) / n) + (c - a) * ((j + 1.0 / 3.0) / n));
  }
  return points;
}

std::vector<Vector3d> plateSamples(const std::vector<Eigen::Vector2d>& polygon, double thicknessMm,
                                   double spacingMm) {
  if (polygon.size() < 3)
    return {};
  geometry::TriangleMesh plate;
  for (const auto& p : polygon) {
    plate.vertices.emplace_back(p.x(), p.y(), 0.0);
    plate.vertices.emplace_back(p.x(), p.y(), -thicknessMm);
  }
  const int n = static_cast<int>(plate.vertices.size());
  for (int i = 0; i < n; i += 2) {
    const int next = (i + 2) % n;
    plate.triangles.push_back({i, i + 1, next});
    plate.triangles.push_back({next, i + 1, next + 1});
    if (i >= 2 && i + 2 < n) {
      plate.triangles.push_back({0, i, i + 2});
      plate.triangles.push_back({1, i + 1, i + 3});
    }
  }
  std::vector<Vector3d> points = surfaceSamples(plate, spacingMm);
  points.insert(points.end(), plate.vertices.begin(), plate.vertices.end());
  return points;
}

std::vector<Vector3d> frustumSamples(double lowMm, double highMm, double lowRadiusMm,
                                     double highRadiusMm, double spacingMm) {
  std::vector<Vector3d> points;
  const auto ring = [&](double z, double radius) {
    const int n = std::max(6, static_cast<int>(std::ceil(2.0 * base::kPi * radius / spacingMm)));
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * base::kPi * i / n;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  };
  const int steps =
      std::max(1, static_cast<int>(std::ceil(
                      std::hypot(highMm - lowMm, highRadiusMm - lowRadiusMm) / spacingMm)));
  for (int i = 0; i <= steps; ++i)
    ring(lowMm + (highMm - lowMm) * i / steps,
         lowRadiusMm + (highRadiusMm - lowRadiusMm) * i / steps);
  for (const auto& [z, radius] : {std::pair{lowMm, lowRadiusMm}, std::pair{highMm, highRadiusMm}})
    for (double r = radius - spacingMm; r > 0.0; r -= spacingMm)
      ring(z, r);
  return points;
}

std::vector<Vector3d> tipsOf(const std::vector<Vector3d>& samples) {
  constexpr std::size_t kEvery = 5;
  std::vector<Vector3d> tips;
  for (std::size_t i = 0; i < samples.size(); i += kEvery)
    tips.push_back(samples[i]);
  return tips;
}

double firstTipMm(const Piece& piece, const RiskRule& rule) {
  return piece.base.offsetMm + 2.0 * rule.contactMm;
}

namespace {

constexpr double kStepMm = 0.1;   // step of radii in the table of heights
constexpr double kColumnMm = 1.0; // width of a column, in which only the highest obstacle counts
constexpr int kBlock = 8;         // columns per block and axis

// Obstacles seen along a direction: the highest of each column.
class HeightMap {
public:
  struct Point { // in the frame of the direction
    double u, v, h;
  };

  HeightMap(std::vector<Point> points) {
    double highU = -1e300, highV = -1e300;
    for (const Point& p : points) {
      lowU_ = std::min(lowU_, p.u);
      lowV_ = std::min(lowV_, p.v);
      highU = std::max(highU, p.u);
      highV = std::max(highV, p.v);
    }
    // Columns are aligned to a fixed grid, so that they do not depend on the other obstacles.
    lowU_ = kColumnMm * std::floor(lowU_ / kColumnMm);
    lowV_ = kColumnMm * std::floor(lowV_ / kColumnMm);
    wide_ = static_cast<int>((highU - lowU_) / kColumnMm) / kBlock + 1;
    high_ = static_cast<int>((highV - lowV_) / kColumnMm) / kBlock + 1;
    columns_.assign(static_cast<std::size_t>(wide_ * high_) * kBlock * kBlock, {0, 0, kNone});
    top_.assign(static_cast<std::size_t>(wide_ * high_), kNone);
    for (const Point& p : points) {
      const int i = static_cast<int>((p.u - lowU_) / kColumnMm),
                j = static_cast<int>((p.v - lowV_) / kColumnMm);
      const auto block = static_cast<std::size_t>((j / kBlock) * wide_ + i / kBlock);
      Point& column = columns_[block * kBlock * kBlock +
                               static_cast<std::size_t>((j % kBlock) * kBlock + i % kBlock)];
      if (p.h > column.h)
        column = p;
      top_[block] = std::max(top_[block], p.h);
    }
  }

  // Returns whether an obstacle is higher above the tip than the head allows at its distance.
  bool meets(const Point& tip, const std::vector<double>& rise) const {
    constexpr double kBlockMm = kBlock * kColumnMm;
    const double reach = kStepMm * static_cast<double>(rise.size());
    const auto first = [&](double x) { return std::max(0, static_cast<int>(x / kBlockMm)); };
    const int i0 = first(tip.u - reach - lowU_), j0 = first(tip.v - reach - lowV_);
    const int i1 =
        std::min(wide_ - 1, static_cast<int>(std::floor((tip.u + reach - lowU_) / kBlockMm)));
    const int j1 =
        std::min(high_ - 1, static_cast<int>(std::floor((tip.v + reach - lowV_) / kBlockMm)));
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) {
        const auto block = static_cast<std::size_t>(j * wide_ + i);
        const double over = top_[block] - tip.h;
        if (over <= rise.front())
          continue;
        const double u = lowU_ + i * kBlockMm - tip.u, v = lowV_ + j * kBlockMm - tip.v;
        const double du = std::max({u, -u - kBlockMm, 0.0}), dv = std::max({v, -v - kBlockMm, 0.0});
        if (!inside(du * du + dv * dv, over, rise))
          continue;
        for (std::size_t c = block * kBlock * kBlock; c < (block + 1) * kBlock * kBlock; ++c) {
          const Point& p = columns_[c];
          if (p.h - tip.h > rise.front() &&
              inside((p.u - tip.u) * (p.u - tip.u) + (p.v - tip.v) * (p.v - tip.v), p.h - tip.h,
                     rise))
            return true;
        }
      }
    return false;
  }

private:
  static constexpr double kNone = -1e300;

  static bool inside(double squared, double over, const std::vector<double>& rise) {
    const auto step = static_cast<std::size_t>(std::sqrt(squared) / kStepMm);
    return step < rise.size() && over > rise[step];
  }

  double lowU_ = 1e300, lowV_ = 1e300;
  int wide_ = 0, high_ = 0;    // in blocks
  std::vector<Point> columns_; // block by block
  std::vector<double> top_;    // of each block
};

} // namespace

HeadReach::HeadReach(const process::HeadShape& head, double marginMm) {
  constexpr double kTouching = 1e-3; // mm
  if (head.sections.empty())
    return;
  double widest = 0.0;
  for (const process::HeadSection& s : head.sections)
    widest = std::max(widest, s.radiusMm);
  for (double r = 0.5 * kStepMm; r < widest + marginMm; r += kStepMm) {
    // The lowest height at which the head has this radius.
    const double wanted = std::max(0.0, r - marginMm);
    double lowest = head.sections.front().zMm;
    for (std::size_t s = 0; s < head.sections.size(); ++s) {
      const process::HeadSection& b = head.sections[s];
      if (b.radiusMm < wanted)
        continue;
      lowest = b.zMm;
      if (s > 0 && head.sections[s - 1].radiusMm < wanted) {
        const process::HeadSection& a = head.sections[s - 1];
        lowest = a.zMm + (b.zMm - a.zMm) * (wanted - a.radiusMm) / (b.radiusMm - a.radiusMm);
      }
      break;
    }
    rise_.push_back(lowest + kTouching);
  }
}

bool HeadReach::blocked(const std::vector<Vector3d>& tips, const Obstacles& obstacles,
                        const Vector3d& direction, double lowestMm) const {
  if (tips.empty() || rise_.empty())
    return false;
  const Vector3d across = direction.unitOrthogonal(), along = direction.cross(across);
  double lowest = 1e300;
  Eigen::AlignedBox2d swept; // area swept by the head's axis, seen along the direction
  for (const Vector3d& t : tips) {
    lowest = std::min(lowest, direction.dot(t));
    swept.extend(Eigen::Vector2d(across.dot(t), along.dot(t)));
  }
  lowest = std::max(lowest, lowestMm) + rise_.front();
  const double widest = kStepMm * static_cast<double>(rise_.size());
  std::vector<HeightMap::Point> near;
  for (const PointBlock& block : obstacles) {
    if (block.liesBelow(direction, lowest))
      continue;
    if (!block.box.isEmpty()) {
      const Vector3d middle = block.box.center();
      const Eigen::Vector2d at(across.dot(middle), along.dot(middle));
      if (swept.exteriorDistance(at) > widest + 0.5 * block.box.diagonal().norm())
        continue;
    }
    for (const Vector3d& o : block.points)
      if (const double h = direction.dot(o); h > lowest) {
        const Eigen::Vector2d at(across.dot(o), along.dot(o));
        if (swept.squaredExteriorDistance(at) <= widest * widest)
          near.push_back({at.x(), at.y(), h});
      }
  }
  if (near.empty())
    return false;
  const HeightMap map(std::move(near));
  const double allowed = kBlockedShare * static_cast<double>(tips.size());
  // Samples spread over the piece, so that heavily blocked pieces are detected early.
  const std::size_t n = tips.size();
  std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * n)) | 1U;
  while (std::gcd(stride, n) != 1)
    ++stride;
  std::size_t count = 0;
  for (std::size_t i = 0, at = 0; i < n; ++i, at = (at + stride) % n) {
    const Vector3d& t = tips[at];
    if (map.meets({across.dot(t), along.dot(t), std::max(direction.dot(t), lowestMm)}, rise_) &&
        static_cast<double>(++count) > allowed)
      return true;
  }
  return false;
}

std::vector<Vector3d> HeadReach::inside(const std::vector<Vector3d>& tips,
                                        const Obstacles& obstacles, const Vector3d& direction,
                                        double lowestMm) const {
  if (tips.empty() || rise_.empty())
    return {};
  // With the head upside down, tips and obstacles swap roles; the lowest tip of each column counts.
  const Vector3d across = direction.unitOrthogonal(), along = direction.cross(across);
  std::vector<HeightMap::Point> down;
  for (const Vector3d& t : tips)
    down.push_back({across.dot(t), along.dot(t), -std::max(direction.dot(t), lowestMm)});
  const HeightMap map(std::move(down));
  std::vector<Vector3d> out;
  for (const PointBlock& block : obstacles)
    for (const Vector3d& o : block.points)
      if (map.meets({across.dot(o), along.dot(o), -direction.dot(o)}, rise_))
        out.push_back(o);
  return out;
}

} // namespace voluta::planar
