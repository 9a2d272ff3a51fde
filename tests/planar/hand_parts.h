// Parts whose best pieces can be worked out by hand. mm, standing on z = 0.
#pragma once

#include "base/units.h"
#include "geometry/triangle_mesh.h"
#include "helpers/shapes.h"

#include <Eigen/Core>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace voluta::test {

// A counter-clockwise polygon of x and z pushed along y; its ends by cutting off ears.
inline geometry::TriangleMesh extruded(const std::vector<Eigen::Vector2d>& outline, double y0,
                                       double y1) {
  geometry::TriangleMesh m;
  const int n = static_cast<int>(outline.size());
  for (const double y : {y0, y1})
    for (const Eigen::Vector2d& p : outline)
      m.vertices.emplace_back(p.x(), y, p.y());
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    m.triangles.push_back({i, j, n + j});
    m.triangles.push_back({i, n + j, n + i});
  }
  const auto at = [&](int i) -> const Eigen::Vector2d& {
    return outline[static_cast<std::size_t>(i)];
  };
  const auto orientation = [&](int a, int b, int c) {
    const Eigen::Vector2d u = at(b) - at(a), v = at(c) - at(a);
    return u.x() * v.y() - u.y() * v.x();
  };
  std::vector<int> left(outline.size());
  std::iota(left.begin(), left.end(), 0);
  while (left.size() > 2) {
    std::size_t ear = left.size();
    for (std::size_t i = 0; i < left.size() && ear == left.size(); ++i) {
      const int a = left[(i + left.size() - 1) % left.size()], b = left[i],
                c = left[(i + 1) % left.size()];
      bool clear = orientation(a, b, c) > 1e-12;
      for (const int o : left)
        clear = clear && (o == a || o == b || o == c || orientation(a, b, o) < -1e-12 ||
                          orientation(b, c, o) < -1e-12 || orientation(c, a, o) < -1e-12);
      if (clear)
        ear = i;
    }
    if (ear == left.size())
      break; // the outline crosses itself: the mesh stays open, and tests see it
    const int a = left[(ear + left.size() - 1) % left.size()], b = left[ear],
              c = left[(ear + 1) % left.size()];
    m.triangles.push_back({a, c, b});
    m.triangles.push_back({n + a, n + b, n + c});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return facingOutward(std::move(m));
}

// A body of revolution about z from its profile of (r, z), r = 0 at both ends.
inline geometry::TriangleMesh turned(const std::vector<Eigen::Vector2d>& profile, int around) {
  geometry::TriangleMesh m;
  std::vector<int> ring;
  for (const Eigen::Vector2d& p : profile) {
    ring.push_back(static_cast<int>(m.vertices.size()));
    for (int j = 0; j < (p.x() > 0.0 ? around : 1); ++j) {
      const double a = 2.0 * base::kPi * j / around;
      m.vertices.emplace_back(p.x() * std::cos(a), p.x() * std::sin(a), p.y());
    }
  }
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    for (int j = 0; j < around; ++j) {
      const auto at = [&](std::size_t k, int step) {
        return ring[k] + (profile[k].x() > 0.0 ? (j + step) % around : 0);
      };
      if (profile[i].x() > 0.0)
        m.triangles.push_back({at(i, 0), at(i, 1), at(i + 1, 0)});
      if (profile[i + 1].x() > 0.0)
        m.triangles.push_back({at(i, 1), at(i + 1, 1), at(i + 1, 0)});
    }
  return facingOutward(std::move(m));
}

// A bar across the top of a post.
inline geometry::TriangleMesh tee() {
  return extruded({{-5, 0}, {5, 0}, {5, 30}, {25, 30}, {25, 40}, {-25, 40}, {-25, 30}, {-5, 30}},
                  -5, 5);
}

// Two arms that lean out by 60 degrees from upright.
inline geometry::TriangleMesh wye() {
  const double out = 26.0, up = out / std::sqrt(3.0);
  return extruded({{-5, 0},
                   {5, 0},
                   {5, 20},
                   {5 + out, 20 + up},
                   {5 + out, 32 + up},
                   {0, 32 - 5 / std::sqrt(3.0)},
                   {-5 - out, 32 + up},
                   {-5 - out, 20 + up},
                   {-5, 20}},
                  -5, 5);
}

// A flat cap on a post, both bars of one thickness.
inline geometry::TriangleMesh mushroom() {
  std::vector<Eigen::Vector2d> outline{{-6, 0}, {6, 0}, {6, 24}};
  for (int i = 0; i <= 24; ++i) {
    const double a = base::kPi * i / 24;
    outline.emplace_back(22 * std::cos(a), 24 + 16 * std::sin(a));
  }
  outline.emplace_back(-6, 24);
  return extruded(outline, -6, 6);
}

// A post, an arm to its side, and a round drop on a stem below the arm.
inline geometry::TriangleMesh hangingBall() {
  const double x = 40, z = 28, r = 10, half = 4; // of the drop, of the stem
  std::vector<Eigen::Vector2d> outline{{0, 0}, {10, 0}, {10, 48}, {x - half, 48}};
  const double from = base::kPi / 2 + std::asin(half / r);
  for (int i = 0; i <= 36; ++i) {
    const double a = from + (2 * base::kPi - 2 * std::asin(half / r)) * i / 36;
    outline.emplace_back(x + r * std::cos(a), z + r * std::sin(a));
  }
  for (const auto& [px, pz] : {std::pair{x + half, 58.0}, std::pair{0.0, 58.0}})
    outline.emplace_back(px, pz);
  return extruded(outline, -5, 5);
}

} // namespace voluta::test
