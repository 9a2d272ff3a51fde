#include "geometry/placement.h"

#include "base/error.h"
#include "geometry/measures.h"

#include <cmath>
#include <fmt/format.h>

namespace voluta::geometry {

using Eigen::Vector3d;

TriangleMesh placeOnPlate(const TriangleMesh& mesh, double scale) {
  base::require(std::isfinite(scale) && scale > 0.0, "placeOnPlate: scale > 0");
  base::require(!mesh.empty(), "placeOnPlate: the mesh has triangles");
  const Eigen::AlignedBox3d box = bounds(mesh);
  const Vector3d foot(box.center().x(), box.center().y(), box.min().z());
  TriangleMesh placed = mesh;
  for (Vector3d& v : placed.vertices)
    v = scale * (v - foot);
  return placed;
}

UnitGuess guessUnits(const TriangleMesh& mesh) {
  UnitGuess guess;
  if (mesh.empty())
    return guess;
  guess.longestSideMm = bounds(mesh).sizes().maxCoeff();
  const auto suggest = [&](const char* unit, const char* words, double scale) {
    guess.unit = unit;
    guess.scale = scale;
    guess.note = fmt::format("longest side {:.4g} mm: perhaps the file is in {} (scale {:g})",
                             guess.longestSideMm, words, scale);
  };
  if (guess.longestSideMm > 10000.0)
    suggest("um", "micrometres", 0.001);
  else if (guess.longestSideMm < 2.0 && guess.longestSideMm >= 0.02)
    suggest("m", "metres", 1000.0);
  else if (guess.longestSideMm < 2.0)
    suggest("inch", "inches", 25.4);
  return guess;
}

} // namespace voluta::geometry
