#include "replay/underside.h"

#include <algorithm>

namespace voluta::replay {

using Eigen::Vector3d;

namespace {
constexpr double kCellMm = 2.0, kWidthsMax = 3.0; // at least; or a third of the maximum width
constexpr double kReachMm = 0.01;                 // smaller overlaps are rounding of programs

Eigen::AlignedBox3d boxOf(const FlatDisc& disc) {
  const Vector3d across =
      disc.radius * (1.0 - disc.normal.array().square()).max(0.0).sqrt().matrix();
  return {disc.centre - across, disc.centre + across};
}

Eigen::AlignedBox3d boxOf(const RoundedQuad& quad) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& corner : quad.corners)
    box.extend(corner);
  const Vector3d round = Vector3d::Constant(quad.radius);
  return {box.min() - round, box.max() + round};
}

// Returns whether the whole solid is on the disc's far side.
bool isBeneath(const RoundedQuad& quad, const FlatDisc& disc) {
  return std::ranges::all_of(quad.corners, [&](const Vector3d& corner) {
    return (corner - disc.centre).dot(disc.normal) < -quad.radius;
  });
}
} // namespace

RoundedQuad solidOf(const BeadPiece& piece, double widthMaxMm) {
  const BeadSection section = sectionOf(piece, widthMaxMm);
  const Vector3d step = piece.to - piece.from;
  Vector3d side = (piece.fromDirection + piece.toDirection).cross(step);
  side = side.norm() > 1e-9 ? Vector3d(side.normalized()) : piece.toDirection.unitOrthogonal();
  // A section lower than planned keeps its bottom at the planned height.
  const auto middle = [&](const Vector3d& tip, const Vector3d& up, float plannedMm) -> Vector3d {
    return tip - (static_cast<double>(plannedMm) - 0.5 * section.heightMm) * up;
  };
  const Vector3d from = middle(piece.from, piece.fromDirection, piece.fromHeightMm),
                 to = middle(piece.to, piece.toDirection, piece.toHeightMm),
                 flat = 0.5 * (section.widthMm - section.heightMm) * side;
  return {{from - flat, from + flat, to - flat, to + flat}, 0.5 * section.heightMm};
}

Underside::Underside(const process::HeadShape& head, const std::vector<BeadPiece>& pieces,
                     double widthMaxMm)
    : upMm_(head.sections.front().zMm) {
  for (const process::HeadSection& section : head.sections)
    if (section.zMm <= upMm_) // a step has several sections at one height
      radiusMm_ = std::max(radiusMm_, section.radiusMm);
  std::vector<Eigen::AlignedBox3d> boxes;
  pieces_.reserve(pieces.size());
  boxes.reserve(pieces.size());
  for (const BeadPiece& piece : pieces) {
    pieces_.push_back({solidOf(piece, widthMaxMm), piece.run, piece.runMm});
    boxes.push_back(boxOf(pieces_.back().solid));
  }
  near_ = geometry::BoxGrid(boxes, std::max(kCellMm, widthMaxMm / kWidthsMax));
}

std::optional<Vector3d> Underside::touched(const Vector3d& tip, const Vector3d& direction,
                                           const PrintState& moment) const {
  const FlatDisc disc{tip + upMm_ * direction, direction, radiusMm_};
  std::optional<Vector3d> where;
  near_.any(boxOf(disc), [&](std::uint32_t p) {
    const Piece& piece = pieces_[p];
    if (p >= moment.before || piece.solid.radius <= 0.0 ||
        (piece.run == moment.run && moment.runMm - piece.runMm <= moment.recentMm) ||
        isBeneath(piece.solid, disc) || distanceBetween(disc, piece.solid, kReachMm) > 0.0)
      return false;
    where = 0.5 * (piece.solid.corners[0] + piece.solid.corners[3]);
    return true;
  });
  return where;
}

} // namespace voluta::replay
