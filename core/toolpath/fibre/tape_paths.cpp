#include "toolpath/fibre/tape_paths.h"

#include "base/error.h"
#include "geometry/polyline.h"
#include "toolpath/coverage/segment_grid.h"
#include "toolpath/fibre/tape_cover.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kFineStepMm = 0.5; // of centrelines while they are clipped
// Share of the tape's width by which it may leave the patch, and of the least radius by which a
// bend may be narrower: the error of isolines and of curved boundaries with facets.
constexpr double kOutside = 0.02, kNarrower = 0.05;
// Tapes that meet are kept apart by their width less this share of it.
constexpr double kCloser = 0.02;
// Passes that remove the noise of isolines
constexpr int kSmoothing = 24;

using Points = std::vector<SurfacePoint>;

// Returns the points of a piece without the length `cutMm` at its front.
Points withoutFront(const PatchSurface& s, Points points, double cutMm) {
  const auto place =
      geometry::placeAfter(cutMm, points.size(), [&](std::size_t i) { return points[i].position; });
  if (!place)
    return {};
  SurfacePoint& first = points[place->segment];
  const Vector3d step = points[place->segment + 1].position - first.position;
  first = s.project(first.position + place->share * step, first.triangle);
  points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(place->segment));
  return points;
}

class Clipper {
public:
  Clipper(const PatchSurface& s, const process::Tape& tape, const TapeChoice& choice)
      : s_(s), tape_(tape), insideMm_((0.5 - kOutside) * tape.widthMm),
        endCutMm_(std::max(choice.endMm, 0.5 * tape.widthMm) - insideMm_),
        boundary_(segmentsOfBoundary(s), 0.5 * tape.widthMm) {}

  // Returns the usable pieces of a centreline; adds to the lengths left out.
  std::vector<SurfaceCurve> clip(const SurfaceCurve& line, TapePaths& out) const {
    std::vector<SurfaceCurve> pieces;
    for (const SurfaceCurve& inside : insideOf(line))
      for (SurfaceCurve& piece : unbent(inside, out.bentMm)) {
        if (!piece.closed) {
          piece.points = withoutFront(s_, std::move(piece.points), endCutMm_);
          std::ranges::reverse(piece.points);
          piece.points = withoutFront(s_, std::move(piece.points), endCutMm_);
          std::ranges::reverse(piece.points);
        }
        if (piece.points.size() < 2)
          continue;
        const double length = lengthOf(piece);
        if (length >= tape_.minLengthMm)
          pieces.push_back(std::move(piece));
        else
          out.shortMm += length;
      }
    return pieces;
  }

private:
  static std::vector<SegmentGrid::Segment> segmentsOfBoundary(const PatchSurface& s) {
    std::vector<SegmentGrid::Segment> segments;
    for (const SourceSegment& side : boundarySegments(s))
      segments.push_back({side.a, side.b});
    return segments;
  }

  bool isInside(const SurfacePoint& p) const {
    const SegmentGrid::Hit hit = boundary_.nearest(p.position);
    return hit.segment < 0 || hit.distanceMm >= insideMm_;
  }

  // Returns the last point inside between one that is and one that is not.
  SurfacePoint lastInside(SurfacePoint in, SurfacePoint out) const {
    constexpr int kHalvings = 12;
    for (int i = 0; i < kHalvings; ++i) {
      const SurfacePoint middle = s_.project(0.5 * (in.position + out.position), in.triangle);
      (isInside(middle) ? in : out) = middle;
    }
    return in;
  }

  // Returns the pieces that are inside by half a width; closed if all of a closed line is.
  std::vector<SurfaceCurve> insideOf(const SurfaceCurve& line) const {
    constexpr double kAnyMm = 1e9;
    if (line.points.size() < 2 || lengthOf(line) < kFineStepMm)
      return {};
    SurfaceCurve fine = resample(s_, line, {.stepMm = kFineStepMm, .chordMm = kAnyMm}).curve;
    std::vector<char> inside;
    for (const SurfacePoint& p : fine.points)
      inside.push_back(isInside(p) ? 1 : 0);
    if (std::ranges::count(inside, 0) == 0)
      return {fine};
    if (fine.closed) { // begins outside
      const auto first = std::ranges::find(inside, 0) - inside.begin();
      std::ranges::rotate(fine.points, fine.points.begin() + first);
      std::ranges::rotate(inside, inside.begin() + first);
      fine.points.push_back(fine.points.front());
      inside.push_back(0);
    }
    std::vector<SurfaceCurve> pieces;
    for (std::size_t i = 0; i < inside.size(); ++i) {
      if (!inside[i])
        continue;
      if (i == 0 || !inside[i - 1]) {
        pieces.push_back({});
        if (i > 0)
          pieces.back().points.push_back(lastInside(fine.points[i], fine.points[i - 1]));
      }
      pieces.back().points.push_back(fine.points[i]);
      if (i + 1 < inside.size() && !inside[i + 1])
        pieces.back().points.push_back(lastInside(fine.points[i], fine.points[i + 1]));
    }
    return pieces;
  }

  // Returns the parts of a piece that bend no more than the tape can.
  std::vector<SurfaceCurve> unbent(SurfaceCurve piece, double& bentMm) const {
    if (piece.points.size() < 3)
      return {std::move(piece)};
    smoothCurve(s_, piece, std::vector<char>(piece.points.size(), 0), kSmoothing);
    const std::vector<char> bends = bendsOf(piece);
    if (std::ranges::count(bends, 1) == 0)
      return {std::move(piece)};
    if (piece.closed) {
      const auto first = std::ranges::find(bends, 1) - bends.begin();
      std::ranges::rotate(piece.points, piece.points.begin() + first);
      piece.points.push_back(piece.points.front());
      piece.closed = false;
      return unbentParts(piece, bendsRotated(bends, first), bentMm);
    }
    return unbentParts(piece, bends, bentMm);
  }
  static std::vector<char> bendsRotated(std::vector<char> bends, std::ptrdiff_t first) {
    std::ranges::rotate(bends, bends.begin() + first);
    bends.push_back(bends.front());
    return bends;
  }
  static std::vector<SurfaceCurve> unbentParts(const SurfaceCurve& piece,
                                               const std::vector<char>& bends, double& bentMm) {
    std::vector<SurfaceCurve> parts;
    for (std::size_t i = 0; i < bends.size(); ++i) {
      if (i > 0 && (bends[i] || bends[i - 1]))
        bentMm += (piece.points[i].position - piece.points[i - 1].position).norm();
      if (bends[i])
        continue;
      if (i == 0 || bends[i - 1])
        parts.push_back({});
      parts.back().points.push_back(piece.points[i]);
    }
    return parts;
  }

  // Returns per point whether the tape bends too much there, measured over half a width both ways.
  std::vector<char> bendsOf(const SurfaceCurve& piece) const {
    const auto& p = piece.points;
    const std::size_t n = p.size();
    const double step = lengthOf(piece) / static_cast<double>(piece.closed ? n : n - 1);
    const auto reach =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(0.5 * tape_.widthMm / step)));
    std::vector<char> bends(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      if (!piece.closed && (i < reach || i + reach >= n))
        continue;
      const double radius =
          bendRadius(p[(i + n - reach % n) % n].position, p[i].position,
                     p[(i + reach) % n].position, s_.interpolate(s_.normal, p[i]));
      bends[i] = radius < (1.0 - kNarrower) * tape_.minBendRadiusMm ? 1 : 0;
    }
    return bends;
  }

  const PatchSurface& s_;
  const process::Tape& tape_;
  double insideMm_, endCutMm_;
  SegmentGrid boundary_;
};

// A family as tapes.
struct ClippedFamily {
  TapePaths tapes;
  std::vector<double> offsetMm; // per path
  double lengthMm = 0.0;
};

ClippedFamily clipped(const Clipper& clipper, const TapeFamily& family) {
  ClippedFamily out;
  for (const TapeLine& line : family)
    for (SurfaceCurve& piece : clipper.clip(line.curve, out.tapes)) {
      out.lengthMm += lengthOf(piece);
      out.tapes.paths.push_back(std::move(piece));
      out.offsetMm.push_back(std::abs(line.offsetMm));
    }
  return out;
}

// Returns the parts of a piece that are as far from the segments as tapes beside each other.
std::vector<SurfaceCurve> partsApart(const SurfaceCurve& piece, const SegmentGrid& others,
                                     double apartMm) {
  std::vector<SurfaceCurve> parts;
  bool wasApart = false;
  for (std::size_t i = 0; i < piece.points.size() + (piece.closed ? 1 : 0); ++i) {
    const SurfacePoint& p = piece.points[i % piece.points.size()];
    const SegmentGrid::Hit hit = others.nearest(p.position);
    const bool isApart = hit.segment < 0 || hit.distanceMm >= apartMm;
    if (isApart && !wasApart)
      parts.push_back({});
    if (isApart)
      parts.back().points.push_back(p);
    wasApart = isApart;
  }
  return parts;
}

// Shortens tapes that meet earlier ones, and leaves out those that become too short.
void keepApart(ClippedFamily& family, const process::Tape& tape) {
  ClippedFamily kept;
  kept.tapes.bentMm = family.tapes.bentMm;
  kept.tapes.shortMm = family.tapes.shortMm;
  std::vector<SegmentGrid::Segment> segments;
  for (std::size_t k = 0; k < family.tapes.paths.size(); ++k) {
    const SurfaceCurve& piece = family.tapes.paths[k];
    const SegmentGrid others(segments, tape.widthMm);
    std::vector<SurfaceCurve> parts = partsApart(piece, others, (1.0 - kCloser) * tape.widthMm);
    if (parts.size() == 1 && parts[0].points.size() == piece.points.size() + (piece.closed ? 1 : 0))
      parts = {piece};
    for (SurfaceCurve& part : parts) {
      const double length = lengthOf(part);
      if (part.points.size() < 2 || length < tape.minLengthMm) {
        kept.tapes.shortMm += length;
        continue;
      }
      for (std::size_t i = 1; i < part.points.size() + (part.closed ? 1 : 0); ++i)
        segments.push_back(
            {part.points[i - 1].position, part.points[i % part.points.size()].position});
      kept.lengthMm += length;
      kept.offsetMm.push_back(family.offsetMm[k]);
      kept.tapes.paths.push_back(std::move(part));
    }
  }
  family = std::move(kept);
}

// Keeps the longest tapes; of equally long ones those nearest to the middle. No rule leaves out the
// others.
void keepLongest(ClippedFamily& family, std::size_t maxCount) {
  constexpr double kSameLength = 0.01;
  if (family.tapes.paths.size() >= maxCount)
    family.tapes.bentMm = family.tapes.shortMm = 0.0;
  if (family.tapes.paths.size() <= maxCount)
    return;
  std::vector<std::size_t> order(family.tapes.paths.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto rank = [&](std::size_t i) {
    const double length = lengthOf(family.tapes.paths[i]);
    return std::pair(-std::lround(std::log(length) / kSameLength),
                     std::lround(1e3 * family.offsetMm[i]));
  };
  std::ranges::stable_sort(order, {}, rank);
  order.resize(maxCount);
  std::ranges::sort(order);
  ClippedFamily kept;
  for (const std::size_t i : order) {
    kept.lengthMm += lengthOf(family.tapes.paths[i]);
    kept.offsetMm.push_back(family.offsetMm[i]);
    kept.tapes.paths.push_back(std::move(family.tapes.paths[i]));
  }
  family = std::move(kept);
}

// Returns the family that covers most; of equal ones the one nearest to the middle.
std::size_t bestOf(const std::vector<ClippedFamily>& families) {
  constexpr double kSameMm = 0.5;
  const auto offset = [](const ClippedFamily& f) {
    double sum = 0.0;
    for (const double mm : f.offsetMm)
      sum += mm;
    return sum;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < families.size(); ++i) {
    const double more = families[i].lengthMm - families[best].lengthMm;
    if (more > kSameMm || (more > -kSameMm && offset(families[i]) < offset(families[best]) - 1e-6))
      best = i;
  }
  return best;
}

} // namespace

double bendRadius(const Vector3d& before, const Vector3d& at, const Vector3d& after,
                  const Vector3d& normal) {
  const auto flat = [&](const Vector3d& v) -> Vector3d { return v - v.dot(normal) * normal; };
  const Vector3d a = flat(at - before), b = flat(after - at), c = flat(after - before);
  const double twiceArea = std::abs(a.cross(b).dot(normal));
  return twiceArea > 0.0 ? a.norm() * b.norm() * c.norm() / (2.0 * twiceArea)
                         : std::numeric_limits<double>::infinity();
}

TapePaths tapePaths(const PatchSurface& surface, const process::Tape& tape,
                    const TapeChoice& choice, double stepMm, const base::RunContext& ctx) {
  const TapeKind& kind = tapeKind(choice.paths);
  if (surface.triangles.empty())
    return {};
  const Clipper clipper(surface, tape, choice);
  std::vector<ClippedFamily> families;
  for (const TapeFamily& family : kind.families(surface, tape, choice, ctx)) {
    ctx.checkpoint();
    families.push_back(clipped(clipper, family));
    if (kind.mayCross)
      keepApart(families.back(), tape);
    if (choice.maxCount > 0)
      keepLongest(families.back(), static_cast<std::size_t>(choice.maxCount));
  }
  if (families.empty())
    return {};
  const std::size_t best = kind.isInOrder ? 0 : bestOf(families);
  std::vector<TapeSet> all; // A limited number of tapes covers its own region only.
  for (const ClippedFamily& family : families)
    if (choice.maxCount == 0 || &family == &families[best])
      all.emplace_back(family.tapes.paths);
  const TapeCover cover = coverOf(surface, families[best].tapes.paths, all, tape.widthMm, ctx);
  TapePaths tapes = std::move(families[best].tapes);
  tapes.regionMm2 = cover.regionMm2;
  tapes.coveredMm2 = cover.coveredMm2;
  tapes.overlapMm2 = cover.overlapMm2;
  for (SurfaceCurve& path : tapes.paths)
    path = resample(surface, path, {.stepMm = stepMm}).curve;
  return tapes;
}

} // namespace voluta::toolpath
