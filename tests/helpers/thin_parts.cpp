#include "helpers/thin_parts.h"

#include "base/units.h"
#include "helpers/made_solids.h"
#include "helpers/shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace voluta::test {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::TriangleMesh;

struct Made {
  TriangleMesh mesh;
  double thinnestMm;
};

// A polygon in the plane drawn out along z, tapering towards its centre by `taper` at the top.
TriangleMesh prism(const std::vector<Vector2d>& corners, double low, double high,
                   double taper = 1.0, const Vector2d& centre = Vector2d::Zero()) {
  TriangleMesh m;
  const int n = static_cast<int>(corners.size());
  for (const Vector2d& p : corners)
    m.vertices.emplace_back(p.x(), p.y(), low);
  for (const Vector2d& p : corners) {
    const Vector2d q = centre + taper * (p - centre);
    m.vertices.emplace_back(q.x(), q.y(), high);
  }
  const int bottom = 2 * n, top = bottom + 1;
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : corners)
    middle += p / n;
  m.vertices.emplace_back(middle.x(), middle.y(), low);
  const Vector2d above = centre + taper * (middle - centre);
  m.vertices.emplace_back(above.x(), above.y(), high);
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    m.triangles.push_back({k, next, n + next});
    m.triangles.push_back({k, n + next, n + k});
    m.triangles.push_back({bottom, next, k});
    m.triangles.push_back({top, n + k, n + next});
  }
  return facingOutward(std::move(m));
}

Made openBox(Dice& d) {
  const double w = d.between(20, 45), depth = d.between(15, 35), h = d.between(8, 25),
               t = d.between(0.6, 3), floor = d.between(1.6, 4);
  return {box({0, 0, 0}, {w, depth, h}) - box({t, t, floor}, {w - t, depth - t, h + 1}), t};
}

Made fins(Dice& d) {
  const int count = d.among(3, 6);
  const double t = d.between(0.7, 3), gap = d.between(4, 8), depth = d.between(15, 35),
               h = d.between(6, 18), floor = d.between(2, 4), w = count * (t + gap) + gap;
  TriangleMesh m = box({0, 0, 0}, {w, depth, floor});
  for (int k = 0; k < count; ++k) {
    const double x = gap + k * (t + gap);
    m = m + box({x, 2, floor - 0.5}, {x + t, depth - 2, floor + h});
  }
  return {m, t};
}

// A table of struts: legs that lean against each other, joined by two rings.
Made truss(Dice& d) {
  const int legs = d.among(3, 5);
  const double r = 0.5 * d.between(1.2, 4), h = d.between(20, 40), foot = d.between(9, 16),
               head = foot * d.between(0.6, 0.95), floor = d.between(1.6, 3);
  TriangleMesh m = cylinder({0, 0, 0}, {0, 0, floor}, foot + 2 * r + 1);
  const auto corner = [&](int k, double radius, double z) {
    const double a = 2 * base::kPi * k / legs;
    return Vector3d(radius * std::cos(a), radius * std::sin(a), z);
  };
  for (int k = 0; k < legs; ++k)
    m = m + swept({corner(k, foot, 0.3), corner(k, head, h)}, {r, r}, 20);
  std::vector<Vector2d> plate;
  for (int i = 0; i < 40; ++i)
    plate.emplace_back((head + r + 1) * std::cos(2 * base::kPi * i / 40),
                       (head + r + 1) * std::sin(2 * base::kPi * i / 40));
  if (d.between(0, 1) < 0.5)
    return {m, 2 * r};
  return {m + prism(plate, h - 0.4, h + floor), 2 * r};
}

// A lens that tapers along its height.
Made blade(Dice& d) {
  const double chord = d.between(18, 35), t = d.between(2, 5), h = d.between(15, 40),
               taper = d.between(0.35, 0.8), foot = d.between(2, 4);
  std::vector<Vector2d> lens;
  for (int k = 0; k <= 16; ++k) {
    const double x = k / 16.0;
    lens.emplace_back(chord * x, 0.5 * (t * 4 * x * (1 - x)) + 0.3);
  }
  for (int k = 16; k >= 0; --k) {
    const double x = k / 16.0;
    lens.emplace_back(chord * x, -0.5 * (t * 4 * x * (1 - x)) - 0.3);
  }
  return {prism(lens, foot - 0.5, foot + h, taper, {0.5 * chord, 0}) +
              box({-2, -0.5 * t - 3, 0}, {chord + 2, 0.5 * t + 3, foot}),
          0.6 * taper};
}

// A box with a rim, bosses, a rib and vents.
Made printerCase(Dice& d) {
  const double w = d.between(30, 55), depth = d.between(25, 45), h = d.between(10, 22),
               t = d.between(1.2, 2.4), floor = d.between(1.6, 3), r = d.between(2.0, 3.0);
  TriangleMesh m = box({0, 0, 0}, {w, depth, h}) - box({t, t, floor}, {w - t, depth - t, h + 1});
  for (const double x : {t + r + 1.5, w - t - r - 1.5})
    for (const double y : {t + r + 1.5, depth - t - r - 1.5})
      m = m + (cylinder({x, y, floor - 0.5}, {x, y, 0.6 * h}, r) -
               cylinder({x, y, floor + 1}, {x, y, 0.6 * h + 1}, r - 1.2));
  m = m + box({0.45 * w, t - 0.4, floor - 0.4}, {0.45 * w + t, depth - t + 0.4, 0.5 * h});
  const int vents = d.among(2, 4);
  for (int k = 0; k < vents; ++k) {
    const double x = w * (0.6 + 0.3 * k / vents);
    m = m - box({x, -1, h - 4}, {x + 1.5, t + 1, h + 1});
  }
  return {m, std::min(t, 1.2)};
}

// Struts along the edges of cubes.
Made lattice(Dice& d) {
  const int nx = d.among(1, 2), ny = d.among(1, 2), nz = d.among(1, 2);
  const double cell = d.between(9, 14), t = d.between(1.5, 3.5);
  TriangleMesh m;
  const auto add = [&](const Vector3d& low, const Vector3d& high) {
    const TriangleMesh beam = box(low, high);
    m = m.triangles.empty() ? beam : m + beam;
  };
  // Of unequal widths, so that no two faces are coplanar.
  const double a = t, b = t - 0.05, c = t - 0.1;
  for (int i = 0; i <= nx; ++i)
    for (int j = 0; j <= ny; ++j)
      add({i * cell - a / 2, j * cell - a / 2, 0},
          {i * cell + a / 2, j * cell + a / 2, nz * cell + a});
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j)
      add({-b / 2 - 0.5, j * cell - b / 2, k * cell + 0.02},
          {nx * cell + b / 2 + 0.5, j * cell + b / 2, k * cell + b});
    for (int i = 0; i <= nx; ++i)
      add({i * cell - c / 2, -c / 2 - 0.6, k * cell + 0.04},
          {i * cell + c / 2, ny * cell + c / 2 + 0.6, k * cell + c});
  }
  return {m, t - 0.1};
}

Made vase(Dice& d) {
  const double r = d.between(10, 20), h = d.between(20, 45), t = d.between(0.8, 2.4),
               lean = d.between(-0.25, 0.45), wave = d.between(0, 2), floor = d.between(1.6, 3);
  std::vector<Vector2d> outer, inner;
  for (int k = 0; k <= 20; ++k) {
    const double z = h * k / 20;
    const double x = r + lean * z + wave * std::sin(z / 6);
    outer.emplace_back(x, z);
    if (z >= floor)
      inner.emplace_back(x - t, z);
  }
  std::vector<Vector2d> section{{0.01, 0}};
  section.insert(section.end(), outer.begin(), outer.end());
  for (auto it = inner.rbegin(); it != inner.rend(); ++it)
    section.push_back(*it);
  section.emplace_back(0.01, inner.front().y());
  return {turned(section, 72), t * std::cos(std::atan(std::abs(lean)))};
}

// Bent sheet with holes and gussets.
Made sheet(Dice& d) {
  const double w = d.between(20, 40), depth = d.between(15, 30), h = d.between(15, 30),
               t = d.between(1.0, 3);
  TriangleMesh m = box({0, 0, 0}, {w, depth, t}) + box({0, 0, 0.3 * t}, {t, depth, h});
  const double r = d.between(1.5, 3);
  m = m - cylinder({-1, 0.5 * depth, 0.6 * h}, {t + 1, 0.5 * depth, 0.6 * h}, r);
  m = m - cylinder({0.65 * w, 0.5 * depth, -1}, {0.65 * w, 0.5 * depth, t + 1}, r);
  const double g = d.between(4, 9);
  for (const double y : {1.0, depth - 1.0 - t}) {
    TriangleMesh gusset = prism({{0.5 * t, 0.5 * t}, {t + g, 0.5 * t}, {0.5 * t, t + g}}, y, y + t);
    for (Vector3d& v : gusset.vertices)
      v = Vector3d(v.x(), v.z(), v.y());
    m = m + facingOutward(std::move(gusset));
  }
  return {m, t};
}

Made honeycomb(Dice& d) {
  const double cell = d.between(6, 10), t = d.between(0.9, 2.4), h = d.between(5, 12);
  const int nx = d.among(2, 4), ny = d.among(2, 3);
  const double dx = std::sqrt(3.0) * 0.5 * cell, dy = 0.75 * cell;
  const double w = nx * dx + t, depth = ny * dy + 0.25 * cell + t;
  TriangleMesh m = box({0, 0, 0}, {w, depth, h});
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx - (j % 2); ++i) {
      const Vector2d at(0.5 * t + (i + 0.5 + 0.5 * (j % 2)) * dx, 0.5 * t + 0.5 * cell + j * dy);
      std::vector<Vector2d> hexagon;
      const double r = 0.5 * (cell - t / std::cos(base::kPi / 6));
      for (int k = 0; k < 6; ++k)
        hexagon.push_back(at + r * Vector2d(std::cos(base::kPi * (k + 0.5) / 3),
                                            std::sin(base::kPi * (k + 0.5) / 3)));
      m = m - prism(hexagon, -1, h + 1);
    }
  return {m, t};
}

// Straight blades around a hub, leaning, of unequal heights so that no faces are coplanar.
Made impeller(Dice& d) {
  const int blades = d.among(4, 8);
  const double hub = d.between(4, 7), r = d.between(14, 24), t = d.between(0.9, 2.2),
               h = d.between(5, 12), floor = d.between(1.6, 2.8), lean = d.between(-0.35, 0.35);
  TriangleMesh m = cylinder({0, 0, 0}, {0, 0, floor}, r + 1);
  // Off the centre, so that no vertex of the one is on an edge of the other.
  m = m + cylinder({0.31, 0.17, 0.4}, {0.31, 0.17, floor + h}, hub);
  for (int k = 0; k < blades; ++k) {
    const Eigen::Isometry3d to(
        Eigen::AngleAxisd(2 * base::kPi * (k + 0.13) / blades, Vector3d::UnitZ()) *
        Eigen::Translation3d(0, 0, floor - 0.6 - 0.01 * k) *
        Eigen::AngleAxisd(lean, Vector3d::UnitX()));
    m = m + moved(box({hub - 1, -0.5 * t, 0}, {r, 0.5 * t, h - 0.02 * k}), to);
  }
  return {m, t};
}

} // namespace

ThinPart thinPart(unsigned seed) {
  struct Kind {
    const char* name;
    Made (*make)(Dice&);
  };
  constexpr std::array<Kind, 10> kKinds{{{"box", openBox},
                                         {"fins", fins},
                                         {"truss", truss},
                                         {"blade", blade},
                                         {"case", printerCase},
                                         {"lattice", lattice},
                                         {"vase", vase},
                                         {"sheet", sheet},
                                         {"honeycomb", honeycomb},
                                         {"impeller", impeller}}};
  Dice dice(seed + 1000);
  const Kind& kind = kKinds[seed % kKinds.size()];
  const double angle = dice.between(0, 2 * base::kPi);
  Made made = kind.make(dice);
  ThinPart part;
  part.name = std::string("thin-") + kind.name + "-" + std::to_string(seed);
  part.mesh =
      moved(std::move(made.mesh), Eigen::Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ())));
  part.thinnestMm = made.thinnestMm;
  return part;
}

} // namespace voluta::test
