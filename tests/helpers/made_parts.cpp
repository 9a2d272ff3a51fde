#include "helpers/made_parts.h"

#include "base/units.h"
#include "helpers/made_solids.h"
#include "helpers/shapes.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vector>

namespace voluta::test {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using geometry::TriangleMesh;

TriangleMesh bracket(Dice& d) {
  const double w = d.between(30, 60), depth = d.between(20, 40), t = d.between(5, 9),
               h = d.between(25, 55);
  TriangleMesh m = box({0, 0, 0}, {w, depth, t}) + box({0, 0, t - 1}, {t, depth, h});
  // A pocket in the foot, and a hole through the upright part.
  const double rim = d.between(3, 5);
  if (w - t - 2 * rim > 8 && depth - 2 * rim > 8)
    m = m - box({t + rim, rim, d.between(2.6, t - 2)}, {w - rim, depth - rim, t + 1});
  const double r = d.between(2.5, std::min(0.3 * depth, 0.2 * h));
  const double z = d.between(t + r + 4, h - r - 4);
  return m - cylinder({-1, 0.5 * depth, z}, {t + 1, 0.5 * depth, z}, r);
}

TriangleMesh arch(Dice& d) {
  const double r = d.between(8, 22), leg = d.between(5, 12), roof = d.between(4, 10),
               depth = d.between(10, 30), up = d.between(2, 15);
  const double w = 2 * (r + leg), h = up + r + roof;
  TriangleMesh hole = cylinder({0.5 * w, -1, up}, {0.5 * w, depth + 1, up}, r) +
                      box({0.5 * w - r + 0.01, -1.01, -1}, {0.5 * w + r - 0.01, depth + 1.01, up});
  return box({0, 0, 0}, {w, depth, h}) - hole;
}

TriangleMesh hook(Dice& d) {
  const double rod = d.between(3, 6), bend = d.between(8, 16), up = d.between(15, 40);
  const double angle = base::degreesToRadians(d.between(90, 170));
  std::vector<Vector3d> line{{0, 0, 1}, {0, 0, 0.5 * up}};
  for (int k = 0; k <= 24; ++k) {
    const double a = angle * k / 24;
    line.emplace_back(bend * (1 - std::cos(a)), 0, up + bend * std::sin(a));
  }
  const std::vector<double> radius(line.size(), rod);
  const double foot = d.between(rod + 4, rod + 14);
  return swept(line, radius) + cylinder({0, 0, 0}, {0, 0, d.between(3, 6)}, foot);
}

TriangleMesh stairs(Dice& d) {
  const int steps = d.among(3, 6);
  const double run = d.between(6, 12), rise = d.between(5, 10), depth = d.between(12, 30);
  const bool over = d.between(0, 1) < 0.4; // each step reaches over the one below
  const double minimum = over ? d.between(10, 16) : 0.0;
  TriangleMesh m;
  for (int k = 0; k < steps; ++k) {
    const double low = over ? k * rise - (k > 0 ? 0.5 : 0.0) : 0.0;
    const TriangleMesh step =
        over ? box({0.0, 0.01 * k, low}, {minimum + k * run, depth - 0.01 * k, (k + 1) * rise})
             : box({k * run - (k > 0 ? 0.5 : 0.0), 0.01 * k, 0.0},
                   {(k + 1) * run, depth - 0.01 * k, (k + 1) * rise});
    m = k == 0 ? step : m + step;
  }
  return m;
}

TriangleMesh fins(Dice& d) {
  const int count = d.among(3, 7);
  const double t = d.between(2.6, 5), gap = d.between(5, 9), depth = d.between(20, 45),
               h = d.between(12, 35), floor = d.between(3, 6);
  const double lean = base::degreesToRadians(d.between(-30, 30));
  const double w = count * (t + gap) + gap;
  TriangleMesh m = box({0, 0, 0}, {w, depth, floor});
  for (int k = 0; k < count; ++k) {
    // Both corners of its foot in the floor.
    const Vector3d at(gap + k * (t + gap), 2, floor - 0.4 - t * std::max(0.0, std::sin(-lean)));
    m = m + moved(box({0, 0, 0}, {t, depth - 4, h}),
                  Eigen::Translation3d(at) * Eigen::AngleAxisd(lean, Vector3d::UnitY()));
  }
  return m;
}

TriangleMesh tree(Dice& d) {
  const double trunk = d.between(4, 7), h = d.between(30, 55);
  TriangleMesh m =
      swept({{0, 0, 0}, {0, 0, 0.5 * h}, {0, 0, h}}, {1.8 * trunk, trunk, 0.7 * trunk});
  const int branches = d.among(2, 5);
  for (int k = 0; k < branches; ++k) {
    const double round = 2 * base::kPi * (k + d.between(0, 0.5)) / branches;
    const double steep = base::degreesToRadians(d.between(25, 65)); // from upright
    const double r = d.between(2.6, 0.75 * trunk), length = d.between(15, 30);
    const Vector3d from(0, 0, d.between(0.3, 0.85) * h);
    const Vector3d along(std::sin(steep) * std::cos(round), std::sin(steep) * std::sin(round),
                         std::cos(steep));
    m = m + swept({from, from + length * along}, {r, 0.8 * r}, 24);
  }
  return m;
}

TriangleMesh bowl(Dice& d) {
  const double r = d.between(18, 38), t = d.between(2.6, 5), deep = d.between(0.4, 0.9),
               foot = d.between(0.3, 0.6) * r;
  std::vector<Vector2d> section{{0.01, 0}, {foot, 0}};
  for (int k = 1; k <= 16; ++k) {
    const double a = 0.5 * base::kPi * k / 16;
    const double x = foot + (r - foot) * std::sin(a);
    section.emplace_back(x, deep * r * (1 - std::cos(a)));
  }
  const double top = deep * r;
  for (int k = 16; k >= 1; --k) {
    const double a = 0.5 * base::kPi * k / 16;
    const double x = foot + (r - foot) * std::sin(a) - t;
    section.emplace_back(std::max(x, 0.2), top - (top - t) * std::cos(a));
  }
  section.emplace_back(0.01, t);
  return turned(section, 72);
}

TriangleMesh flangedTube(Dice& d) {
  const double r = d.between(8, 18), t = d.between(2.6, 5), h = d.between(25, 60),
               low = d.between(4, 14), high = d.between(3, 12), thick = d.between(3, 6);
  const double cone = d.between(0, 1) < 0.5 ? 0.0 : high; // half of them rise to it at 45 degrees
  std::vector<Vector2d> section{{r, 0},
                                {r + t + low, 0},
                                {r + t + low, thick},
                                {r + t, thick},
                                {r + t, h - thick - cone - 0.01}};
  section.emplace_back(r + t + high, h - thick);
  section.emplace_back(r + t + high, h);
  section.emplace_back(r, h);
  return turned(section, 64);
}

} // namespace

MadePart madePart(unsigned seed) {
  struct Kind {
    const char* name;
    TriangleMesh (*make)(Dice&);
  };
  constexpr std::array<Kind, 8> kKinds{{{"bracket", bracket},
                                        {"arch", arch},
                                        {"hook", hook},
                                        {"stairs", stairs},
                                        {"fins", fins},
                                        {"tree", tree},
                                        {"bowl", bowl},
                                        {"tube", flangedTube}}};
  Dice dice(seed);
  const Kind& kind = kKinds[seed % kKinds.size()];
  const double angle = dice.between(0, 2 * base::kPi);
  TriangleMesh mesh = kind.make(dice);
  return {std::string(kind.name) + "-" + std::to_string(seed),
          moved(std::move(mesh), Eigen::Isometry3d(Eigen::AngleAxisd(angle, Vector3d::UnitZ())))};
}

} // namespace voluta::test
