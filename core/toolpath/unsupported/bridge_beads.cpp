#include "toolpath/unsupported/bridge_beads.h"

#include "process/bead_model.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/plane/contours.h"
#include "toolpath/plane/scan_lines.h"
#include "toolpath/plane/spaced_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector2d;

constexpr double kInset = 0.5;            // [spacings] of line ends from the region's edge
constexpr double kShortest = 1.5;         // [spacings] of a region's stretch that has a line
constexpr double kCorner = 0.25;          // [spacings] that are cut from corners of joints
constexpr double kLongestJoint = 3.0;     // [spacings]
constexpr double kGap = 0.5, kHold = 0.5; // [beads]: shorter ones are none

// Lines joined end to end.
struct Chain {
  PlaneLine line;
  std::size_t last = 0; // number of the last line
  bool endsHigh = false;
  bool isHeld = false;
};

class BridgeLines {
public:
  BridgeLines(const BridgeRegion& region, const ClipperLib::Paths& below, double hatchMm,
              double beadMm, double longestMm)
      : edges_(edgesOf(region.area)), lines_(ScanLines::over(edges_, region.directionRad, hatchMm)),
        area_(region.area), below_(below), beadMm_(beadMm), longestMm_(longestMm) {
    const auto inside = lines_.inside(edges_), holds = lines_.inside(edgesOf(below));
    for (std::size_t i = 0; i < lines_.count(); ++i)
      for (const Interval& stretch : inside[i])
        if (stretch.second - stretch.first >= kShortest * lines_.spacingMm())
          add(i, stretch, isHeld(stretch, mergedIntervals(holds[i])));
  }

  double spacingMm() const { return lines_.spacingMm(); }
  const std::vector<Chain>& chains() const { return chains_; }

private:
  // Returns whether what is between the holds can be bridged.
  bool isHeld(const Interval& stretch, const std::vector<Interval>& holds) const {
    double end = stretch.first; // of the last hold
    for (const auto& [low, high] : holds) {
      const double from = std::max(low, stretch.first), to = std::min(high, stretch.second);
      if (to - from < kHold * beadMm_)
        continue;
      const double gap = from - end;
      if (gap > kGap * beadMm_ && (end == stretch.first || gap > longestMm_))
        return false;
      end = to;
    }
    return stretch.second - end <= kGap * beadMm_;
  }

  void add(std::size_t number, const Interval& stretch, bool isHeld) {
    const double inset = kInset * lines_.spacingMm();
    const Vector2d low = lines_.place(static_cast<double>(number), stretch.first + inset),
                   high = lines_.place(static_cast<double>(number), stretch.second - inset);
    const auto continued = std::ranges::find_if(chains_, [&](const Chain& chain) {
      return chain.last + 1 == number && chain.isHeld == isHeld &&
             isJoint(chain.line.points.back(), chain.endsHigh ? high : low);
    });
    Chain& chain =
        continued == chains_.end() ? chains_.emplace_back(Chain{{}, 0, false, isHeld}) : *continued;
    chain.last = number;
    addLine(chain.endsHigh ? high : low, chain.endsHigh ? low : high, chain.line.points);
    chain.endsHigh = !chain.endsHigh;
  }

  // Appends a line. The corners of its joint are cut, so that no bead turns at one place by more
  // than 45 degrees.
  void addLine(const Vector2d& from, const Vector2d& to, std::vector<Vector2d>& points) const {
    if (!points.empty()) {
      const Vector2d corner = points.back(), along = (corner - points[points.size() - 2]),
                     joint = from - corner, on = to - from;
      const double cut =
          std::min({kCorner * lines_.spacingMm(), joint.norm() / 3.0, on.norm() / 3.0});
      points.back() = corner - cut * along.normalized();
      points.push_back(corner + cut * joint.normalized());
      points.push_back(from - cut * joint.normalized());
      points.push_back(from + cut * on.normalized());
    } else
      points.push_back(from);
    points.push_back(to);
  }

  // Returns whether a bead from `a` to `b` rests on the layer below.
  bool isJoint(const Vector2d& a, const Vector2d& b) const {
    constexpr int kPlaces = 8;
    if ((b - a).norm() > kLongestJoint * lines_.spacingMm())
      return false;
    for (int k = 0; k <= kPlaces; ++k) {
      const Vector2d place = a + (b - a) * k / kPlaces;
      if (!area_.contains(place) || !below_.contains(place))
        return false;
    }
    return true;
  }

  std::vector<ContourEdge> edges_;
  ScanLines lines_;
  Contours area_, below_;
  double beadMm_, longestMm_;
  std::vector<Chain> chains_;
};

// Returns the hatch with which the lines fill the region.
double fillingHatch(const BridgeLines& lines, const BridgeRegion& region) {
  constexpr double kCorrection = 0.05; // of the spacing, at most
  double length = 0.0;
  for (const Chain& chain : lines.chains())
    for (std::size_t i = 0; i + 1 < chain.line.points.size(); ++i)
      length += (chain.line.points[i + 1] - chain.line.points[i]).norm();
  const double spacing = lines.spacingMm();
  return std::clamp(geometry::areaMm2(region.area) / std::max(length, spacing),
                    (1.0 - kCorrection) * spacing, (1.0 + kCorrection) * spacing);
}
} // namespace

std::vector<Bead> bridgeBeads(const BridgeRegion& region, const ClipperLib::Paths& below,
                              const PlanePatch& plane, const process::Process& process,
                              double longestMm, double stepMm) {
  std::vector<Bead> beads;
  if (region.area.empty())
    return beads;
  const double height = plane.thicknessMm;
  const double hatch = process::hatchOf(process.beadWidthMm, std::min(height, process.beadWidthMm));
  const BridgeLines lines(region, below, hatch, process.beadWidthMm, longestMm);
  const double width =
      std::max(height, std::clamp(process::widthOfHatch(fillingHatch(lines, region), height),
                                  process.beadWidthMinMm, process.beadWidthMaxMm));
  const double chordMm = ResampleOptions().scaled(largeBeadScaleOf(process)).chordMm;
  for (const Chain& chain : lines.chains()) {
    Bead& bead = beads.emplace_back();
    bead.kind = chain.isHeld ? plan::PathKind::Bridge : plan::PathKind::Infill;
    for (const Vector2d& p : spacedPoints(chain.line, chordMm, stepMm).points)
      bead.points.push_back({plane.place(p), plane.direction, plane.clearDirection, width, height});
  }
  return beads;
}

} // namespace voluta::toolpath
