#include "substrate/levels.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace voluta::substrate {

namespace {

using Eigen::Vector3d;
using layers::LevelSurface;

constexpr double kChordMm = 0.002;
constexpr double kMaxStep = base::degreesToRadians(4.0);

// Returns the angle between vertices on a circle.
double angularStep(double radiusMm, double edgeMm) {
  const double chord = 2.0 * std::acos(std::max(0.0, 1.0 - kChordMm / radiusMm));
  return std::min({kMaxStep, chord, edgeMm / radiusMm});
}

int steps(double length, double step) {
  return std::max(1, static_cast<int>(std::ceil(length / step - 1e-9)));
}

void append(LevelSurface& s, const Vector3d& p, const Vector3d& direction, double thicknessMm) {
  s.surface.vertices.push_back(p);
  s.thicknessMm.push_back(thicknessMm);
  s.direction.push_back(direction);
  s.clearDirection.push_back(direction);
}

// Appends two triangles per cell between two rows, with every other row shifted by half a step.
// `at(row, i)` are vertices; seen from outside, i increases to the left of the direction in which
// the rows increase.
template <typename At> void appendRow(LevelSurface& s, const At& at, int row, int cells) {
  for (int i = 0; i < cells; ++i) {
    const int a = at(row, i), b = at(row, i + 1), c = at(row + 1, i), d = at(row + 1, i + 1);
    if (row % 2 == 0) {
      s.surface.triangles.push_back({a, b, c});
      s.surface.triangles.push_back({b, d, c});
    } else {
      s.surface.triangles.push_back({a, b, d});
      s.surface.triangles.push_back({a, d, c});
    }
  }
}

} // namespace

LevelSurface cylinderLevel(double radiusMm, double thicknessMm, double x0, double x1,
                           double edgeMm) {
  base::require(radiusMm > 0.0 && thicknessMm > 0.0 && x0 < x1 && edgeMm > 0.0,
                "a cylinder of positive lengths");
  LevelSurface s;
  s.chart.periodMm = 2.0 * base::kPi * radiusMm;
  const int around = steps(2.0 * base::kPi, angularStep(radiusMm, edgeMm));
  const int along = steps(x1 - x0, edgeMm);
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * base::kPi * (i + 0.5 * (j % 2)) / around;
      const Vector3d direction(0.0, std::cos(angle), std::sin(angle));
      const double x = x0 + (x1 - x0) * j / along;
      append(s, Vector3d(x, 0.0, 0.0) + radiusMm * direction, direction, thicknessMm);
      s.chart.at.emplace_back(radiusMm * angle, x);
    }
  const auto at = [around](int j, int i) { return j * around + i % around; };
  for (int j = 0; j < along; ++j)
    appendRow(s, at, j, around);
  return s;
}

LevelSurface sphereLevel(const Vector3d& centre, double radiusMm, double thicknessMm,
                         const Eigen::AlignedBox3d& box, double edgeMm) {
  base::require(radiusMm > 0.0 && thicknessMm > 0.0 && edgeMm > 0.0 && !box.isEmpty(),
                "a sphere of positive lengths and a box");
  // Subdivides an icosahedron's faces until edges are short enough, discarding triangles outside
  // the box.
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Vector3d> unit = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  for (Vector3d& p : unit)
    p.normalize();
  std::vector<std::array<int, 3>> faces = {
      {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  const auto point = [&](int v) -> Vector3d {
    return centre + radiusMm * unit[static_cast<std::size_t>(v)];
  };
  const auto isNear = [&](const std::array<int, 3>& f) {
    const Vector3d middle =
        (unit[static_cast<std::size_t>(f[0])] + unit[static_cast<std::size_t>(f[1])] +
         unit[static_cast<std::size_t>(f[2])])
            .normalized();
    const Vector3d at = centre + radiusMm * middle;
    double reach = 0.0;
    for (int v : f)
      reach = std::max(reach, (point(v) - at).norm());
    return box.squaredExteriorDistance(at) <= reach * reach * 1.0001;
  };
  double edge = (point(0) - point(1)).norm();
  // The distance of a triangle's middle from the sphere is a third of the squared edge length
  // divided by 2 r.
  const double finest = std::min(edgeMm * 1.2, std::sqrt(6.0 * kChordMm * radiusMm));
  for (;; edge *= 0.5) {
    std::erase_if(faces, [&](const auto& f) { return !isNear(f); });
    if (edge <= finest)
      break;
    std::unordered_map<std::uint64_t, int> middleOf;
    const auto middle = [&](int a, int b) {
      const auto low = static_cast<std::uint64_t>(std::min(a, b)),
                 high = static_cast<std::uint64_t>(std::max(a, b));
      const auto [entry, isNew] =
          middleOf.try_emplace(low << 32 | high, static_cast<int>(unit.size()));
      if (isNew)
        unit.push_back((unit[low] + unit[high]).normalized());
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    finer.reserve(4 * faces.size());
    for (const auto& [a, b, c] : faces) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  LevelSurface s;
  for (std::size_t v = 0; v < unit.size(); ++v)
    append(s, centre + radiusMm * unit[v], unit[v], thicknessMm);
  s.surface.triangles = std::move(faces);
  layers::dropUnusedVertices(s);
  return s;
}

LevelSurface circleLevel(const FlatteningCircle& lower, const FlatteningCircle& upper,
                         double halfWidthMm, double x0, double x1, double edgeMm) {
  base::require(!lower.isPlane() && x0 < x1 && edgeMm > 0.0 && halfWidthMm > 0.0 &&
                    halfWidthMm < lower.radiusMm,
                "a circle, a width less than its own and a range");
  LevelSurface s;
  const double sideAngle = std::acos(halfWidthMm / lower.radiusMm);
  const double span = base::kPi - 2.0 * sideAngle;
  const int around = steps(span, angularStep(lower.radiusMm, edgeMm));
  const int along = steps(x1 - x0, edgeMm);
  // Rows are straight: trimming cuts off ends that are not a section of the part.
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= around; ++i) {
      const double alpha = sideAngle + span * i / around;
      const Vector3d direction(0.0, std::cos(alpha), std::sin(alpha));
      const double thickness = thicknessAt(lower, upper, alpha);
      base::require(thickness > 0.0, "circles that are apart over the width");
      append(s,
             Vector3d(x0 + (x1 - x0) * j / along, 0.0, lower.centreMm()) +
                 (lower.radiusMm + 0.5 * thickness) * direction,
             direction, thickness);
    }
  const auto at = [around](int j, int i) { return j * (around + 1) + i; };
  for (int j = 0; j < along; ++j)
    appendRow(s, at, j, around);
  return s;
}

} // namespace voluta::substrate
