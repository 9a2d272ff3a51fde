#include "planar/published/section_cut.h"

#include "base/error.h"
#include "geometry/edges.h"

#include <algorithm>

namespace voluta::planar {

namespace {

// Returns whether the section that the piece is printed on shares an edge with another section.
bool meetsOther(const Piece& piece) {
  const auto section = [&](std::size_t t) { return piece.solid.tag[t] == piece.baseTag; };
  const auto other = [&](std::size_t t) { return piece.solid.tag[t] != kSkin && !section(t); };
  bool meets = false;
  const auto sides = geometry::sortedHalfEdges(piece.solid.mesh);
  geometry::forEachEdge(sides, [&](std::size_t begin, std::size_t end) {
    bool one = false, another = false;
    for (std::size_t i = begin; i < end; ++i) {
      const auto t = static_cast<std::size_t>(sides[i].triangle);
      one = one || section(t);
      another = another || other(t);
    }
    meets = meets || (one && another);
  });
  return meets;
}

} // namespace

std::optional<PieceCut> constrainedCut(const Piece& piece, const Plane& plane, std::int32_t tag,
                                       const Wanted& wanted, const PlanarOptions& options,
                                       const Footing& footing, SectionContact sections) {
  if (plane.normal.z() < options.lowestZ)
    return std::nullopt;
  try {
    auto cut = splitPiece(piece, plane, tag, wanted, options.rule);
    if (!cut || (sections == SectionContact::Apart &&
                 std::any_of(cut->above.begin(), cut->above.end(), meetsOther)))
      return std::nullopt;
    if (piece.baseTag == kPlate) {
      const Footing remaining = footingOf(cut->below, options.rule);
      if (remaining.contactMm2 < options.keptContact * footing.contactMm2 ||
          remaining.hullMm2 < options.keptHull * footing.hullMm2)
        return std::nullopt;
    }
    return cut;
  } catch (const base::Error& e) {
    if (e.code() != base::ErrorCode::UnusableInput)
      throw;
    return std::nullopt;
  }
}

} // namespace voluta::planar
