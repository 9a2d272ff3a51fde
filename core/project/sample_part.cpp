#include "project/sample_part.h"

#include "base/units.h"

#include <cmath>

namespace voluta::project {

namespace {

constexpr int kAround = 96, kLevels = 66;
constexpr double kHeight = 60.0;

// Smooth step from 0 to 1 with flat ends.
double ease(double t) {
  return 0.5 - 0.5 * std::cos(base::kPi * t);
}

double radiusAt(double z) {
  constexpr double foot = 17.0, waist = 11.0, belly = 20.0, neck = 12.0;
  constexpr double waistZ = 14.0, bellyZ = 38.0;
  if (z < waistZ)
    return foot + (waist - foot) * ease(z / waistZ);
  if (z < bellyZ)
    return waist + (belly - waist) * ease((z - waistZ) / (bellyZ - waistZ));
  return belly + (neck - belly) * ease((z - bellyZ) / (kHeight - bellyZ));
}

} // namespace

geometry::TriangleMesh samplePart() {
  geometry::TriangleMesh mesh;
  const auto at = [](int level, int j) { return level * kAround + j % kAround; };
  for (int level = 0; level <= kLevels; ++level) {
    const double t = static_cast<double>(level) / kLevels, z = t * kHeight;
    // The axis starts upright; flutes fade out towards the foot and turn with height.
    const double axisX = 8.0 * ease(t) - 3.0, flute = 0.05 * ease(t), rotation = 0.8 * t;
    for (int j = 0; j < kAround; ++j) {
      const double angle = 2.0 * base::kPi * j / kAround;
      const double radius = radiusAt(z) * (1.0 + flute * std::cos(6.0 * (angle - rotation)));
      mesh.vertices.emplace_back(axisX + radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (int level = 0; level < kLevels; ++level)
    for (int j = 0; j < kAround; ++j) {
      mesh.triangles.push_back({at(level, j), at(level, j + 1), at(level + 1, j + 1)});
      mesh.triangles.push_back({at(level, j), at(level + 1, j + 1), at(level + 1, j)});
    }
  const int bottom = static_cast<int>(mesh.vertices.size()), top = bottom + 1;
  mesh.vertices.emplace_back(-3.0, 0.0, 0.0);
  mesh.vertices.emplace_back(5.0, 0.0, kHeight);
  for (int j = 0; j < kAround; ++j) {
    mesh.triangles.push_back({bottom, at(0, j + 1), at(0, j)});
    mesh.triangles.push_back({top, at(kLevels, j), at(kLevels, j + 1)});
  }
  return mesh;
}

} // namespace voluta::project
