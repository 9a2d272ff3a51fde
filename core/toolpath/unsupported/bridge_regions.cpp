#include "toolpath/unsupported/bridge_regions.h"

#include "base/units.h"
#include "process/bead_model.h"
#include "toolpath/plane/connected_parts.h"
#include "toolpath/plane/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using ClipperLib::Paths;
using geometry::areaMm2;
using geometry::combined;

constexpr double kArcMm = 0.01; // chord error of round corners
constexpr double kStepDeg = 5.0;
constexpr std::size_t kMostEdges = 24; // whose directions are tried
// Lengths without a hold, as shares of all, that count as equal.
constexpr double kSameShare = 0.02;
constexpr double kSmallest = 4.0; // [beads squared]: smaller bridges are not worth their own lines
constexpr double kNarrowestGap = 1.5; // [beads]: usual lines cross narrower ones
constexpr double kHold = 0.8;         // [beads]: shorter ones hold nothing
constexpr double kNarrow = 1.5;     // [hatches]: narrower strips beside a bridge become part of it
constexpr double kTouchMm = 0.02;   // between a span and its hold
constexpr double kMeanShare = 0.01; // of the mean span, among directions of the same longest one

Paths moved(const Paths& paths, double byMm, ClipperLib::JoinType corners = ClipperLib::jtMiter) {
  return geometry::offsetPaths(paths, byMm, {kArcMm, corners});
}

// Returns the part of `area` that is at least `widthMm` wide, with its corners.
Paths widePart(const Paths& area, double widthMm) {
  const Paths core = moved(area, -0.5 * widthMm, ClipperLib::jtRound);
  return combined(moved(core, 0.75 * widthMm), area, ClipperLib::ctIntersection);
}

// The lines of one direction across a gap.
struct Spans {
  struct Span {
    double line = 0.0;
    Interval along;
  };
  ScanLines lines;
  std::vector<Span> held; // at both ends
  double heldMm = 0.0, freeMm = 0.0, longestMm = 0.0;

  double freeShare() const { return freeMm / std::max(heldMm + freeMm, 1e-9); }
  double cost() const {
    return longestMm +
           kMeanShare * heldMm / static_cast<double>(std::max<std::size_t>(held.size(), 1));
  }
};

// A gap in the layer below, or several that are close to each other.
class Gap {
public:
  // `wide`: the parts of the gap that are wider than a bead; `air`: around them all that has
  // nothing below; `holds`: beside it the area over the layer below.
  Gap(const Paths& wide, const Paths& air, const Paths& holds, const process::Process& process)
      : wide_(edgesOf(wide)), air_(edgesOf(air)), holds_(edgesOf(holds)),
        holdMm_(kHold * process.beadWidthMm),
        hatchMm_(process::hatchOf(process.beadWidthMm, process.layerHeightMm)) {}

  Spans spans(double directionRad) const {
    Spans spans{ScanLines::over(wide_, directionRad, hatchMm_), {}};
    const auto wide = spans.lines.inside(wide_), air = spans.lines.inside(air_),
               holds = spans.lines.inside(holds_);
    for (std::size_t line = 0; line < spans.lines.count(); ++line)
      for (const Interval& span : air[line]) {
        if (std::ranges::none_of(wide[line], [&](const Interval& own) {
              return own.first < span.second && own.second > span.first;
            }))
          continue;
        const double length = span.second - span.first;
        if (!isHeld(span, holds[line])) {
          spans.freeMm += length;
          continue;
        }
        spans.held.push_back({static_cast<double>(line), span});
        spans.heldMm += length;
        spans.longestMm = std::max(spans.longestMm, length);
      }
    return spans;
  }

  // Returns the direction of a bridge; nullopt if there is none.
  std::optional<Spans> best() const {
    std::vector<Spans> all;
    for (const double direction : directions())
      if (Spans made = spans(direction); !made.held.empty())
        all.push_back(std::move(made));
    if (all.empty())
      return std::nullopt;
    const double least = std::ranges::min(all, {}, &Spans::freeShare).freeShare() + kSameShare;
    std::erase_if(all, [&](const Spans& one) { return one.freeShare() > least; });
    return std::ranges::min(all, {}, &Spans::cost);
  }

private:
  bool isHeld(const Interval& span, const std::vector<Interval>& holds) const {
    const auto holdsAt = [&](double end, bool before) {
      return std::ranges::any_of(holds, [&](const Interval& hold) {
        const double near = before ? hold.second : hold.first;
        return hold.second - hold.first >= holdMm_ && std::abs(near - end) <= kTouchMm;
      });
    };
    return holdsAt(span.first, true) && holdsAt(span.second, false);
  }

  // Even steps, and along and across the longest edges.
  std::vector<double> directions() const {
    std::vector<double> all;
    std::vector<std::pair<double, double>> edges; // length, direction
    for (const ContourEdge& edge : wide_) {
      const Eigen::Vector2d along = edge.to - edge.from;
      if (along.norm() >= 2.0 * hatchMm_)
        edges.emplace_back(-along.norm(), std::atan2(along.y(), along.x()));
    }
    std::ranges::sort(edges);
    edges.resize(std::min(edges.size(), kMostEdges));
    for (const auto& [length, direction] : edges)
      for (const double turn : {0.5 * base::kPi, 0.0})
        all.push_back(std::remainder(direction + turn, base::kPi));
    for (double degrees = 0.0; degrees < 180.0; degrees += kStepDeg)
      all.push_back(base::degreesToRadians(degrees));
    return all;
  }

  std::vector<ContourEdge> wide_, air_, holds_;
  double holdMm_, hatchMm_;
};

// Returns the strips along the spans.
Paths stripsOf(const Spans& spans, double overlapMm) {
  constexpr double kHalf = 0.51; // [spacings]: neighbours overlap
  Paths strips;
  for (const Spans::Span& span : spans.held) {
    const auto corner = [&](double side, double alongMm) {
      return geometry::pathPoint(spans.lines.place(span.line + side, alongMm));
    };
    const double from = span.along.first - overlapMm, to = span.along.second + overlapMm;
    strips.push_back(
        {corner(-kHalf, from), corner(-kHalf, to), corner(kHalf, to), corner(kHalf, from)});
  }
  return geometry::united(strips);
}

double directionOf(const ScanLines& lines) {
  const Eigen::Vector2d along = lines.place(0.0, 1.0) - lines.place(0.0, 0.0);
  return std::atan2(along.y(), along.x());
}

// Adds to `bridge` the strips of `inside` beside it that are too narrow for other lines.
Paths withNarrowStrips(const Paths& bridge, const Paths& inside, const Paths& free,
                       double hatchMm) {
  const Paths rest = combined(inside, bridge, ClipperLib::ctDifference);
  const Paths narrow =
      combined(combined(rest, widePart(rest, kNarrow * hatchMm), ClipperLib::ctDifference),
               moved(bridge, kNarrow * hatchMm), ClipperLib::ctIntersection);
  const Paths all = combined(bridge, narrow, ClipperLib::ctUnion);
  return free.empty() ? all : combined(all, free, ClipperLib::ctDifference);
}

// Returns the bridge over one gap; nullopt if it is none. `around`: the gap with its overlap.
std::optional<BridgeRegion> bridgeOver(const Paths& around, const Paths& wide, const Paths& air,
                                       const Paths& holds, const Paths& inside,
                                       const process::Process& process) {
  const double bead = process.beadWidthMm, hatch = process::hatchOf(bead, process.layerHeightMm);
  const std::optional<Spans> spans = Gap(wide, air, holds, process).best();
  if (!spans)
    return std::nullopt;
  const Paths strips = stripsOf(*spans, 0.5 * bead);
  const Paths held = combined(wide, strips, ClipperLib::ctIntersection);
  if (areaMm2(held) < kSmallest * bead * bead)
    return std::nullopt;
  const Paths free = widePart(combined(wide, strips, ClipperLib::ctDifference), 0.5 * bead);
  Paths area = around;
  if (!free.empty())
    area =
        combined(combined(moved(held, kBridgeOverlap * hatch), around, ClipperLib::ctIntersection),
                 free, ClipperLib::ctDifference);
  return BridgeRegion{withNarrowStrips(area, inside, free, hatch), directionOf(spans->lines),
                      spans->longestMm};
}
} // namespace

Paths wideGaps(const Paths& air, const process::Process& process) {
  return widePart(air, kNarrowestGap * process.beadWidthMm);
}

std::vector<BridgeRegion> bridgeRegions(const Paths& inside, const Paths& below,
                                        const process::Process& process) {
  std::vector<BridgeRegion> regions;
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  const Paths air = combined(inside, below, ClipperLib::ctDifference);
  const Paths wide = wideGaps(air, process);
  if (wide.empty())
    return regions;
  const Paths holds = combined(inside, below, ClipperLib::ctIntersection);
  Paths taken;
  for (const Paths& part : connectedParts(inside))
    for (const Paths& around : connectedParts(
             combined(moved(wide, kBridgeOverlap * hatch), part, ClipperLib::ctIntersection))) {
      const auto within = [&](const Paths& area) {
        return combined(area, around, ClipperLib::ctIntersection);
      };
      const Paths own = within(wide);
      if (own.empty())
        continue; // beside a gap of another part
      auto bridge = bridgeOver(around, own, within(air), within(holds), part, process);
      if (!bridge)
        continue;
      if (!taken.empty())
        bridge->area = combined(bridge->area, taken, ClipperLib::ctDifference);
      taken = combined(taken, bridge->area, ClipperLib::ctUnion);
      regions.push_back(std::move(*bridge));
    }
  return regions;
}

} // namespace voluta::toolpath
