#include "toolpath/order/seam.h"

#include "base/error.h"
#include "base/mixed_bits.h"
#include "base/nearest_name.h"
#include "base/units.h"
#include "geometry/polyline.h"
#include "toolpath/unsupported/bead_tip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr std::array<SeamKind, 4> kKinds{{
    {"nearest", "where the travel is shortest"_text},
    {"aligned", "aligned from layer to layer"_text, alignedSeam},
    {"corner", "in a corner"_text, cornerSeam},
    {"spread", "spread over the part"_text, spreadSeam},
}};

constexpr double kReachWidths = 2.0; // from a seam to that of the next layer [bead widths]
// A bead extends along a direction if it does so by this share of its largest extent.
constexpr double kExtends = 0.3;
constexpr double kTilt = 0.02;
// A corner turns by at least this much, measured over so many bead widths both ways.
constexpr double kCornerRad = base::degreesToRadians(45.0), kArmWidths = 1.0;
// Corners about as sharp as the sharpest.
constexpr double kSimilarRad = base::degreesToRadians(15.0);

double lengthOf(const Bead& b, std::size_t segment) {
  return (tipOf(b.points[segment + 1]) - tipOf(b.points[segment])).norm();
}

std::size_t segmentsOf(const Bead& b) {
  return b.points.size() - 1;
}

// Returns the direction of the work frame in which the first seam is the furthest. It is tilted a
// little, so that on a straight side one end is further than the other.
Vector3d fixedDirection(const Bead& b) {
  Eigen::AlignedBox3d box;
  for (const BeadPoint& p : b.points)
    box.extend(tipOf(p));
  for (const int axis : {1, 2})
    if (box.sizes()[axis] >= kExtends * box.sizes().maxCoeff())
      return (Vector3d::Unit(axis) + kTilt * Vector3d(1.0, 0.5, 0.25)).normalized();
  return Vector3d::UnitX();
}

// Returns the seam below that is nearest to the place, if it is within reach.
std::optional<double> distanceBelow(const SeamInput& input, const SeamPlace& place) {
  const Vector3d tip = tipAt(input.bead, place);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3d& seam : input.below)
    nearest = std::min(nearest, (seam - tip).norm());
  if (nearest > kReachWidths * input.bead.points[place.segment].widthMm)
    return std::nullopt;
  return nearest;
}

// Returns the place of each segment nearest to a point.
SeamPlace nearestOnSegment(const Bead& b, std::size_t segment, const Vector3d& to) {
  const Vector3d a = tipOf(b.points[segment]), along = tipOf(b.points[segment + 1]) - a;
  const double share = along.dot(to - a) / std::max(1e-12, along.squaredNorm());
  // The end of a segment is the beginning of the next one.
  return share < 1.0 ? SeamPlace{segment, std::max(0.0, share)}
                     : SeamPlace{(segment + 1) % segmentsOf(b), 0.0};
}

// Returns the point `armMm` along the bead from points[i], onwards or back.
Vector3d alongBead(const Bead& b, std::size_t i, double armMm, bool onwards) {
  const std::size_t n = segmentsOf(b);
  Vector3d here = tipOf(b.points[i]);
  for (std::size_t step = 1; step <= n; ++step) {
    const Vector3d next = tipOf(b.points[(onwards ? i + step : i + n - step) % n]);
    const double length = (next - here).norm();
    if (length >= armMm)
      return here + armMm / length * (next - here);
    armMm -= length;
    here = next;
  }
  return here;
}

// Returns by how much the bead turns to the left at each of its points, seen from the nozzle.
std::vector<double> turnsLeft(const Bead& b) {
  std::vector<double> turns(segmentsOf(b));
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const BeadPoint& p = b.points[i];
    const double arm = kArmWidths * p.widthMm;
    const Vector3d in = tipOf(p) - alongBead(b, i, arm, false);
    const Vector3d out = alongBead(b, i, arm, true) - tipOf(p);
    turns[i] = std::atan2(p.direction.dot(in.cross(out)), in.dot(out));
  }
  return turns;
}

// Returns the places where the bead turns most, and about as much as there.
std::vector<SeamPlace> sharpest(std::span<const double> turns) {
  std::vector<SeamPlace> places;
  const double maximum = *std::ranges::max_element(turns);
  if (maximum < kCornerRad)
    return places;
  const std::size_t n = turns.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turns[i] >= maximum - kSimilarRad && turns[i] >= turns[(i + 1) % n] &&
        turns[i] > turns[(i + n - 1) % n])
      places.push_back({i, 0.0});
  return places;
}
} // namespace

std::span<const SeamKind> seamKinds() {
  return kKinds;
}

const SeamKind& seamKind(std::string_view id) {
  return base::rowWithId(seamKinds(), id, "unknown seam '{id}'"_text, "seam"_name);
}

SeamPlace preferredSeam(const SeamInput& input, std::span<const SeamPlace> places) {
  SeamPlace best = places.front();
  double nearest = std::numeric_limits<double>::infinity();
  for (const SeamPlace& place : places)
    if (const std::optional<double> d = distanceBelow(input, place); d && *d < nearest) {
      nearest = *d;
      best = place;
    }
  if (nearest < std::numeric_limits<double>::infinity())
    return best;
  const Vector3d direction = fixedDirection(input.bead);
  return *std::ranges::max_element(
      places, {}, [&](const SeamPlace& place) { return direction.dot(tipAt(input.bead, place)); });
}

SeamPlace alignedSeam(const SeamInput& input) {
  std::vector<SeamPlace> places;
  for (std::size_t i = 0; i < segmentsOf(input.bead); ++i)
    places.push_back({i, 0.0});
  for (const Vector3d& seam : input.below) {
    double nearest = std::numeric_limits<double>::infinity();
    SeamPlace best;
    for (std::size_t i = 0; i < segmentsOf(input.bead); ++i) {
      const SeamPlace place = nearestOnSegment(input.bead, i, seam);
      if (const double d = (tipAt(input.bead, place) - seam).squaredNorm(); d < nearest) {
        nearest = d;
        best = place;
      }
    }
    places.push_back(best);
  }
  return preferredSeam(input, places);
}

SeamPlace cornerSeam(const SeamInput& input) {
  std::vector<double> turns = turnsLeft(input.bead);
  const std::vector<SeamPlace> outwards = sharpest(turns);
  for (double& angle : turns)
    angle = -angle;
  const std::vector<SeamPlace> inwards = sharpest(turns);
  if (!inwards.empty())
    return preferredSeam(input, inwards);
  return outwards.empty() ? alignedSeam(input) : preferredSeam(input, outwards);
}

SeamPlace spreadSeam(const SeamInput& input) {
  const std::uint64_t layer = base::mixedBits(static_cast<std::uint64_t>(input.layer) + 1U);
  const std::uint64_t bits = base::mixedBits(layer + input.path);
  const std::vector<BeadPoint>& points = input.bead.points;
  const auto tip = [&](std::size_t i) { return tipOf(points[i]); };
  const double at =
      geometry::polylineLength(points.size(), tip) * (static_cast<double>(bits >> 11U) * 0x1p-53);
  const auto place = geometry::placeAfter(at, points.size(), tip);
  return place ? SeamPlace{place->segment, place->share} : SeamPlace{};
}

Vector3d tipAt(const Bead& bead, const SeamPlace& place) {
  const Vector3d a = tipOf(bead.points[place.segment]);
  return a + place.share * (tipOf(bead.points[place.segment + 1]) - a);
}

SeamPlace begunPlace(const Bead& bead, const SeamPlace& place) {
  const double length = lengthOf(bead, place.segment);
  if ((1.0 - place.share) * length < kSameSeamMm)
    return {(place.segment + 1) % segmentsOf(bead), 0.0};
  return place.share * length < kSameSeamMm ? SeamPlace{place.segment, 0.0} : place;
}

Bead begunAt(const Bead& bead, const SeamPlace& place) {
  base::require(bead.closed && place.segment < segmentsOf(bead), "the place is on a closed bead");
  Bead out = bead;
  out.points.pop_back();
  const SeamPlace begun = begunPlace(bead, place);
  std::size_t first = begun.segment;
  if (begun.share > 0.0) {
    const BeadPoint &a = bead.points[first], &b = bead.points[first + 1];
    const double t = begun.share;
    BeadPoint added;
    added.middle = a.middle + t * (b.middle - a.middle);
    added.direction = ((1.0 - t) * a.direction + t * b.direction).normalized();
    added.clearDirection = ((1.0 - t) * a.clearDirection + t * b.clearDirection).normalized();
    added.widthMm = std::lerp(a.widthMm, b.widthMm, t);
    added.heightMm = std::lerp(a.heightMm, b.heightMm, t);
    ++first;
    out.points.insert(out.points.begin() + static_cast<std::ptrdiff_t>(first), added);
  }
  std::ranges::rotate(out.points, out.points.begin() + static_cast<std::ptrdiff_t>(first));
  out.points.push_back(out.points.front());
  return out;
}

} // namespace voluta::toolpath
