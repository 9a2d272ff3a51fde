#include "toolpath/unsupported/bridged_layers.h"

#include "base/parallel.h"
#include "base/run_context.h"
#include "process/bead_model.h"
#include "toolpath/plane/level_patches.h"
#include "toolpath/plane/plane_patch.h"
#include "toolpath/unsupported/bridge_beads.h"
#include "toolpath/unsupported/bridge_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace voluta::toolpath {

namespace {
using ClipperLib::Paths;
using geometry::combined;

bool isOnPlate(const platform::PlatformSolid& platform) {
  return !platform.mesh && !platform.rod;
}

// Returns the area inside the walls.
Paths insideOf(const PlanePatch& plane, double wallsMm) {
  const Paths solid = geometry::united(plane.contours());
  if (wallsMm <= 0.0 || plane.outline.empty())
    return solid;
  return combined(solid, geometry::offsetPaths(geometry::united(plane.outline), -wallsMm, {0.01}),
                  ClipperLib::ctIntersection);
}

// Returns the contours of a layer without the bridges.
Paths contoursAround(const Paths& bridges, const PlanePatch& plane, int walls) {
  const Paths solid = geometry::united(plane.contours());
  if (walls == 0 || plane.outline.empty())
    return combined(solid, bridges, ClipperLib::ctDifference);
  // All points of the outline stay, since widths of walls are found there.
  const Paths holes =
      combined(combined(geometry::united(plane.outline), solid, ClipperLib::ctDifference), bridges,
               ClipperLib::ctUnion);
  Paths contours = plane.outline;
  contours.insert(contours.end(), holes.begin(), holes.end());
  return contours;
}

// The bridges of a layer and the walls around them.
struct WalledBridges {
  int walls = 0;
  std::vector<BridgeRegion> regions;
  double heldMm2 = 0.0; // of the gap that they bridge
  double longestMm = 0.0;

  bool isClearlyBetterThan(const WalledBridges& other) const {
    constexpr double kClear = 1.1;
    return heldMm2 > kClear * other.heldMm2 ||
           (kClear * heldMm2 >= other.heldMm2 && kClear * longestMm < other.longestMm);
  }
};

// Returns the bridges inside as many of the usual walls as leave them their holds: the inner side
// of a lid on thin walls lies on nothing. Only a lid goes without any wall.
WalledBridges walledBridges(const PlanePatch& plane, const Paths& air, const Paths& below,
                            const process::Process& process, int walls, double widestMm) {
  constexpr double kLidShare = 0.5; // of the layer
  const double hatch = process::hatchOf(process.beadWidthMm, process.layerHeightMm);
  const auto wallsMm = [&](int count) {
    return count == 0 ? 0.0 : count * hatch + std::max(0.0, widestMm - process.beadWidthMm);
  };
  const Paths gap = combined(air, insideOf(plane, wallsMm(walls)), ClipperLib::ctIntersection);
  const bool isLid = geometry::areaMm2(wideGaps(gap, process)) >=
                     kLidShare * geometry::areaMm2(geometry::united(plane.contours()));
  WalledBridges best;
  for (int count = walls; count >= 0; --count) {
    if (count == 0 && walls > 0 && !isLid)
      break;
    WalledBridges made;
    made.walls = count;
    made.regions = bridgeRegions(insideOf(plane, wallsMm(count)), below, process);
    for (const BridgeRegion& region : made.regions) {
      made.heldMm2 += geometry::areaMm2(combined(region.area, gap, ClipperLib::ctIntersection));
      made.longestMm = std::max(made.longestMm, region.longestMm);
    }
    if (count == walls || made.isClearlyBetterThan(best))
      best = std::move(made);
  }
  return best;
}

std::optional<BridgedLayer> bridgedLayer(const layers::Patch& patch, const LevelPatches& levels,
                                         process::Process process,
                                         const std::vector<double>& wallWidthMm,
                                         const ToolpathOptions& options) {
  if (patch.group == layers::kSupportGroup)
    return std::nullopt;
  const std::optional<PlanePatch> plane = planePatch(patch);
  if (!plane || !plane->isEven || !isLevel(*plane))
    return std::nullopt;
  const Paths below = levels.below(*plane);
  if (below.empty())
    return std::nullopt;
  // Most layers have no gap.
  const Paths air = combined(geometry::united(plane->contours()), below, ClipperLib::ctDifference);
  if (geometry::offsetPaths(air, -0.5 * process.beadWidthMm, {0.01}).empty())
    return std::nullopt;
  process.layerHeightMm = std::min(plane->thicknessMm, process.beadWidthMm);
  const double widest = wallWidthMm.empty() ? 0.0 : std::ranges::max(wallWidthMm);
  const WalledBridges bridges = walledBridges(*plane, air, below, process, options.walls, widest);
  const double longestMm =
      options.bridgesMaySag ? process::saggingBridgeMm(process) : process.bridgeMm;
  BridgedLayer layer;
  layer.walls = bridges.walls;
  Paths taken;
  for (const BridgeRegion& region : bridges.regions) {
    std::vector<Bead> beads =
        bridgeBeads(region, below, *plane, process, longestMm, options.stepMm);
    if (beads.empty())
      continue;
    std::ranges::move(beads, std::back_inserter(layer.beads));
    std::ranges::copy(region.area, std::back_inserter(taken));
  }
  if (taken.empty())
    return std::nullopt;
  taken = geometry::united(taken);
  auto rest = patchOver(contoursAround(taken, *plane, layer.walls), *plane, patch);
  if (!rest)
    return std::nullopt;
  layer.rest = std::move(*rest);
  layer.areaMm2 = geometry::areaMm2(taken);
  layer.volumeMm3 = plane->thicknessMm * layer.areaMm2;
  return layer;
}

using PlaceKey = std::array<long long, 3>;

PlaceKey keyOf(const Eigen::Vector3d& place) {
  constexpr double kUnits = 1e3; // per mm: contours round their points to less
  return {std::llround(kUnits * place.x()), std::llround(kUnits * place.y()),
          std::llround(kUnits * place.z())};
}
} // namespace

std::vector<std::optional<BridgedLayer>>
bridgedLayers(const layers::LayerStack& stack, const layers::LayerStack& whole,
              const std::function<process::Process(std::size_t)>& processOf,
              const std::vector<std::vector<double>>& wallWidths, const ToolpathOptions& options,
              const base::RunContext& ctx) {
  std::vector<std::optional<BridgedLayer>> layers(stack.patches.size());
  if (!isOnPlate(options.platform))
    return layers;
  const LevelPatches levels(whole, ctx);
  base::parallelChunks(ctx, layers.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      layers[i] = bridgedLayer(stack.patches[i], levels, processOf(i), wallWidths[i], options);
  });
  return layers;
}

std::vector<double> wallWidthsOf(const layers::Patch& rest, const layers::Patch& patch,
                                 const std::vector<double>& widthMm, double usualMm) {
  if (widthMm.empty())
    return {};
  std::map<PlaceKey, double> widths;
  for (std::size_t v = 0; v < patch.surface.vertices.size(); ++v)
    widths.emplace(keyOf(patch.surface.vertices[v]), widthMm[v]);
  std::vector<double> own;
  for (const Eigen::Vector3d& place : rest.surface.vertices) {
    const auto at = widths.find(keyOf(place));
    own.push_back(at == widths.end() ? usualMm : at->second);
  }
  return own;
}

} // namespace voluta::toolpath
