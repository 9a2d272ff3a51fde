#include "planar/pieces.h"

#include "geometry/measures.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace voluta::planar {

Piece wholePart(const geometry::TriangleMesh& part, const RiskRule& rule) {
  Piece whole;
  whole.solid = splitAlong(tagged(part), {Eigen::Vector3d::UnitZ(), rule.contactMm});
  return whole;
}

bool isRisky(const Eigen::Vector3d& normal, const Eigen::Vector3d& direction,
             const RiskRule& rule) {
  return normal.dot(direction) + std::sin(rule.overhangRad) < 0.0;
}

std::vector<std::uint8_t> standsOn(const Piece& piece, const RiskRule& rule) {
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  std::vector<std::uint8_t> stands(mesh.triangles.size());
  for (std::size_t t = 0; t < stands.size(); ++t) {
    if (piece.baseTag != kPlate) {
      stands[t] = piece.solid.tag[t] == piece.baseTag;
      continue;
    }
    double highest = piece.base.heightOf(mesh.corner(t, 0));
    for (int k = 1; k < 3; ++k)
      highest = std::max(highest, piece.base.heightOf(mesh.corner(t, k)));
    stands[t] = highest <= rule.contactMm + 1e-6 &&
                geometry::triangleNormal(mesh, t).dot(piece.base.normal) < 0.0;
  }
  return stands;
}

std::vector<bool> riskyFaces(const Piece& piece, const RiskRule& rule) {
  const std::vector<std::uint8_t> stands = standsOn(piece, rule);
  std::vector<bool> risky(stands.size());
  for (std::size_t t = 0; t < risky.size(); ++t)
    risky[t] = !stands[t] && piece.solid.tag[t] != kOnPrinted &&
               isRisky(geometry::triangleNormal(piece.solid.mesh, t), piece.base.normal, rule);
  return risky;
}

double riskyArea(const Piece& piece, const RiskRule& rule) {
  const std::vector<bool> risky = riskyFaces(piece, rule);
  double sum = 0.0;
  for (std::size_t t = 0; t < risky.size(); ++t)
    sum += risky[t] ? geometry::triangleArea(piece.solid.mesh, t) : 0.0;
  return sum;
}

std::vector<std::int32_t> sectionsHeld(const Piece& piece) {
  std::set<std::int32_t> tags;
  for (const std::int32_t tag : piece.solid.tag)
    if (tag >= 0 && tag != piece.baseTag)
      tags.insert(tag);
  return {tags.begin(), tags.end()};
}

double baseArea(const Piece& piece, const RiskRule& rule) {
  const std::vector<std::uint8_t> stands = standsOn(piece, rule);
  double sum = 0.0;
  for (std::size_t t = 0; t < stands.size(); ++t)
    if (stands[t])
      sum += geometry::triangleArea(piece.solid.mesh, t);
  return sum;
}

} // namespace voluta::planar
