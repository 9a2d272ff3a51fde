#include "replay/beneath.h"

#include "base/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::replay {

namespace {
using Eigen::Vector3d;

// Depth and lateral distance of the probes, in heights; each ring has kAzimuths of them. All are
// within 1.25 heights of the tip except the last ring, which handles cells that straddle two
// layers.
struct Ring {
  double depth, lateral;
};
constexpr std::array<Ring, 4> kRings = {{{1.25, 0.0}, {1.15, 0.48}, {1.05, 0.67}, {1.2, 0.7}}};
constexpr int kAzimuths = 12;
// Probes directly below: positions across the width, and depths in heights.
constexpr int kAcross = 8;
constexpr std::array<double, 3> kDepths = {1.05, 1.15, 1.25};
constexpr std::array<double, 3> kMiddle = {-0.15, 0.0, 0.15}; // in widths

// Returns whether a point is in the rectangle around a piece's section; flow fills that rectangle
// where there are neighbouring beads. The test extends beyondMm past the piece's ends, since a cell
// may be assigned to a neighbouring piece.
bool isIn(const BeadPiece& piece, const Vector3d& point, double beyondMm) {
  const Vector3d step = piece.to - piece.from;
  const double length = step.norm();
  if (!(length > 1e-9))
    return false;
  const double along = step.dot(point - piece.from) / length;
  if (along < -beyondMm || along > length + beyondMm)
    return false;
  const double t = std::clamp(along / length, 0.0, 1.0);
  const Vector3d up = ((1.0 - t) * piece.fromDirection + t * piece.toDirection).normalized();
  const Vector3d off = point - (piece.from + t * step);
  const BeadSection section = sectionOf(piece, widestOf(piece));
  const double planned = (1.0 - t) * static_cast<double>(piece.fromHeightMm) +
                         t * static_cast<double>(piece.toHeightMm);
  const double depth = -off.dot(up);
  // A section lower than planned keeps its bottom at the planned position.
  return depth >= planned - section.heightMm && depth <= planned &&
         std::abs(off.dot(up.cross(step).normalized())) <= 0.5 * section.widthMm;
}

// Returns whether a point is lower than a piece's bottom.
bool isUnder(const BeadPiece& piece, const Vector3d& point) {
  constexpr double kSlack = 1.02;
  const Vector3d up = (piece.fromDirection + piece.toDirection).normalized();
  const double height = 0.5 * (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
  return (0.5 * (piece.from + piece.to) - point).dot(up) > kSlack * height;
}
} // namespace

Beneath::Beneath(const std::vector<BeadPiece>& pieces, std::uint32_t index,
                 const PrintedPart& printed, const GroundProbe& ground)
    : pieces_(pieces), printed_(printed), ground_(ground) {
  const BeadPiece& piece = pieces[index];
  tip_ = 0.5 * (piece.from + piece.to);
  up_ = (piece.fromDirection + piece.toDirection).normalized();
  side_ = up_.cross(piece.to - piece.from);
  side_ = side_.norm() > 1e-9 ? side_.normalized() : up_.unitOrthogonal();
  height_ = 0.5 * (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
  width_ = sectionOf(piece, widestOf(piece)).widthMm;
  moment_ = {index, piece.run, piece.runMm, static_cast<float>(std::max(3.0, 2.0 * width_))};
}

bool Beneath::supported() const {
  const Vector3d other = up_.cross(side_);
  for (const Ring& ring : kRings) {
    const int count = ring.lateral > 0.0 ? kAzimuths : 1;
    for (int a = 0; a < count; ++a) {
      const double angle = 2.0 * base::kPi * a / kAzimuths;
      if (holds(tip_ - ring.depth * height_ * up_ +
                ring.lateral * height_ * (std::cos(angle) * side_ + std::sin(angle) * other)))
        return true;
    }
  }
  return false;
}

double Beneath::carriedShare() const {
  int carried = 0;
  for (int k = 0; k < kAcross; ++k)
    carried += carriedAt(((k + 0.5) / kAcross - 0.5) * width_);
  return static_cast<double>(carried) / kAcross;
}

bool Beneath::carriedAt(double lateralMm) const {
  const Vector3d at = tip_ + lateralMm * side_;
  return std::ranges::any_of(kDepths,
                             [&](double depth) { return holds(at - depth * height_ * up_); });
}

std::uint32_t Beneath::pieceBelow() const {
  std::uint32_t last = kNeverFilled;
  for (const double share : kMiddle)
    for (const double depth : kDepths) {
      const Vector3d point = tip_ + share * width_ * side_ - depth * height_ * up_;
      const std::uint32_t at = pieceAround(point);
      if (at != kNeverFilled)
        last = last == kNeverFilled ? at : std::max(last, at);
    }
  return last;
}

std::uint32_t Beneath::pieceAround(const Vector3d& point) const {
  constexpr std::uint32_t kNeighbours = 2;
  constexpr double kBeyondMm = 0.05;
  const std::uint32_t filler = printed_.pieceAt(point, moment_);
  if (filler == kNeverFilled)
    return kNeverFilled;
  // A cell may be assigned to a neighbouring piece of the same bead.
  const std::uint32_t first = filler - std::min(filler, kNeighbours);
  const auto end = std::min<std::size_t>(filler + kNeighbours + 1, moment_.before);
  for (std::uint32_t p = first; p < end; ++p)
    if (pieces_[p].run == pieces_[filler].run && isIn(pieces_[p], point, kBeyondMm))
      return p;
  return kNeverFilled;
}

bool Beneath::holds(const Vector3d& point) const {
  const std::uint32_t filler = printed_.pieceAt(point, moment_);
  const bool isFilled = filler != kNeverFilled && !isUnder(pieces_[filler], point);
  if (isFilled || ground_.holds(point, 0.25 * width_, moment_.before))
    return true;
  const double pitch = printed_.grid().pitch;
  const std::uint32_t below = printed_.pieceAt(point - pitch * up_, moment_);
  return below != kNeverFilled && isIn(pieces_[below], point, pitch);
}

} // namespace voluta::replay
