#include "regions/plane_layers.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/nearest_share.h"
#include "layers/layer_checks.h"
#include "layers/layer_findings.h"
#include "layers/order.h"
#include "layers/patches.h"
#include "planar/slicing/layer_heights.h"
#include "planar/slicing/section.h"
#include "planar/slicing/slicing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace voluta::regions {

namespace {
using Eigen::Vector3d;

constexpr double kEdgeShare = 1.0 / 1.2; // of triangles of a layer, in beads
constexpr double kBlockingShare = 0.01;  // as of levels

// A layer in a plane.
struct PlaneLayer {
  planar::Plane middle;
  std::function<double(const Vector3d&)> thicknessMm;
};

layers::DroppedPiece dropped(const layers::Patch& sliver) {
  layers::DroppedPiece piece;
  piece.centre = geometry::bounds(sliver.surface).center();
  piece.areaMm2 = geometry::area(sliver.surface);
  piece.volumeMm3 = piece.areaMm2 * (sliver.thicknessMm.empty() ? 0.0 : sliver.thicknessMm.front());
  piece.level = sliver.layer;
  return piece;
}

substrate::StackedLevels stacked(const geometry::TriangleMesh& solid,
                                 const std::vector<PlaneLayer>& planes,
                                 const substrate::LevelOptions& levels,
                                 const base::RunContext& ctx) {
  std::vector<layers::PatchesOfLevel> made(planes.size());
  base::parallelChunks(ctx, made.size(), 1, [&](std::size_t begin, std::size_t end) {
    const base::RunContext silent = ctx.quiet();
    for (std::size_t k = begin; k < end; ++k) {
      const planar::Plane& plane = planes[k].middle;
      layers::LevelSurface surface =
          planar::sectionSurface(planar::Sections(solid, plane.normal).at(plane.offsetMm),
                                 std::max(1.0, kEdgeShare * levels.beadWidthMm), silent);
      surface.level = static_cast<int>(k);
      for (std::size_t v = 0; v < surface.thicknessMm.size(); ++v)
        surface.thicknessMm[v] = planes[k].thicknessMm(surface.surface.vertices[v]);
      made[k] = layers::makePatches(surface, {levels.beadWidthMm});
    }
  });
  substrate::StackedLevels result;
  std::vector<layers::DroppedPiece> slivers;
  for (layers::PatchesOfLevel& level : made) {
    std::ranges::move(level.patches, std::back_inserter(result.stack.patches));
    std::ranges::transform(level.slivers, std::back_inserter(slivers), dropped);
  }
  layers::orderForPrinting(result.stack);
  result.statistics =
      layers::layerStatistics(result.stack, {levels.heightMinMm, levels.heightMaxMm});
  const layers::NotPrinted left = layers::notPrinted(slivers);
  result.slivers = left.pieces;
  result.sliverVolumeMm3 = left.volumeMm3;
  if (auto finding = layers::sliversFinding(left, result.statistics.volumeMm3(), kBlockingShare))
    result.findings.push_back(std::move(*finding));
  return result;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};
template <typename Measure>
Range rangeOf(const geometry::TriangleMesh& mesh, const Measure& measure) {
  Range range;
  for (const auto& triangle : mesh.triangles)
    for (const int v : triangle) {
      const double at = measure(mesh.vertices[static_cast<std::size_t>(v)]);
      range.low = std::min(range.low, at);
      range.high = std::max(range.high, at);
    }
  return range;
}
} // namespace

substrate::StackedLevels flatLayers(const geometry::TriangleMesh& solid, const Vector3d& direction,
                                    const substrate::LevelOptions& levels,
                                    const base::RunContext& ctx) {
  planar::Piece piece;
  piece.solid = planar::tagged(solid);
  piece.base.normal = direction;
  piece.base.offsetMm = rangeOf(solid, [&](const Vector3d& p) { return direction.dot(p); }).low;
  planar::HeightOptions heights;
  heights.wantedMm = levels.layerHeightMm;
  heights.minMm = levels.heightMinMm;
  heights.maxMm = levels.heightMaxMm;
  const std::vector<double> bounds = planar::layerBounds(piece, heights);
  std::vector<PlaneLayer> planes;
  for (std::size_t k = 0; k + 1 < bounds.size(); ++k)
    planes.push_back({{direction, piece.base.offsetMm + 0.5 * (bounds[k] + bounds[k + 1])},
                      [height = bounds[k + 1] - bounds[k]](const Vector3d&) { return height; }});
  return stacked(solid, planes, levels, ctx);
}

substrate::StackedLevels turningLayers(const geometry::TriangleMesh& solid,
                                       const Vector3d& direction,
                                       const substrate::LevelOptions& levels,
                                       const base::RunContext& ctx) {
  const Vector3d up = Vector3d::UnitZ();
  const double angle = std::atan2(up.cross(direction).norm(), up.dot(direction));
  base::require(angle > 1e-6, "turningLayers: a direction other than z");
  const Vector3d axis = up.cross(direction).normalized();
  const double bottom = rangeOf(solid, [&](const Vector3d& p) { return p.z(); }).low;
  const double top = rangeOf(solid, [&](const Vector3d& p) { return direction.dot(p); }).high;
  // A point of both planes, and the direction from there into the solid along the bottom.
  const Vector3d inwards = axis.cross(up);
  const Vector3d hinge =
      bottom * up + (top - bottom * direction.z()) / direction.dot(inwards) * inwards;
  const auto radiusMm = [&](const Vector3d& p) {
    const Vector3d from = p - hinge;
    return (from - from.dot(axis) * axis).norm();
  };
  Range radius = rangeOf(solid, radiusMm);
  // Nearest on an edge, seen along the axis.
  const auto across = [&](const Vector3d& p) {
    const Vector3d from = p - hinge;
    return Eigen::Vector2d(from.dot(inwards), from.z());
  };
  for (std::size_t t = 0; t < solid.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d a = across(solid.corner(t, k)),
                            b = across(solid.corner(t, (k + 1) % 3));
      const double share = geometry::nearestShare(Eigen::Vector2d(0.0, 0.0), a, b);
      radius.low = std::min(radius.low, ((1.0 - share) * a + share * b).norm());
    }
  const auto least = static_cast<int>(std::ceil(radius.high * angle / levels.heightMaxMm - 1e-9)),
             most = static_cast<int>(std::floor(radius.low * angle / levels.heightMinMm + 1e-9));
  if (least > most)
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("layers that turn by {angle} within the region are {thin:.2f} to {thick:.2f} "
                      "thick, outside the limits"_text,
                      base::degrees(base::radiansToDegrees(angle)),
                      base::mm(radius.low * angle / std::max(1, least)),
                      base::mm(radius.high * angle / std::max(1, least))),
        "region"_text, "make the region higher or narrower, or turn by less"_text);
  const int wanted = static_cast<int>(
      std::lround(0.5 * (radius.low + radius.high) * angle / levels.layerHeightMm));
  const int count = std::clamp(wanted, std::max(1, least), most);
  std::vector<PlaneLayer> planes;
  for (int k = 0; k < count; ++k) {
    const double at = angle * (k + 0.5) / count;
    const Vector3d normal = Eigen::AngleAxisd(at, axis) * up;
    planes.push_back({{normal, normal.dot(hinge)}, [=](const Vector3d& p) {
                        const Vector3d from = p - hinge;
                        return (from - from.dot(axis) * axis).norm() * angle / count;
                      }});
  }
  return stacked(solid, planes, levels, ctx);
}

} // namespace voluta::regions
