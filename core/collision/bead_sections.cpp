#include "collision/bead_sections.h"

#include "geometry/golden_section.h"
#include "geometry/nearest_share.h"

#include <algorithm>
#include <cmath>

namespace voluta::collision {

using Eigen::Vector3d;

namespace {
constexpr double kCellMm = 2.0; // or the mean width of wider beads

double pointDistance(const Disc& disc, const Vector3d& point) {
  const Vector3d r = point - disc.centre;
  const double up = r.dot(disc.normal);
  const double out = std::max(0.0, (r - up * disc.normal).norm() - disc.radius);
  return std::sqrt(up * up + out * out); // hypot() is ten times as slow
}

// Returns the minimum of a convex function over [low, high], or the first value found at or below
// `enough`.
template <typename Value>
double minimumOf(const Value& value, double low, double high, double enough) {
  constexpr int kSteps = 20; // 7e-5 of the range
  geometry::GoldenSection search(value, low, high);
  double minimum = std::min({search.atA, search.atB, value(low), value(high)});
  for (int k = 0; k < kSteps && minimum > enough; ++k) {
    search.step();
    minimum = std::min({minimum, search.atA, search.atB});
  }
  return minimum;
}

Eigen::AlignedBox3d boxOf(const Disc& disc) {
  const Vector3d across =
      disc.radius * (1.0 - disc.normal.array().square()).max(0.0).sqrt().matrix();
  return {disc.centre - across, disc.centre + across};
}

Eigen::AlignedBox3d boxOf(const BeadSection& bead) {
  const Vector3d end = bead.start + bead.along;
  const Vector3d reach = bead.halfFlat * bead.side.cwiseAbs() + Vector3d::Constant(bead.radius);
  return {bead.start.cwiseMin(end) - reach, bead.start.cwiseMax(end) + reach};
}

double topOf(const BeadSection& bead) {
  return bead.start.z() + std::max(0.0, bead.along.z()) + bead.halfFlat * std::abs(bead.side.z()) +
         bead.radius;
}

// Returns whether the whole bead is on one side of the disc's plane: beneath it for side = 1, above
// it for -1.
bool isBeside(const BeadSection& bead, const Disc& disc, double side) {
  const double start = side * (bead.start - disc.centre).dot(disc.normal);
  return std::max(start, start + side * bead.along.dot(disc.normal)) +
             bead.halfFlat * std::abs(bead.side.dot(disc.normal)) <
         -bead.radius;
}

// Returns whether discDistance() is not positive. Few pairs need its search.
bool isReached(const BeadSection& bead, const Disc& disc) {
  const Vector3d end = bead.start + bead.along;
  const Vector3d nearest =
      bead.start + geometry::nearestShare(disc.centre, bead.start, end) * bead.along;
  if ((disc.centre - nearest).norm() > disc.radius + bead.radius + bead.halfFlat)
    return false;
  return pointDistance(disc, nearest) <= bead.radius || discDistance(disc, bead) <= 0.0;
}
} // namespace

BeadSection beadSection(const plan::ToolPlan& plan, std::size_t i) {
  const auto middle = [&](std::size_t w) -> Vector3d {
    return plan.position[w] - 0.5 * static_cast<double>(plan.heightMm[w]) * plan.direction[w];
  };
  const double height =
      0.5 * (static_cast<double>(plan.heightMm[i]) + static_cast<double>(plan.heightMm[i + 1]));
  const double width =
      0.5 * (static_cast<double>(plan.widthMm[i]) + static_cast<double>(plan.widthMm[i + 1]));
  BeadSection bead;
  bead.start = middle(i);
  bead.along = middle(i + 1) - bead.start;
  bead.side = (plan.direction[i] + plan.direction[i + 1]).cross(bead.along);
  bead.side = bead.side.norm() > 1e-9 ? Vector3d(bead.side.normalized())
                                      : Vector3d(plan.direction[i].unitOrthogonal());
  bead.halfFlat = 0.5 * std::max(0.0, width - height);
  bead.radius = 0.5 * std::min(width, height);
  return bead;
}

double discDistance(const Disc& disc, const BeadSection& bead) {
  const double core = minimumOf(
      [&](double t) {
        const Vector3d at = bead.start + t * bead.along;
        return minimumOf(
            [&](double lateral) { return pointDistance(disc, at + lateral * bead.side); },
            -bead.halfFlat, bead.halfFlat, bead.radius);
      },
      0.0, 1.0, bead.radius);
  return core - bead.radius;
}

BeadSections::BeadSections(const plan::ToolPlan& plan, const std::vector<std::uint32_t>& segments)
    : printedAt_(segments), places_(plan.waypointCount()) {
  for (std::size_t p = 0; p < plan.paths.size(); ++p) {
    const plan::ToolPath& path = plan.paths[p];
    double mm = 0.0;
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      if (i > path.first)
        mm += (plan.position[i] - plan.position[i - 1]).norm();
      places_[i] = {static_cast<std::uint32_t>(p), static_cast<float>(mm), 2.0f * plan.widthMm[i]};
    }
  }
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::uint32_t& segment : printedAt_) {
    beads_.push_back(beadSection(plan, segment));
    boxes.push_back(boxOf(beads_.back()));
    topMm_.push_back(std::max(topMm_.empty() ? -INFINITY : topMm_.back(), topOf(beads_.back())));
    ++segment;
  }
  double widths = 0.0;
  for (const float width : plan.widthMm)
    widths += static_cast<double>(width);
  const double mean = widths / std::max<double>(1.0, static_cast<double>(plan.widthMm.size()));
  near_ = geometry::BoxGrid(boxes, std::max(kCellMm, mean));
}

bool BeadSections::isSoft(std::size_t waypoint, std::size_t printing) const {
  if (printing >= places_.size())
    return false;
  const Place &printed = places_[waypoint], &now = places_[printing];
  return printed.path == now.path && now.mm - printed.mm <= now.softMm;
}

bool BeadSections::reachedBy(const Disc& disc, std::size_t printing) const {
  const Eigen::AlignedBox3d box = boxOf(disc);
  // Most heads are above all that is printed.
  const auto printed = std::ranges::lower_bound(printedAt_, printing) - printedAt_.begin();
  if (printed == 0 || box.min().z() > topMm_[static_cast<std::size_t>(printed - 1)])
    return false;
  return near_.any(box, [&](std::uint32_t b) {
    return printedAt_[b] < printing && !isBeside(beads_[b], disc, 1.0) &&
           !isBeside(beads_[b], disc, -1.0) && !isSoft(printedAt_[b], printing) &&
           isReached(beads_[b], disc);
  });
}

} // namespace voluta::collision
