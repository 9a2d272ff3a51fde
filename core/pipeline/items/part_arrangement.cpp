#include "pipeline/items/part_arrangement.h"

#include "base/units.h"
#include "geometry/convex_polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace voluta::pipeline {

namespace {
using Eigen::Vector2d;

constexpr double kStepMm = 2.0; // Between the places tried
constexpr double kFarthestMm = 5000.0;

Eigen::AlignedBox2d boxOf(const Footprint& part) {
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : part.outline)
    box.extend(p);
  return box;
}

Footprint movedBy(Footprint part, const Vector2d& by) {
  for (Vector2d& p : part.outline)
    p += by;
  return part;
}

class Arranger {
public:
  Arranger(std::span<const Footprint> parts, const process::HeadShape& head,
           const ArrangeOptions& options)
      : parts_(parts), head_(head), options_(options) {
    for (const Vector2d& corner : options.plate)
      centre_ += corner / static_cast<double>(options.plate.size());
  }

  std::optional<std::vector<Vector2d>> run() {
    std::vector<std::size_t> largestFirst(parts_.size());
    std::iota(largestFirst.begin(), largestFirst.end(), std::size_t{0});
    std::ranges::stable_sort(largestFirst, std::greater<>(),
                             [this](std::size_t i) { return boxOf(parts_[i]).diagonal().norm(); });
    std::vector<Vector2d> by(parts_.size(), Vector2d::Zero());
    for (const std::size_t i : largestFirst) {
      const auto place = nearestPlace(parts_[i]);
      if (!place)
        return std::nullopt;
      by[i] = *place;
      placed_.push_back(movedBy(parts_[i], *place));
    }
    centre(by);
    return by;
  }

private:
  // The part is printed before or after its neighbour, whichever needs less.
  double neededMm(const Footprint& a, const Footprint& b) const {
    const bool above = options_.order == layers::PrintOrder::OneAfterAnother || a.leans || b.leans;
    const double head = above ? std::min(headNeedsMm(head_, a, b), headNeedsMm(head_, b, a)) : 0.0;
    return head + options_.spareMm;
  }

  bool isOnPlate(const Footprint& part) const {
    return options_.plate.empty() ||
           std::ranges::all_of(
               geometry::convexPolygon(part.outline, options_.spareMm),
               [this](const Vector2d& p) { return geometry::inConvexPolygon(options_.plate, p); });
  }

  bool isFree(const Footprint& part) const {
    return isOnPlate(part) && std::ranges::all_of(placed_, [&](const Footprint& other) {
             const double needed = neededMm(part, other);
             return boxOf(part).exteriorDistance(boxOf(other)) >= needed ||
                    gapBetween(part, other) >= needed;
           });
  }

  // Returns the move to the free place that is nearest to the centre, tried on rings around it.
  std::optional<Vector2d> nearestPlace(const Footprint& part) const {
    const Vector2d toCentre = centre_ - boxOf(part).center();
    for (double radius = 0.0; radius <= kFarthestMm; radius += kStepMm) {
      const auto places = std::max(1, static_cast<int>(2.0 * base::kPi * radius / kStepMm / 4.0));
      for (int k = 0; k < places; ++k) {
        const double angle = 2.0 * base::kPi * k / places;
        const Vector2d by = toCentre + radius * Vector2d(std::cos(angle), std::sin(angle));
        if (isFree(movedBy(part, by)))
          return by;
      }
      if (!options_.plate.empty() && radius > plateRadius())
        return std::nullopt;
    }
    return std::nullopt;
  }

  double plateRadius() const {
    double radius = 0.0;
    for (const Vector2d& corner : options_.plate)
      radius = std::max(radius, (corner - centre_).norm());
    return radius;
  }

  // Moves all parts so that their common box is centred, unless one would leave the plate.
  void centre(std::vector<Vector2d>& by) const {
    Eigen::AlignedBox2d all;
    for (const Footprint& part : placed_)
      all.extend(boxOf(part));
    const Vector2d shift = centre_ - all.center();
    if (std::ranges::all_of(placed_,
                            [&](const Footprint& p) { return isOnPlate(movedBy(p, shift)); }))
      for (Vector2d& move : by)
        move += shift;
  }

  std::span<const Footprint> parts_;
  const process::HeadShape& head_;
  const ArrangeOptions& options_;
  Vector2d centre_ = Vector2d::Zero();
  std::vector<Footprint> placed_;
};
} // namespace

std::optional<std::vector<Vector2d>> arranged(std::span<const Footprint> parts,
                                              const process::HeadShape& head,
                                              const ArrangeOptions& options) {
  return Arranger(parts, head, options).run();
}

} // namespace voluta::pipeline
