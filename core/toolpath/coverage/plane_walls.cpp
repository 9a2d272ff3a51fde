#include "toolpath/coverage/plane_walls.h"

#include "process/bead_model.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/walls.h"
#include "toolpath/plane/connected_parts.h"
#include "toolpath/plane/plane_patch.h"
#include "toolpath/plane/spaced_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {
using ClipperLib::Paths;
using geometry::areaMm2;
using geometry::combined;

constexpr double kArc = 0.005; // [hatches] chord error of round corners
// [hatches], half widths of gaps: narrower ones are left to the beads beside them, and those for
// one or two beads are tiled together with the walls. The rest has no narrower tails.
constexpr double kNarrowest = 0.04, kTwoBeads = 1.0, kTail = 0.2;
constexpr double kWideShare = 0.5;    // of an area that is wider than two beads
constexpr double kShortestGap = 4.0;  // [hatches]: shorter ones have no bead
constexpr double kLargestDash = 0.3;  // [hatches squared]: what stays open beside a corner
constexpr double kSmallestRing = 6.5; // [hatches] length of a wall that is no mere blob
constexpr double kCorrection = 0.04;  // of widths, at most

// Drops the points that round corners do not need: repeated offsets would double them each time.
Paths moved(const Paths& paths, double hatches, double hatchMm) {
  Paths out = geometry::offsetPaths(paths, hatches * hatchMm, {kArc * hatchMm});
  ClipperLib::CleanPolygons(out, 0.5 * kArc * hatchMm * geometry::kPathUnits);
  return out;
}

// Returns the region that the wall at `level` hatches encloses, opened as by openedAt().
Paths wallRegion(const Paths& outline, double level, double hatchMm) {
  const double closing = wallClosing(level);
  const Paths inner = moved(outline, -(level + kWallInwards), hatchMm);
  return moved(moved(inner, kWallInwards + closing, hatchMm), -closing, hatchMm);
}

double lengthMm(const Paths& paths) {
  double sum = 0.0;
  for (const ClipperLib::Path& path : paths)
    for (std::size_t i = 0; i < path.size(); ++i)
      sum += (geometry::pointMm(path[(i + 1) % path.size()]) - geometry::pointMm(path[i])).norm();
  return sum;
}

// Returns whether a wall around the region runs beside itself closer than its hatch.
bool isTight(const Paths& region, double hatchMm) {
  constexpr double kHalf = 0.48, kCornerMm2 = 0.3; // [hatches], [hatches squared]
  const Paths wide = moved(moved(region, -kHalf, hatchMm), kHalf, hatchMm);
  const std::vector<Paths> tight = connectedParts(combined(region, wide, ClipperLib::ctDifference));
  return std::ranges::any_of(
      tight, [&](const Paths& part) { return areaMm2(part) > kCornerMm2 * hatchMm * hatchMm; });
}

bool isUsual(const std::vector<double>& widthMm, const process::Process& process) {
  constexpr double kSameMm = 1e-6;
  return std::ranges::all_of(widthMm,
                             [&](double w) { return std::abs(w - process.beadWidthMm) < kSameMm; });
}

// Returns the area inside the walls for other beads; nullopt if a long part of it is a gap for one
// or two beads, or too narrow for one.
std::optional<Paths> restOf(const Paths& open, double hatchMm, double narrowestMm) {
  const auto isLong = [&](const Paths& gap) {
    return areaMm2(gap) > kShortestGap * hatchMm * 0.5 * narrowestMm;
  };
  const auto opened = [&](const Paths& area, double hatches) {
    return moved(moved(area, -hatches, hatchMm), hatches, hatchMm);
  };
  const double half = 0.5 * narrowestMm / hatchMm;
  const Paths gaps =
      combined(opened(open, kNarrowest), opened(open, half), ClipperLib::ctDifference);
  if (std::ranges::any_of(connectedParts(gaps), isLong))
    return std::nullopt;
  Paths rest;
  for (Paths& part : connectedParts(opened(open, std::min(kTail, half)))) {
    const double wideMm2 = areaMm2(opened(part, kTwoBeads));
    if (isLong(part) && wideMm2 < kWideShare * areaMm2(part))
      return std::nullopt;
    if (wideMm2 <= 0.0) {
      if (areaMm2(part) > kLargestDash * hatchMm * hatchMm)
        return std::nullopt;
      continue;
    }
    ClipperLib::CleanPolygons(part, kArc * hatchMm * geometry::kPathUnits);
    rest.insert(rest.end(), part.begin(), part.end());
  }
  return rest;
}
} // namespace

std::optional<PlaneWalls> planeWalls(const layers::Patch& patch, const process::Process& process,
                                     const ToolpathOptions& o,
                                     const std::vector<double>& wallWidthMm) {
  if (o.walls == 0 || patch.group == layers::kSupportGroup || !isUsual(wallWidthMm, process))
    return std::nullopt;
  const std::optional<PlanePatch> plane = planePatch(patch);
  if (!plane || !plane->isEven || plane->outline.empty())
    return std::nullopt;
  const double height = std::min(plane->thicknessMm, process.beadWidthMm);
  const double hatch = process::hatchOf(process.beadWidthMm, height);
  // No bead is narrower than high.
  const double narrowest = process::hatchOf(std::max(process.beadWidthMinMm, height), height);
  const Paths solid = geometry::united(plane->contours());
  std::vector<Paths> walls;
  Paths bands;
  for (int i = 0; i < o.walls; ++i) {
    Paths region = wallRegion(plane->outline, i + 0.5, hatch);
    for (const ClipperLib::Path& ring : region)
      if (lengthMm({ring}) < kSmallestRing * hatch)
        return std::nullopt;
    if (isTight(region, hatch))
      return std::nullopt;
    const Paths band =
        combined(moved(region, 0.5, hatch), moved(region, -0.5, hatch), ClipperLib::ctDifference);
    bands = combined(bands, band, ClipperLib::ctUnion);
    walls.push_back(std::move(region));
  }
  if (walls.front().empty())
    return std::nullopt;
  const auto rest = restOf(combined(solid, bands, ClipperLib::ctDifference), hatch, narrowest);
  if (!rest)
    return std::nullopt;
  PlaneWalls made;
  if (!rest->empty()) {
    // Wholly inside the walls, and so all of its rim is a seam.
    PlanePatch inside = *plane;
    inside.outline.clear();
    made.rest = patchOver(*rest, inside, patch);
    if (!made.rest)
      return std::nullopt;
  }
  double lengths = 0.0;
  for (const Paths& wall : walls)
    lengths += lengthMm(wall);
  made.bandMm2 = areaMm2(solid) - areaMm2(*rest);
  // Wider or narrower walls fill what corners leave open; not a place for a bead of its own.
  const double share = made.bandMm2 / (lengths * hatch);
  if (std::abs(share - 1.0) > kCorrection)
    return std::nullopt;
  const double width = std::max(height, std::clamp(process::widthOfHatch(share * hatch, height),
                                                   process.beadWidthMinMm, process.beadWidthMaxMm));
  const ResampleOptions spacing = ResampleOptions().scaled(largeBeadScaleOf(process));
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (const ClipperLib::Path& ring : walls[i]) {
      PlaneLine line{{}, true};
      for (const ClipperLib::IntPoint& p : ring)
        line.points.push_back(geometry::pointMm(p));
      Bead bead;
      bead.kind = plan::PathKind::Wall;
      bead.ring = static_cast<int>(i);
      bead.closed = true;
      for (const Eigen::Vector2d& p : spacedPoints(line, spacing.chordMm, o.stepMm).points)
        bead.points.push_back(
            {plane->place(p), plane->direction, plane->clearDirection, width, plane->thicknessMm});
      bead.points.push_back(bead.points.front());
      made.beads.push_back(std::move(bead));
    }
  return made;
}

} // namespace voluta::toolpath
