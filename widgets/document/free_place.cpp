#include "document/free_place.h"

#include <algorithm>

namespace voluta::document {

namespace {
using Eigen::AlignedBox2d;
using Eigen::Vector2d;

constexpr double kSameMm = 1e-9;

bool holds(const std::vector<Vector2d>& plate, const AlignedBox2d& box) {
  constexpr double kEdgeMm = 5.0; // for a priming bead
  for (std::size_t i = 0; i < plate.size(); ++i) {
    const Vector2d &a = plate[i], &b = plate[(i + 1) % plate.size()];
    const Vector2d along = (b - a).normalized(), inwards(-along.y(), along.x());
    for (const auto corner : {AlignedBox2d::BottomLeft, AlignedBox2d::BottomRight,
                              AlignedBox2d::TopLeft, AlignedBox2d::TopRight})
      if (inwards.dot(box.corner(corner) - a) < kEdgeMm - kSameMm)
        return false;
  }
  return true;
}

// Returns the centres at a distance of `gapMm` from one of the boxes, in the order in which they
// are tried; the first is that to the right of all.
std::vector<Vector2d> centresBeside(std::span<const AlignedBox2d> others, const Vector2d& sizeMm,
                                    double gapMm) {
  double right = others.front().max().x();
  for (const AlignedBox2d& box : others)
    right = std::max(right, box.max().x());
  const Vector2d half = 0.5 * sizeMm + Vector2d::Constant(gapMm);
  std::vector<Vector2d> centres{{right + half.x(), others.back().center().y()}};
  for (const AlignedBox2d& box : others) {
    const Vector2d at = box.center();
    centres.emplace_back(box.max().x() + half.x(), at.y());
    centres.emplace_back(at.x(), box.max().y() + half.y());
    centres.emplace_back(box.min().x() - half.x(), at.y());
    centres.emplace_back(at.x(), box.min().y() - half.y());
  }
  return centres;
}
} // namespace

Vector2d nextFreePlace(std::span<const AlignedBox2d> others, const Vector2d& sizeMm, double gapMm,
                       const std::vector<std::vector<Vector2d>>& plates) {
  if (others.empty())
    return Vector2d::Zero();
  const std::vector<Vector2d> centres = centresBeside(others, sizeMm, gapMm);
  for (const std::vector<Vector2d>& plate : plates)
    for (const Vector2d& centre : centres) {
      const AlignedBox2d box(centre - 0.5 * sizeMm, centre + 0.5 * sizeMm);
      const auto isClear = [&](const AlignedBox2d& other) {
        return box.exteriorDistance(other) >= gapMm - kSameMm;
      };
      if (holds(plate, box) && std::ranges::all_of(others, isClear))
        return centre;
    }
  return centres.front();
}

} // namespace voluta::document
