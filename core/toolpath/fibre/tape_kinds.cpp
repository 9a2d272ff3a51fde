#include "base/error.h"
#include "base/nearest_name.h"
#include "base/run_context.h"
#include "toolpath/fibre/streamlines.h"
#include "toolpath/fibre/tape_paths.h"
#include "toolpath/infill/across_lines.h"
#include "toolpath/infill/strand_text.h"
#include "toolpath/surface_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// Families that are shifted by a share of the width against each other
constexpr int kShifts = 8;
constexpr double kSourceStepMm = 1.0; // of curves that are given

// Returns the isolines at `middle` + (k + shift) widths for all k within [low, high].
TapeFamily linesAt(const PatchSurface& s, const std::vector<double>& values, double widthMm,
                   double middle, double shift, double low, double high) {
  TapeFamily family;
  for (double k = std::ceil((low - middle) / widthMm - shift);
       middle + (k + shift) * widthMm <= high; k += 1.0) {
    const double offset = (k + shift) * widthMm;
    for (SurfaceCurve& curve : isolines(s, values, middle + offset))
      family.push_back({std::move(curve), offset});
  }
  return family;
}

std::vector<TapeFamily> alongDirection(const PatchSurface& s, const process::Tape& tape,
                                       const TapeChoice& choice, const base::RunContext& ctx) {
  // Isolines need values that differ from those of vertices.
  constexpr double kBesideVertices = 1e-6;
  const std::vector<double> across = acrossLines(s, choice.directionRad);
  const auto [low, high] = std::ranges::minmax(across);
  std::vector<TapeFamily> families;
  for (int i = 0; i < kShifts; ++i) {
    ctx.checkpoint();
    families.push_back(linesAt(s, across, tape.widthMm, 0.5 * (low + high) + kBesideVertices,
                               static_cast<double>(i) / kShifts, low, high));
  }
  return families;
}

std::vector<TapeFamily> alongContour(const PatchSurface& s, const process::Tape& tape,
                                     const TapeChoice&, const base::RunContext& ctx) {
  // The outermost tape lies along the boundary: a little farther in, so that it is inside by half
  // its width in spite of rounding.
  const double first = (0.5 + 2e-3) * tape.widthMm;
  const std::vector<double> depth =
      distanceToSegments(s, boundarySegments(s), std::numeric_limits<double>::infinity());
  const double deepest = *std::ranges::max_element(depth);
  std::vector<TapeFamily> families;
  for (int i = 0; i < kShifts; ++i) {
    ctx.checkpoint();
    families.push_back(
        linesAt(s, depth, tape.widthMm, first, static_cast<double>(i) / kShifts, first, deepest));
  }
  return families;
}

// Returns the point of the surface nearest to p.
SurfacePoint nearestPoint(const PatchSurface& s, const Vector3d& p) {
  int nearest = 0;
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    Vector3d middle = Vector3d::Zero();
    for (const int v : s.triangles[t])
      middle += s.position[static_cast<std::size_t>(v)] / 3.0;
    if (const double d = (middle - p).squaredNorm(); d < minimum) {
      minimum = d;
      nearest = static_cast<int>(t);
    }
  }
  return s.project(p, nearest);
}

// Returns the projection of a polyline. Points whose foot is on the boundary, because the polyline
// continues beyond the patch, are left to the clipping.
SurfaceCurve projected(const PatchSurface& s, const std::vector<Vector3d>& line) {
  SurfaceCurve curve;
  curve.points.push_back(nearestPoint(s, line.front()));
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vector3d step = line[i] - line[i - 1];
    const int n = std::max(1, static_cast<int>(std::ceil(step.norm() / kSourceStepMm)));
    for (int k = 1; k <= n; ++k) {
      const SurfacePoint next = s.project(line[i - 1] + step * (static_cast<double>(k) / n),
                                          curve.points.back().triangle);
      if ((next.position - curve.points.back().position).norm() > 1e-6)
        curve.points.push_back(next);
    }
  }
  return curve;
}

std::vector<TapeFamily> alongCurves(const PatchSurface& s, const process::Tape&,
                                    const TapeChoice& choice, const base::RunContext& ctx) {
  if (choice.curves.empty())
    throw base::Error(base::ErrorCode::Usage, "there is no curve for tapes"_text,
                      "fibreCurves"_name,
                      "give points in mm: x,y or x,y,z, separated by spaces, at least two for each "
                      "curve, and semicolons between curves"_text);
  TapeFamily family;
  for (const std::vector<Vector3d>& line : choice.curves) {
    ctx.checkpoint();
    if (SurfaceCurve curve = projected(s, line); curve.points.size() >= 2)
      family.push_back({std::move(curve), 0.0});
  }
  return {family};
}

std::vector<TapeFamily> alongField(const PatchSurface& s, const process::Tape& tape,
                                   const TapeChoice& choice, const base::RunContext& ctx) {
  if (choice.field.empty())
    throw base::Error(
        base::ErrorCode::Usage, "there is no field of directions for tapes"_text, "fibreField"_name,
        "give place and direction as x,y,z,dx,dy,dz, separated by spaces or lines"_text);
  const DirectionField field([&](const Vector3d& place) { return dyadsAt(choice.field, place); });
  std::vector<TapeFamily> families;
  for (int i = 0; i < kShifts; ++i) {
    const double first = tape.widthMm * i / kShifts;
    TapeFamily family;
    for (SurfaceCurve& curve : evenStreamlines(s, field, tape.widthMm, first, ctx))
      family.push_back({std::move(curve), 0.0});
    families.push_back(std::move(family));
  }
  return families;
}

constexpr std::array<TapeKind, 4> kKinds{{
    {"direction", "in one direction"_text, alongDirection},
    {"contour", "along the outline"_text, alongContour, true},
    {"field", "along a field of directions"_text, alongField, false, true},
    {"curves", "along given curves"_text, alongCurves, true, true},
}};
} // namespace

std::span<const TapeKind> tapeKinds() {
  return kKinds;
}

const TapeKind& tapeKind(std::string_view id) {
  return base::rowWithId(tapeKinds(), id, "unknown paths of tapes '{id}'"_text, "fibrePaths"_name);
}

} // namespace voluta::toolpath
