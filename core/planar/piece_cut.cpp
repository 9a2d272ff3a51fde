#include "planar/piece_cut.h"

#include "base/error.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"

#include <algorithm>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

Vector3d sectionMiddle(const TaggedMesh& solid, std::int32_t tag) {
  Vector3d sum = Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < solid.tag.size(); ++t)
    if (solid.tag[t] == tag) {
      const double a = geometry::triangleArea(solid.mesh, t);
      sum +=
          a * (solid.mesh.corner(t, 0) + solid.mesh.corner(t, 1) + solid.mesh.corner(t, 2)) / 3.0;
      area += a;
    }
  return area > 0.0 ? Vector3d(sum / area) : Vector3d::Zero();
}

} // namespace

bool allStands(const Piece& piece, const RiskRule& rule) {
  const geometry::Components parts = geometry::components(piece.solid.mesh);
  if (parts.count == 1)
    return baseArea(piece, rule) > 0.0;
  for (const TaggedMesh& solid : solids(piece.solid)) {
    Piece as = piece;
    as.solid = solid;
    if (!(baseArea(as, rule) > 0.0))
      return false;
  }
  return true;
}

PieceCut joined(PieceCut cut) {
  Piece& one = cut.above.front();
  for (std::size_t i = 1; i < cut.above.size(); ++i) {
    TaggedMesh& more = cut.above[i].solid;
    const std::int32_t own = cut.above[i].baseTag;
    std::replace(more.tag.begin(), more.tag.end(), own, one.baseTag);
    std::replace(cut.below.solid.tag.begin(), cut.below.solid.tag.end(), own, one.baseTag);
    geometry::appendMesh(one.solid.mesh, more.mesh);
    one.solid.tag.insert(one.solid.tag.end(), more.tag.begin(), more.tag.end());
  }
  cut.above.resize(1);
  cut.sectionMiddles = {sectionMiddle(one.solid, one.baseTag)};
  return cut;
}

std::optional<PieceCut> cutPiece(const Piece& piece, const Plane& plane, std::int32_t tag,
                                 const CutRules& rules) {
  double lost = 0.0;
  const auto wanted = [&](const TaggedMesh& solid) {
    if (geometry::volume(solid.mesh) < rules.minVolumeMm3)
      return false;
    Piece as;
    as.solid = solid;
    as.base = piece.base;
    as.baseTag = piece.baseTag;
    const std::vector<std::uint8_t> stands = standsOn(as, rules.rule);
    double before = 0.0, after = 0.0, contact = 0.0;
    for (std::size_t t = 0; t < stands.size(); ++t) {
      if (solid.tag[t] == tag || solid.tag[t] == kOnPrinted)
        continue;
      const Vector3d n = geometry::triangleNormal(solid.mesh, t);
      const double area = geometry::triangleArea(solid.mesh, t);
      if (stands[t])
        contact += area;
      else if (isRisky(n, piece.base.normal, rules.rule))
        before += area;
      if (!(stands[t] && piece.baseTag != kPlate) && isRisky(n, plane.normal, rules.rule))
        after += area;
    }
    if (before - after < rules.minGainMm2 || lost + contact > rules.maxContactLossMm2 + 1e-6)
      return false;
    lost += contact;
    return true;
  };
  return splitIfItCloses(piece, plane, tag, wanted, rules.rule);
}

std::optional<PieceCut> cutOffAt(const Piece& piece, const Plane& plane, std::int32_t tag,
                                 const std::vector<Vector3d>& sectionMiddles,
                                 const RiskRule& rule) {
  constexpr double kNearMm = 3.0;
  const auto wanted = [&](const TaggedMesh& solid) {
    const Vector3d middle = sectionMiddle(solid, tag);
    return std::any_of(sectionMiddles.begin(), sectionMiddles.end(),
                       [&](const Vector3d& m) { return (m - middle).norm() <= kNearMm; });
  };
  return splitIfItCloses(piece, plane, tag, wanted, rule);
}

std::optional<PieceCut> splitIfItCloses(const Piece& piece, const Plane& plane, std::int32_t tag,
                                        const Wanted& wanted, const RiskRule& rule) {
  try {
    return splitPiece(piece, plane, tag, wanted, rule);
  } catch (const base::Error& e) {
    if (e.code() != base::ErrorCode::UnusableInput)
      throw;
    return std::nullopt;
  }
}

std::optional<PieceCut> splitPiece(const Piece& piece, const Plane& plane, std::int32_t tag,
                                   const Wanted& wanted, const RiskRule& rule) {
  PlaneCut sides = cutByPlane(piece.solid, plane, tag, wanted);
  if (sides.above.empty() || sides.below.mesh.empty())
    return std::nullopt;
  PieceCut out;
  out.sectionMm2 = sides.sectionMm2;
  out.below = {std::move(sides.below), piece.base, piece.baseTag, -1, {}};
  if (!allStands(out.below, rule))
    return std::nullopt;
  for (std::size_t i = 0; i < sides.above.size(); ++i) {
    const std::int32_t own = tag + static_cast<std::int32_t>(i);
    out.sectionMiddles.push_back(sectionMiddle(sides.above[i], own));
    for (std::int32_t& t : sides.above[i].tag)
      if (t == piece.baseTag)
        t = kOnPrinted;
    out.above.push_back({std::move(sides.above[i]), {plane.normal, sides.offsetMm}, own, -1, {}});
    if (!(baseArea(out.above.back(), rule) > 0.0))
      return std::nullopt;
  }
  return out;
}

} // namespace voluta::planar
