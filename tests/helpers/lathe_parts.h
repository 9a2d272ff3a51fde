// Parts to wind on rods and to print on surfaces, closed, with measures in closed form. mm; axis x,
// angles from y to z.
#pragma once

#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/triangle_mesh.h"
#include "helpers/shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace voluta::test {

// A closed polygon of (x, radius), turned about the x axis, whole.
inline geometry::TriangleMesh revolved(const std::vector<Eigen::Vector2d>& section, int sides) {
  geometry::TriangleMesh m;
  const int n = static_cast<int>(section.size());
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * base::kPi * i / sides;
    for (const Eigen::Vector2d& p : section)
      m.vertices.emplace_back(p.x(), p.y() * std::cos(a), p.y() * std::sin(a));
  }
  for (int i = 0; i < sides; ++i)
    for (int k = 0; k < n; ++k) {
      const int a = i * n + k, b = i * n + (k + 1) % n, c = (i + 1) % sides * n + (k + 1) % n,
                d = (i + 1) % sides * n + k;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  return facingOutward(std::move(m));
}
// The volume of the solid of revolution, by Pappus.
inline double revolvedVolume(const std::vector<Eigen::Vector2d>& section) {
  double sum = 0.0;
  for (std::size_t k = 0; k < section.size(); ++k) {
    const Eigen::Vector2d &a = section[k], &b = section[(k + 1) % section.size()];
    sum += (b.x() - a.x()) * (a.y() * a.y() + a.y() * b.y() + b.y() * b.y()) / 3.0;
  }
  return std::abs(sum) * base::kPi;
}

// A section that is convex in the plane across `along`, drawn out from `from` to `to`: `corners` in
// order around, each given where it starts.
inline geometry::TriangleMesh drawnOut(const std::vector<Eigen::Vector3d>& corners,
                                       const Eigen::Vector3d& offset) {
  geometry::TriangleMesh m;
  const int n = static_cast<int>(corners.size());
  m.vertices = corners;
  for (const Eigen::Vector3d& p : corners)
    m.vertices.push_back(p + offset);
  for (int k = 0; k < n; ++k) {
    m.triangles.push_back({k, (k + 1) % n, n + (k + 1) % n});
    m.triangles.push_back({k, n + (k + 1) % n, n + k});
  }
  for (int k = 1; k + 1 < n; ++k) {
    m.triangles.push_back({0, k + 1, k});
    m.triangles.push_back({n, n + k, n + k + 1});
  }
  return facingOutward(std::move(m));
}

// A tube or part of one: strips between an inner and an outer outline (y, z) of as many points,
// drawn out over [x0, x1]; closed around, or with two flat ends.
inline geometry::TriangleMesh shell(const std::vector<Eigen::Vector2d>& inner,
                                    const std::vector<Eigen::Vector2d>& outer, double x0, double x1,
                                    bool closed) {
  geometry::TriangleMesh m;
  const int n = static_cast<int>(inner.size());
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    m.vertices.emplace_back(x0, inner[k].x(), inner[k].y());
    m.vertices.emplace_back(x0, outer[k].x(), outer[k].y());
    m.vertices.emplace_back(x1, outer[k].x(), outer[k].y());
    m.vertices.emplace_back(x1, inner[k].x(), inner[k].y());
  }
  for (int i = 0; i + (closed ? 0 : 1) < n; ++i)
    for (int k = 0; k < 4; ++k) {
      const int j = (i + 1) % n, a = 4 * i + k, b = 4 * i + (k + 1) % 4, c = 4 * j + (k + 1) % 4,
                d = 4 * j + k;
      m.triangles.push_back({a, b, c});
      m.triangles.push_back({a, c, d});
    }
  if (!closed)
    for (const int at : {0, 4 * (n - 1)}) {
      const bool first = at == 0;
      m.triangles.push_back({at, first ? at + 2 : at + 1, first ? at + 1 : at + 2});
      m.triangles.push_back({at, first ? at + 3 : at + 2, first ? at + 2 : at + 3});
    }
  return facingOutward(std::move(m));
}

inline std::vector<Eigen::Vector2d> arc(double radius, double from, double to, int points) {
  std::vector<Eigen::Vector2d> out;
  for (int i = 0; i < points; ++i) {
    const double a = from + (to - from) * i / (points - 1);
    out.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return out;
}

// Sections (x, radius) of parts for a rod of 5 mm, 50 mm long. Bores are 4.8 mm: the rod is taken
// out of them.
inline constexpr double kBore = 2.4;
inline std::vector<Eigen::Vector2d> tubeSection() {
  return {{-25, kBore}, {-25, 5}, {25, 5}, {25, kBore}};
}
// Seats of 8 mm for 625ZZ bearings at both ends of a shaft of 10 mm.
inline std::vector<Eigen::Vector2d> shoulderSection() {
  return {{-25, kBore}, {-25, 4}, {-15, 4}, {-15, 5}, {15, 5}, {15, 4}, {25, 4}, {25, kBore}};
}
inline std::vector<Eigen::Vector2d> taperedSection() {
  return {{-25, kBore}, {-25, 2.5}, {-15, 5}, {15, 5}, {25, 2.5}, {25, kBore}};
}
// Cuts a rod of radius r out of a section: its inner edge is moved out to r.
inline std::vector<Eigen::Vector2d> onRod(std::vector<Eigen::Vector2d> section, double r) {
  for (Eigen::Vector2d& p : section)
    p.y() = std::max(p.y(), r);
  return section;
}

// A round tube with a hexagonal bore, `overCorners` wide, a corner at angle 0.
inline geometry::TriangleMesh hexagonalTube(double overCorners, double diameter, double length,
                                            int pointsASide = 50) {
  std::vector<Eigen::Vector2d> inner, outer;
  const double step = base::kPi / 3;
  for (int side = 0; side < 6; ++side)
    for (int k = 0; k < pointsASide; ++k) {
      const double t = static_cast<double>(k) / pointsASide, a = step * side;
      const Eigen::Vector2d from(std::cos(a), std::sin(a)),
          to(std::cos(a + step), std::sin(a + step));
      inner.push_back(0.5 * overCorners * ((1 - t) * from + t * to));
      outer.push_back(0.5 * diameter *
                      Eigen::Vector2d(std::cos(a + step * t), std::sin(a + step * t)));
    }
  return shell(inner, outer, -0.5 * length, 0.5 * length, true);
}
inline double hexagonalTubeVolume(double overCorners, double diameter, double length) {
  const double r = 0.5 * overCorners;
  return length * (base::kPi * diameter * diameter / 4 - 1.5 * std::sqrt(3.0) * r * r);
}

// The upper half of a tube, cut along its axis.
inline geometry::TriangleMesh halfTube(double bore, double diameter, double length,
                                       int points = 161) {
  const double pi = base::kPi;
  return shell(arc(0.5 * bore, 0, pi, points), arc(0.5 * diameter, 0, pi, points), -0.5 * length,
               0.5 * length, false);
}

// A roof of slopes of 60 degrees over `base` mm, its ridge along x at the height that gives, its
// eaves on z = 0.
inline geometry::TriangleMesh gableRoof(double base, double length) {
  const double half = 0.5 * base, x = -0.5 * length;
  return drawnOut({{x, -half, 0}, {x, half, 0}, {x, 0, half * std::sqrt(3.0)}}, {length, 0, 0});
}
// Everything within `height` over the slopes and the ridge of a gableRoof, `width` along the ridge
// in its middle: its outer side is rounded over the ridge. Down to `eaves` over z = 0.
inline geometry::TriangleMesh gableRib(double base, double width, double height, double eaves,
                                       int pointsOverRidge = 33) {
  const double pi = base::kPi, half = 0.5 * base, top = half * std::sqrt(3.0);
  const double down = half - eaves / std::sqrt(3.0);
  const Eigen::Vector2d ridge(0, top), right(down, eaves), left(-down, eaves);
  std::vector<Eigen::Vector2d> inner{right},
      outer{right + height * Eigen::Vector2d(std::cos(pi / 6), std::sin(pi / 6))};
  for (int i = 0; i < pointsOverRidge; ++i) {
    const double a = pi / 6 + i * (2 * pi / 3) / (pointsOverRidge - 1);
    inner.push_back(ridge);
    outer.push_back(ridge + height * Eigen::Vector2d(std::cos(a), std::sin(a)));
  }
  inner.push_back(left);
  outer.push_back(left + height * Eigen::Vector2d(-std::cos(pi / 6), std::sin(pi / 6)));
  // The ridge is one line: triangles of the strip that have no extent there are left out.
  geometry::TriangleMesh strip = shell(inner, outer, -0.5 * width, 0.5 * width, false), m = strip;
  m.triangles.clear();
  const auto same = [&](int v) {
    const int at = v / 4, corner = v % 4;
    const bool onRidge = (corner == 0 || corner == 3) && at > 0 && at <= pointsOverRidge;
    return onRidge ? 4 + corner : v;
  };
  for (const auto& t : strip.triangles) {
    const std::array<int, 3> u{same(t[0]), same(t[1]), same(t[2])};
    if (u[0] != u[1] && u[1] != u[2] && u[2] != u[0])
      m.triangles.push_back(u);
  }
  return m;
}
inline double gableRibVolume(double base, double width, double height, double eaves) {
  const double slope = base - 2 * eaves / std::sqrt(3.0); // equilateral: the slope is as long
  return width * (2 * slope * height + base::kPi / 3 * height * height);
}

// The upper half of a cylinder lying along x on z = 0.
inline geometry::TriangleMesh halfCylinder(double diameter, double length, int points = 181) {
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector2d& p : arc(0.5 * diameter, 0, base::kPi, points))
    corners.emplace_back(-0.5 * length, p.x(), p.y());
  return drawnOut(corners, {length, 0, 0});
}
// A rib `height` high around a halfCylinder, `width` wide, over polar angles from `from` to pi -
// from.
inline geometry::TriangleMesh halfCylinderRib(double diameter, double width, double height,
                                              double from, int points = 181) {
  const double to = base::kPi - from;
  return shell(arc(0.5 * diameter, from, to, points),
               arc(0.5 * diameter + height, from, to, points), -0.5 * width, 0.5 * width, false);
}

} // namespace voluta::test
