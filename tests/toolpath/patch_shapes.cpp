#include "toolpath/patch_shapes.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace voluta::test {

namespace {
using Eigen::Vector2d;
using Eigen::Vector3d;

bool insideLoops(const std::vector<Loop>& loops, const Vector2d& p) {
  bool in = false;
  for (const Loop& l : loops)
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Vector2d &a = l[i], &b = l[(i + 1) % l.size()];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        in = !in;
    }
  return in;
}

// Positive inside.
double signedDistance(const std::vector<Loop>& loops, const Vector2d& p) {
  double d = 1e9;
  for (const Loop& l : loops)
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Vector2d &a = l[i], ab = l[(i + 1) % l.size()] - a;
      const double t = std::clamp(ab.dot(p - a) / ab.squaredNorm(), 0.0, 1.0);
      d = std::min(d, (a + t * ab - p).norm());
    }
  return insideLoops(loops, p) ? d : -d;
}
} // namespace

Loop circle(double radius, bool hole, Vector2d centre) {
  Loop l;
  const int n = std::max(8, static_cast<int>(2 * base::kPi * radius / 0.4));
  for (int i = 0; i < n; ++i) {
    const double a = 2 * base::kPi * (hole ? n - i : i) / n;
    l.push_back(centre + radius * Vector2d(std::cos(a), std::sin(a)));
  }
  return l;
}

Loop rectangle(double w, double h) {
  return {{-w / 2, -h / 2}, {w / 2, -h / 2}, {w / 2, h / 2}, {-w / 2, h / 2}};
}

Loop star(int tips, double outer, double inner) {
  Loop l;
  for (int i = 0; i < 2 * tips; ++i) {
    const double a = base::kPi * i / tips, r = i % 2 == 0 ? outer : inner;
    l.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return l;
}

Loop ell(double s, double arm) {
  return {{0, 0}, {s, 0}, {s, arm}, {arm, arm}, {arm, s}, {0, s}};
}

layers::Patch patchOver(const std::vector<Loop>& loops, double edgeMm, const Lift& lift,
                        const Height& height, unsigned seed) {
  Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Loop& l : loops)
    for (const Vector2d& p : l) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const double rise = edgeMm * std::sqrt(0.75);
  low -= Vector2d(1.7 * edgeMm, 1.7 * edgeMm);
  const int nx = static_cast<int>((high.x() - low.x()) / edgeMm) + 4,
            ny = static_cast<int>((high.y() - low.y()) / rise) + 4;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.25 * edgeMm, 0.25 * edgeMm);
  std::vector<Vector2d> lattice;
  std::vector<double> value;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const Vector2d p = low + Vector2d(i * edgeMm + (j % 2) * edgeMm / 2, j * rise);
      lattice.push_back(p + Vector2d(jitter(random), jitter(random)));
      value.push_back(signedDistance(loops, lattice.back()));
      // Slivers at the boundary are not tested.
      if (std::abs(value.back()) < 0.02)
        value.back() = value.back() < 0 ? -0.02 : 0.02;
    }
  layers::Patch patch;
  std::map<std::pair<int, int>, int> number;
  const auto vertex = [&](int a, int b) {
    if (a > b)
      std::swap(a, b);
    const auto [it, fresh] =
        number.try_emplace({a, b}, static_cast<int>(patch.surface.vertices.size()));
    if (fresh) {
      const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>(b);
      const double t = a == b ? 0 : value[ia] / (value[ia] - value[ib]);
      const Vector2d p = (1 - t) * lattice[ia] + t * lattice[ib];
      const double e = 1e-4;
      const Vector3d q = lift(p);
      const Vector3d n = (lift(p + Vector2d(e, 0)) - lift(p - Vector2d(e, 0)))
                             .cross(lift(p + Vector2d(0, e)) - lift(p - Vector2d(0, e)))
                             .normalized();
      patch.surface.vertices.push_back(q);
      patch.direction.push_back(n);
      patch.clearDirection.push_back(n);
      patch.thicknessMm.push_back(height(q));
    }
    return it->second;
  };
  const auto clip = [&](int a, int b, int c) {
    const int corner[3] = {a, b, c};
    std::vector<int> polygon;
    for (int k = 0; k < 3; ++k) {
      const int p = corner[k], q = corner[(k + 1) % 3];
      const bool in = value[static_cast<std::size_t>(p)] > 0;
      if (in)
        polygon.push_back(vertex(p, p));
      if (in != (value[static_cast<std::size_t>(q)] > 0))
        polygon.push_back(vertex(p, q));
    }
    for (std::size_t k = 2; k < polygon.size(); ++k)
      patch.surface.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
  };
  for (int j = 0; j + 1 < ny; ++j)
    for (int i = 0; i + 1 < nx; ++i) {
      const int p = j * nx + i, q = p + nx;
      if (j % 2 == 0) {
        clip(p, p + 1, q);
        clip(p + 1, q + 1, q);
      } else {
        clip(p, p + 1, q + 1);
        clip(p, q + 1, q);
      }
    }
  return patch;
}

Lift onSphere(double r) {
  return [r](const Vector2d& p) {
    const double a = p.norm() / r;
    const Vector2d d = p.norm() > 1e-12 ? Vector2d(p / p.norm()) : Vector2d(0, 0);
    return Vector3d(r * std::sin(a) * d.x(), r * std::sin(a) * d.y(), r * std::cos(a));
  };
}
Lift onCylinder(double r) {
  return [r](const Vector2d& p) {
    return Vector3d(r * std::sin(p.x() / r), p.y(), r * std::cos(p.x() / r));
  };
}
Lift onSaddle(double r) {
  return [r](const Vector2d& p) {
    return Vector3d(p.x(), p.y(), (p.x() * p.x() - p.y() * p.y()) / (2 * r) + 20);
  };
}

Eigen::Matrix3d oneDirection(const Eigen::Vector3d&) {
  const Eigen::Vector3d direction = Eigen::Vector3d(0.3, 0.2, 1.0).normalized();
  return direction * direction.transpose();
}

} // namespace voluta::test
