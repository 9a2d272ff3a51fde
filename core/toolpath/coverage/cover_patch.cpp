#include "toolpath/coverage/cover_patch.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/boundary.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/coverage/bead_volume.h"
#include "toolpath/coverage/bend_middle.h"
#include "toolpath/coverage/coverage.h"
#include "toolpath/coverage/plane_walls.h"
#include "toolpath/coverage/refined_patch.h"
#include "toolpath/coverage/smooth_values.h"
#include "toolpath/coverage/strand_room.h"
#include "toolpath/coverage/uniform_interior.h"
#include "toolpath/coverage/voronoi_shares.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/infill/gap_fill.h"
#include "toolpath/infill/infill.h"
#include "toolpath/infill/outer_walls.h"
#include "toolpath/infill/thin_rings.h"
#include "toolpath/infill/walls.h"
#include "toolpath/surface_fields.h"
#include "toolpath/unsupported/bead_tip.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

// Maximum distance [mm] from a centreline at which material is assigned to it; for beads of 1.2 mm
// (bead_scale.h).
constexpr double kReach = 1.8;
// Point spacing [mm] while centrelines move, for beads of up to 1.2 mm
constexpr double kPlanStep = 0.5;
// Lines that close the gaps between them move farther.
constexpr int kRelaxations = 2, kClosingRelaxations = 3;
// Resampling step [mm], for beads of 1.2 mm. With kArcPasses, right angles become arcs of radius
// about 0.4 mm.
constexpr double kArcStep = 0.2;
constexpr int kArcPasses = 4;
// Maximum area [mm2] per surface sample, for beads of 1.2 mm: while centrelines move, for their
// sections, and for the sections of wound infill. Its lines are so regular that coarser samples
// would beat with them.
constexpr double kMoveMm2 = 0.12, kSectionMm2 = 0.03, kWoundMm2 = 0.012;
// The same on a plane: while centrelines move, and for sections; finer on a patch that needs fewer
// samples than kPlaneEnough.
constexpr double kPlaneMoveMm2 = 0.05, kPlaneSectionMm2 = 0.016, kPlaneFinestMm2 = 0.008;
constexpr double kPlaneEnough = 16000.0;
// Distance [hatches] beyond the depth where lines become even; deeper vertices are never nearest to
// other curves.
constexpr double kNearEven = 1.2;
// Beads side by side in a ring that needs no infill, whatever the number of walls.
constexpr int kMostRings = 4;
// [hatches]: gaps in the corners of such rings are shorter.
constexpr double kCornerGap = 4.0;
// [hatches of the widest bead]: half the width of a wall that one bead fills; a little more for the
// rounding of distances.
constexpr double kOneBead = 0.52;

struct Centrelines {
  std::vector<SurfaceCurve> curves;
  std::vector<PathKind> kind;
  std::vector<int> ring;
  // Per vertex: half of the additional width of the outermost wall there; empty: no additional
  // width.
  std::vector<double> extraMm;
  std::vector<double> depth;            // Per vertex: distance from the boundary [hatches]
  std::vector<double> uniformSpacingMm; // InfillLines::uniformSpacingMm
  std::vector<char> isClosed;           // InfillLines::isClosed
  bool lacksField = false;              // InfillLines::lacksField

  std::vector<ThinWall> thinWalls;

  bool isOuterWall(std::size_t k) const { return kind[k] == PathKind::Wall && ring[k] == 0; }

  void add(std::vector<SurfaceCurve>&& more, PathKind k, int r) {
    for (SurfaceCurve& c : more) {
      if (c.points.size() < 2)
        continue;
      curves.push_back(std::move(c));
      kind.push_back(k);
      ring.push_back(r);
    }
  }

  // From the outer boundary to the inner one. One alone is the middle of a gap between both.
  void addRings(std::vector<SurfaceCurve>&& rings) {
    const std::size_t n = rings.size();
    if (n == 1)
      extraMm.clear();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t depth = std::min(k, n - 1 - k);
      const bool isMiddle = 2 * k + 1 == n;
      add({std::move(rings[k])}, isMiddle ? PathKind::GapFill : PathKind::Wall,
          isMiddle ? 0 : static_cast<int>(depth));
    }
  }

  // Returns the `extraMm` argument of assignToNearestCurve().
  std::vector<std::vector<double>> extras(const PatchSurface& s) const {
    if (extraMm.empty())
      return {};
    std::vector<std::vector<double>> all(curves.size());
    for (std::size_t k = 0; k < curves.size(); ++k)
      if (isOuterWall(k))
        for (const SurfacePoint& p : curves[k].points)
          all[k].push_back(s.interpolate(extraMm, p));
    return all;
  }
};

// Reduces the extra width where a wide bead was assigned more than `maxHatchMm`, the hatch of the
// widest bead, so that its neighbours get the rest. Returns whether any was reduced.
bool lessenExtras(const std::vector<SurfaceCurve>& curves, const VoronoiShares& cells,
                  double maxHatchMm, std::vector<std::vector<double>>& extras) {
  bool any = false;
  for (std::size_t k = 0; k < extras.size(); ++k) {
    std::vector<double>& extra = extras[k];
    const auto& points = curves[k].points;
    const std::vector<double>& area = cells.share[k].areaMm2;
    const auto length = [&](std::size_t i) {
      return (points[(i + 1) % points.size()].position - points[i].position).norm();
    };
    for (std::size_t i = 0; i < extra.size(); ++i) {
      const std::size_t before = (i + area.size() - 1) % area.size(), after = i % area.size();
      const double hatch =
          (area[before] + area[after]) / std::max(1e-9, length(before) + length(after));
      if (extra[i] <= 0.0 || hatch <= maxHatchMm)
        continue;
      // The boundary between two shares moves by half of the change of extra.
      extra[i] = std::max(0.0, extra[i] - 2.0 * (hatch - maxHatchMm));
      any = true;
    }
  }
  return any;
}

// Returns per vertex the distance to the nearest footprint of the lines.
std::vector<double> outsideFootprints(const PatchSurface& s, const Centrelines& lines,
                                      const std::vector<double>& hatchMm, double beadScale) {
  std::vector<SurfaceCurve> usual, wide;
  for (std::size_t k = 0; k < lines.curves.size(); ++k)
    (lines.isOuterWall(k) && !lines.extraMm.empty() ? wide : usual).push_back(lines.curves[k]);
  std::vector<SourceSegment> segments = segmentsOf(s, usual);
  std::vector<char> onwards;
  if (!lines.uniformSpacingMm.empty()) {
    // There are no gaps between even lines, and the lines far inside are not nearest to any vertex
    // outside.
    const double far = evenFrom(lines.uniformSpacingMm, lines.depth) + kNearEven;
    onwards.resize(s.position.size());
    for (std::size_t v = 0; v < onwards.size(); ++v)
      onwards[v] = lines.uniformSpacingMm[v] == 0.0 || lines.depth[v] < far;
    std::erase_if(segments, [&](const SourceSegment& segment) {
      return std::ranges::none_of(s.triangles[static_cast<std::size_t>(segment.triangle)],
                                  [&](int v) { return onwards[static_cast<std::size_t>(v)]; });
    });
  }
  std::vector<double> outside = distanceToSegments(s, segments, kGapReachMm * beadScale, onwards);
  for (std::size_t v = 0; v < outside.size(); ++v)
    outside[v] = (onwards.empty() || onwards[v] ? outside[v] : 0.0) - 0.5 * hatchMm[v];
  if (wide.empty())
    return outside;
  const std::vector<double> toWide =
      distanceToSegments(s, segmentsOf(s, wide), kGapReachMm * beadScale);
  for (std::size_t v = 0; v < outside.size(); ++v)
    outside[v] = std::min(outside[v], toWide[v] - 0.5 * hatchMm[v] - lines.extraMm[v]);
  return outside;
}

// Returns gapSpines()' outsideMm: no gap where the infill closes them.
std::vector<double> outsideOf(const PatchSurface& s, const Centrelines& lines,
                              const std::vector<double>& hatchMm, double beadScale) {
  std::vector<double> outside = outsideFootprints(s, lines, hatchMm, beadScale);
  for (std::size_t v = 0; v < lines.isClosed.size(); ++v)
    if (lines.isClosed[v])
      outside[v] = -hatchMm[v];
  return outside;
}

bool oneLoop(const PatchSurface& s) {
  if (s.boundary.empty())
    return false;
  std::vector<int> next(s.position.size(), -1);
  for (const auto& e : s.boundary)
    next[static_cast<std::size_t>(e[0])] = e[1];
  std::size_t steps = 0;
  int v = s.boundary.front()[0];
  do {
    v = next[static_cast<std::size_t>(v)];
    ++steps;
  } while (v >= 0 && v != s.boundary.front()[0] && steps <= s.boundary.size());
  return v >= 0 && steps == s.boundary.size();
}

// Replaces the values up to `reachMm` from the ends of an open curve by the value there; 0 if the
// curve is shorter than twice that. Beside its ends a bead's share is that of a junction, not that
// of a wall, and its middle is off the wall's.
void levelEnds(const SurfaceCurve& c, double reachMm, std::vector<double>& perSegment) {
  const std::size_t n = perSegment.size();
  const auto within = [&](bool fromBack) {
    double length = 0.0;
    std::size_t k = 0;
    for (; k < n && length < reachMm; ++k) {
      const std::size_t i = fromBack ? n - 1 - k : k;
      length += (c.points[i + 1].position - c.points[i].position).norm();
    }
    return k;
  };
  const std::size_t front = within(false), back = within(true);
  if (front + back >= n) {
    std::ranges::fill(perSegment, 0.0);
    return;
  }
  std::fill_n(perSegment.begin(), front, perSegment[front]);
  std::fill_n(perSegment.rbegin(), back, perSegment[n - 1 - back]);
}

// Moves a centreline across by `shift`, per segment, to the middle of its share, and extends its
// open ends into the area beyond them. `room`: of strandRoom(), so that no two parts cross; empty:
// not limited by it.
void moveToMiddle(const PatchSurface& s, SurfaceCurve& c, const CellShare& share,
                  std::vector<double> shift, double hatch, bool isSpine,
                  const std::vector<double>& room) {
  constexpr double kOfRoom = 0.45;
  const std::size_t n = c.points.size();
  if (isSpine && !c.closed)
    levelEnds(c, hatch, shift);
  smoothValues(shift, c.closed, 4);
  const std::size_t segments = shift.size();
  const SurfaceCurve old = c;
  const auto along = [&](std::size_t i) -> Vector3d {
    return (old.points[(i + 1) % n].position - old.points[i].position).normalized();
  };
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = !c.closed && i == 0, last = !c.closed && i + 1 == n;
    const std::size_t before = first ? 0 : (i + segments - 1) % segments;
    const std::size_t after = last ? segments - 1 : i % segments;
    if (!first && !last && shift[before] == 0.0 && shift[after] == 0.0)
      continue;
    const Vector3d tangent = along(before) + along(after);
    const Vector3d normal = s.interpolate(s.normal, old.points[i]);
    Vector3d left = normal.cross(tangent);
    if (left.norm() < 1e-6)
      continue;
    Vector3d move = 0.5 * (shift[before] + shift[after]) * left.normalized();
    const double maximum = room.empty() ? 0.4 * hatch : std::min(0.4 * hatch, kOfRoom * room[i]);
    if (move.norm() > maximum)
      move *= maximum / move.norm();
    if (first)
      move -= std::min(0.6 * hatch, share.beyondMm2[0] / hatch) * along(0);
    if (last)
      move += std::min(0.6 * hatch, share.beyondMm2[1] / hatch) * along(segments - 1);
    c.points[i] = s.project(old.points[i].position + move, old.points[i].triangle);
  }
}

// Converts the volume of each segment's share to the bead width at each point.
class Sections {
public:
  Sections(const PatchSurface& s, const process::Process& p) : s_(s), p_(p) {}

  // Returns the bead along a curve, without its widths.
  Bead along(const SurfaceCurve& c, PathKind kind, int ring) const {
    Bead b;
    b.kind = kind;
    b.ring = ring;
    b.closed = c.closed;
    for (const SurfacePoint& p : c.points)
      b.points.push_back({p.position, s_.interpolate(s_.direction, p),
                          s_.interpolate(s_.clearDirection, p), 0.0,
                          s_.interpolate(s_.thicknessMm, p)});
    if (c.closed)
      b.points.push_back(b.points.front());
    return b;
  }

  // Sets the widths that deposit `volume` (one value per segment).
  void widen(Bead& b, std::vector<double> volume) const {
    const std::size_t segments = volume.size(), n = segments + (b.closed ? 0 : 1);
    // Material is deposited along the path of the tip, which is longer than the centreline on a
    // convex layer.
    std::vector<double> length(segments);
    for (std::size_t i = 0; i < segments; ++i)
      length[i] = (tipOf(b.points[i + 1]) - tipOf(b.points[i])).norm();
    smoothValues(volume, b.closed, 2);
    smoothValues(length, b.closed, 2);
    for (std::size_t i = 0; i < n; ++i) {
      const bool first = !b.closed && i == 0, last = !b.closed && i + 1 == n;
      const std::size_t before = first ? 0 : (i + segments - 1) % segments;
      const std::size_t after = last ? segments - 1 : i % segments;
      BeadPoint& q = b.points[i];
      const double l = length[before] + length[after];
      const double section = l > 0 ? (volume[before] + volume[after]) / l : 0.0;
      q.widthMm = within(process::widthOfArea(section, q.heightMm), q.heightMm);
    }
    if (b.closed)
      b.points.back().widthMm = b.points.front().widthMm;
  }
  double within(double width, double height) const {
    return std::max(std::clamp(width, p_.beadWidthMinMm, p_.beadWidthMaxMm), height);
  }

private:
  const PatchSurface& s_;
  const process::Process& p_;
};

Centrelines centrelines(const PatchSurface& s, const process::Process& process,
                        const ToolpathOptions& o, const InfillKind& kind, int layer,
                        const std::vector<double>& wallWidthMm, std::optional<double> directionRad,
                        const base::RunContext& ctx) {
  const std::size_t n = s.position.size();
  const double beadScale = beadScaleOf(process);
  const SegmentDistances boundary = nearestSegments(s, boundarySegments(s), 1e9);
  const std::vector<double>& boundaryMm = boundary.mm;
  std::vector<double> hatchMm(n), depth(n);
  for (std::size_t v = 0; v < n; ++v) {
    hatchMm[v] =
        process::hatchOf(process.beadWidthMm, std::min(s.thicknessMm[v], process.beadWidthMm));
  }
  const std::vector<double> outerMm = o.walls > 0 && !kind.needsChart
                                          ? outerHatches(s, wallWidthMm, boundary, hatchMm, process)
                                          : hatchMm;
  Centrelines lines;
  if (outerMm != hatchMm)
    for (std::size_t v = 0; v < n; ++v)
      lines.extraMm.push_back(0.5 * (outerMm[v] - hatchMm[v]));
  // Distance from the part's surface in hatches. The outermost hatch may be wider than the others.
  const auto inHatches = [&](double mm, std::size_t v) {
    return mm <= outerMm[v] ? mm / outerMm[v] : 1.0 + (mm - outerMm[v]) / hatchMm[v];
  };
  const BoundaryParts parts = boundaryParts(s);
  if (!parts.seams.empty()) {
    const std::vector<double> surfaceMm = distanceToSegments(s, parts.surface, 1e9),
                              seamMm = distanceToSegments(s, parts.seams, 1e9);
    for (std::size_t v = 0; v < n; ++v)
      depth[v] = std::min(inHatches(surfaceMm[v], v), o.walls + seamMm[v] / hatchMm[v]);
  } else {
    for (std::size_t v = 0; v < n; ++v)
      depth[v] = inHatches(boundaryMm[v], v);
  }
  const auto hatchFor = [&](double width) {
    return process::hatchOf(width, process.layerHeightMm);
  };
  const double narrowest = hatchFor(process.beadWidthMinMm), usual = hatchFor(process.beadWidthMm),
               widest = hatchFor(process.beadWidthMaxMm);
  std::vector<SurfaceCurve> rings;
  if (o.walls > 0 && !kind.needsChart)
    rings = thinRings(s, process, lines.extraMm.empty() ? kMostRings : 1);
  const bool isThinRing = !rings.empty();
  if (isThinRing)
    lines.addRings(std::move(rings));
  for (int i = 0; i < o.walls && !isThinRing; ++i) {
    std::vector<SurfaceCurve> walls =
        wallAt(s, depth, i == 0 ? outerMm : hatchMm, beadScale, i + 0.5);
    if (i == 0) {
      dropDashes(s, depth, kOneBead * widest / usual, walls);
      dropJunctionRings(s, depth, usual, walls);
    }
    lines.add(std::move(walls), PathKind::Wall, i);
  }
  ctx.checkpoint();
  const InfillRegion region{s,
                            depth,
                            hatchMm,
                            static_cast<double>(o.walls),
                            layer,
                            directionRad.value_or(base::degreesToRadians(std::remainder(
                                o.infillAngleDeg + layer * o.infillRotationDeg, 180.0))),
                            base::degreesToRadians(o.windingAngleDeg),
                            beadScale,
                            &o.strands};
  InfillLines infill;
  if (!isThinRing)
    infill = kind.fill(region, ctx);
  lines.add(std::move(infill.curves), PathKind::Infill, 0);
  ctx.checkpoint();
  lines.depth = depth;
  lines.uniformSpacingMm = std::move(infill.uniformSpacingMm);
  lines.isClosed = std::move(infill.isClosed);
  lines.lacksField = infill.lacksField;
  std::vector<SurfaceCurve> spines = gapSpines(s, outsideOf(s, lines, hatchMm, beadScale),
                                               boundaryMm, hatchMm, beadScale, narrowest / usual);
  if (isThinRing) // The corners of a ring are its beads' own.
    std::erase_if(spines, [&](const SurfaceCurve& c) { return lengthOf(c) < kCornerGap * usual; });
  std::erase_if(spines, [&](const SurfaceCurve& spine) {
    const auto thin = thinWallAlong(s, spine, boundaryMm, narrowest);
    if (thin)
      lines.thinWalls.push_back(*thin);
    return thin && o.thinWalls == "omit";
  });
  lines.add(std::move(spines), PathKind::GapFill, 0);
  ctx.checkpoint();
  return lines;
}
// Returns the area of the patch inside beads, in the mean over a layer's height: the round sides of
// beads leave more open between them than their full widths.
double filledMm2(const PatchSurface& s, const std::vector<Bead>& beads) {
  constexpr std::array kHeights{0.1, 0.3, 0.5, 0.7,
                                0.9}; // from a bead's middle, by half its height
  double sum = 0.0;
  for (const double height : kHeights) {
    std::vector<Bead> sliced = beads;
    for (Bead& bead : sliced)
      for (BeadPoint& point : bead.points)
        point.widthMm -= point.heightMm * (1.0 - std::sqrt(1.0 - height * height));
    sum += measureCoverage(s, sliced).coveredMm2;
  }
  return sum / static_cast<double>(kHeights.size());
}

// Moves centrelines to the middle of their shares and gives them the width of their beads.
// `byExtent`: rings move to the middle of the extents of their shares (bend_middle.h). Sets the
// beads, their volume and what they cover.
PatchCover beadsAlong(const PatchSurface& s, Centrelines lines, const process::Process& process,
                      const ToolpathOptions& o, const InfillKind& kind, bool byExtent,
                      const base::RunContext& ctx) {
  PatchCover cover;
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  const double beadScale = beadScaleOf(process);
  const auto planeSamples = [&](double maxMm2, const std::vector<char>& leftOut = {}) {
    const double fine = kPlaneFinestMm2 * beadScale * beadScale;
    return kind.needsChart
               ? std::nullopt
               : PlaneSamples::of(
                     s, std::clamp(s.areaMm2 / kPlaneEnough, fine, maxMm2 * beadScale * beadScale),
                     leftOut);
  };
  const double largeBeads = largeBeadScaleOf(process);
  const UniformInterior even(s, lines.uniformSpacingMm, lines.depth, hatch,
                             std::max(kPlanStep * largeBeads, o.stepMm));
  // Samples of one density. The grid is made only when the patch is not plane.
  struct Samples {
    std::optional<PlaneSamples> plane;
    double maxMm2;
    std::optional<SampleGrid> grid = {};
  };
  const auto computeShares = [&](Samples& of, const UniformStretches& stretches,
                                 const std::vector<std::vector<double>>& extras) {
    if (of.plane)
      return assignToNearestCurve(*of.plane, lines.curves, kReach * beadScale, extras, stretches);
    if (!of.grid)
      of.grid.emplace(s, of.maxMm2 * beadScale * beadScale);
    return assignToNearestCurve(*of.grid, lines.curves, kReach * beadScale, extras);
  };
  Samples coarse{planeSamples(kPlaneMoveMm2), kMoveMm2};
  ResampleOptions dense = ResampleOptions().scaled(largeBeads);
  dense.stepMm = kPlanStep * largeBeads;
  dense.chordMm = INFINITY;
  for (SurfaceCurve& c : lines.curves) {
    Resampled r = resample(s, c, dense);
    smoothCurve(s, r.curve, r.corner, 2);
    c = std::move(r.curve);
  }
  const auto shiftOf = [&](std::size_t k, const CellShare& share) {
    return byExtent && lines.curves[k].closed ? middleOfExtents(s, lines.curves[k], share)
                                              : share.lateralMm;
  };
  const int relaxations = lines.isClosed.empty() ? kRelaxations : kClosingRelaxations;
  for (int i = 0; i < relaxations; ++i) {
    ctx.checkpoint();
    const VoronoiShares cells = computeShares(coarse, even.of(lines.curves), lines.extras(s));
    const auto room = lines.isClosed.empty() ? std::vector<std::vector<double>>(lines.curves.size())
                                             : strandRoom(lines.curves, hatch);
    for (std::size_t k = 0; k < lines.curves.size(); ++k)
      if (!kind.needsChart || lines.kind[k] != PathKind::Infill)
        moveToMiddle(s, lines.curves[k], cells.share[k], shiftOf(k, cells.share[k]), hatch,
                     lines.kind[k] == PathKind::GapFill, room[k]);
  }
  // Round the corners: straight beads that meet at an angle leave a gap at the outside of the
  // corner.
  ResampleOptions fine = dense, final = ResampleOptions().scaled(largeBeads);
  fine.stepMm = kArcStep * beadScale;
  final.stepMm = o.stepMm;
  for (SurfaceCurve& c : lines.curves) {
    Resampled r = resample(s, c, fine);
    smoothCurve(s, r.curve, std::vector<char>(r.corner.size(), 0), kArcPasses);
    c = resample(s, r.curve, final).curve;
  }
  ctx.checkpoint();
  Samples fineSamples{planeSamples(kPlaneSectionMm2, even.triangles()),
                      kind.needsChart ? kWoundMm2 : kSectionMm2};
  std::vector<std::vector<double>> extras = lines.extras(s);
  const UniformStretches stretches = even.of(lines.curves);
  VoronoiShares cells = computeShares(fineSamples, stretches, extras);
  if (lessenExtras(lines.curves, cells, process.beadWidthMaxMm - process.beadWidthMm + hatch,
                   extras))
    cells = computeShares(fineSamples, stretches, extras);
  const Sections sections(s, process);
  double target = 0.0;
  for (CellShare& share : cells.share)
    for (const double v : share.volumeMm3)
      target += v;
  for (std::size_t k = 0; k < lines.curves.size(); ++k)
    cover.beads.push_back(sections.along(lines.curves[k], lines.kind[k], lines.ring[k]));
  // Widths are set at points and interpolated between them. Scale all widths to correct the
  // resulting volume error.
  double correction = 1.0;
  for (int round = 0; round < 3; ++round) {
    for (std::size_t k = 0; k < lines.curves.size(); ++k) {
      std::vector<double> volume = cells.share[k].volumeMm3;
      for (double& v : volume)
        v *= correction;
      sections.widen(cover.beads[k], std::move(volume));
    }
    cover.beadVolumeMm3 = volumeOf(cover.beads);
    if (cover.beadVolumeMm3 <= 0)
      break;
    correction = std::clamp(correction * target / cover.beadVolumeMm3, 0.97, 1.03);
  }
  const Coverage c =
      coarse.plane ? measureCoverage(*coarse.plane, cover.beads) : measureCoverage(s, cover.beads);
  cover.coveredMm2 = c.coveredMm2;
  cover.overlapMm2 = c.overlapMm2;
  return cover;
}

PatchCover coverSurface(const layers::Patch& patch, const process::Process& process,
                        const ToolpathOptions& o, const InfillKind& kind,
                        const std::vector<double>& wallWidthMm, std::optional<double> directionRad,
                        const base::RunContext& ctx) {
  PatchCover cover;
  const PatchSurface s = refinedPatch(patch, process, o, kind.isStraightInside);
  const Centrelines lines =
      centrelines(s, process, o, kind, patch.layer, wallWidthMm, directionRad, ctx);
  if (!lines.curves.empty()) {
    cover = beadsAlong(s, lines, process, o, kind, false, ctx);
    // A ring that has a patch without holes for itself, as in a pin
    if (lines.curves.size() == 1 && lines.curves.front().closed && oneLoop(s)) {
      PatchCover other = beadsAlong(s, lines, process, o, kind, true, ctx);
      if (filledMm2(s, other.beads) > filledMm2(s, cover.beads))
        cover = std::move(other);
    }
  }
  cover.areaMm2 = s.areaMm2;
  cover.volumeMm3 = s.volumeMm3;
  cover.simple = oneLoop(s);
  cover.thinWalls = lines.thinWalls;
  cover.lacksField = lines.lacksField;
  return cover;
}

// Adds the walls around a cover of the area inside them.
void addWalls(PlaneWalls walls, bool isOneLoop, PatchCover& inside) {
  const double height = walls.beads.front().points.front().heightMm;
  inside.areaMm2 += walls.bandMm2;
  inside.coveredMm2 += walls.bandMm2;
  inside.volumeMm3 += height * walls.bandMm2;
  inside.beadVolumeMm3 += volumeOf(walls.beads);
  inside.simple = isOneLoop;
  inside.beads.insert(inside.beads.begin(), std::make_move_iterator(walls.beads.begin()),
                      std::make_move_iterator(walls.beads.end()));
}
} // namespace

PatchCover coverPatch(const layers::Patch& patch, const process::Process& process,
                      const ToolpathOptions& o, const base::RunContext& ctx,
                      const std::vector<double>& wallWidthMm, std::optional<double> directionRad) {
  base::require(o.walls >= 0 && o.stepMm > 0, "walls and step are not negative");
  const InfillKind& kind = infillKind(o.infill);
  if (kind.needsChart && patch.chart.empty())
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("infill '{infill}' needs an axis to wind around, but layer {layer} "
                      "has none"_text,
                      o.infill, patch.layer),
        "infill"_name, "use infill zigzag or concentric, or mode lathe"_text);
  if (patch.surface.empty())
    return {};
  auto walls = planeWalls(patch, process, o, wallWidthMm);
  if (!walls)
    return coverSurface(patch, process, o, kind, wallWidthMm, directionRad, ctx);
  PatchCover cover;
  if (walls->rest) {
    ToolpathOptions inside = o;
    inside.walls = 0;
    cover = coverSurface(*walls->rest, process, inside, kind, {}, directionRad, ctx);
  }
  addWalls(std::move(*walls), geometry::boundaryLoops(patch.surface).size() == 1, cover);
  return cover;
}

} // namespace voluta::toolpath
