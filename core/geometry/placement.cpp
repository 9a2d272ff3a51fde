#include "geometry/placement.h"

#include "base/error.h"
#include "geometry/least_turn.h"
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

TriangleMesh place(const TriangleMesh& mesh, double scale, const Placement& placement) {
  const Eigen::Vector4d& q = placement.rotation.coeffs();
  base::require(q.allFinite() && q.norm() > 0.0, "place: a rotation that is finite and not zero");
  base::require(placement.centreMm.allFinite() && std::isfinite(placement.liftMm),
                "place: centre and lift finite");
  // Skipped where they change nothing: adding 0 or an identity rotation would still change -0 to 0.
  TriangleMesh placed;
  if (q.head<3>().isZero(0.0)) {
    placed = placeOnPlate(mesh, scale);
  } else {
    const Eigen::Matrix3d rotation = placement.rotation.normalized().toRotationMatrix();
    TriangleMesh turned = mesh;
    for (Vector3d& v : turned.vertices)
      v = rotation * v;
    placed = placeOnPlate(turned, scale);
  }
  const Vector3d shift(placement.centreMm.x(), placement.centreMm.y(), placement.liftMm);
  if (!shift.isZero(0.0))
    for (Vector3d& v : placed.vertices)
      v += shift;
  return placed;
}

Eigen::Quaterniond rotationLayingFlat(const Vector3d& normal) {
  base::require(normal.allFinite() && normal.norm() > 0.0, "rotationLayingFlat: a direction");
  const Vector3d n = normal.normalized();
  // For the opposite direction the shortest rotation is not unique: rotate about x.
  if (n.z() > 1.0 - 1e-12)
    return Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
  return shortestRotation(n, -Vector3d::UnitZ()).normalized();
}

UnitGuess guessUnits(const TriangleMesh& mesh) {
  UnitGuess guess;
  if (mesh.empty())
    return guess;
  guess.longestSideMm = bounds(mesh).sizes().maxCoeff();
  const auto suggest = [&](const char* unit, base::Text words, double scale) {
    guess.unit = unit;
    guess.scale = scale;
    guess.note =
        base::message("longest side {longest:.4g}: the file may be in {unit} (scale {scale})"_text,
                      base::mm(guess.longestSideMm), words, base::number(scale));
  };
  if (guess.longestSideMm > 10000.0)
    suggest("um", "micrometres"_text, 0.001);
  else if (guess.longestSideMm < 2.0 && guess.longestSideMm >= 0.02)
    suggest("m", "metres"_text, 1000.0);
  else if (guess.longestSideMm < 2.0)
    suggest("inch", "inches"_text, 25.4);
  return guess;
}

} // namespace voluta::geometry
