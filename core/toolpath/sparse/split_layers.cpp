#include "toolpath/sparse/split_layers.h"

#include "base/index.h"
#include "base/parallel.h"
#include "layers/level_surface.h"
#include "process/bead_model.h"
#include "toolpath/infill/regions.h"
#include "toolpath/patch_surface.h"
#include "toolpath/sparse/plane_split.h"
#include "toolpath/surface_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

using base::at;

double hatchOf(const process::Process& process) {
  return process::hatchOf(process.beadWidthMm, process.layerHeightMm);
}

// Returns per vertex whether fewer layers than required are above or below it; false where
// `isInterior` is.
std::vector<char> skinVertices(const PatchSurface& s, std::size_t patch, const LayerCount& layers,
                               const ToolpathOptions& o, const std::vector<char>& isInterior) {
  std::vector<char> skin(s.position.size(), 0);
  const auto lacks = [&](std::size_t v, double sign, int wanted) {
    if (wanted == 0)
      return false;
    // Thin layers: more of them make up the thickness.
    const int enough = skinLayers(wanted, o.skinMm, s.thicknessMm[v]);
    const LayerCount::Layers found =
        layers.along(patch, s.position[v], sign * s.direction[v], s.thicknessMm[v], enough);
    return found.count < wanted || (found.count < enough && found.mm < o.skinMm);
  };
  for (std::size_t v = 0; v < skin.size(); ++v)
    skin[v] = isInterior[v] && (lacks(v, 1.0, o.topLayers) || lacks(v, -1.0, o.bottomLayers));
  return skin;
}

// Returns per vertex the distance from the skins along the surface [mm], negative in them.
std::vector<double> distanceFromSkin(const PatchSurface& s, const std::vector<char>& skin,
                                     double farMm) {
  std::vector<double> value(skin.size());
  for (std::size_t v = 0; v < value.size(); ++v)
    value[v] = skin[v] ? -1.0 : 1.0;
  const std::vector<SurfaceCurve> edges = isolines(s, value, 0.0);
  std::vector<double> off = distanceToSegments(s, segmentsOf(s, edges), farMm);
  for (std::size_t v = 0; v < value.size(); ++v)
    off[v] *= value[v];
  return off;
}

// Returns per vertex how far inside the sparse part it is [mm]; negative in walls and skins.
std::vector<double> sparseDepth(const PatchSurface& s, std::size_t patch, const LayerCount& layers,
                                const process::Process& process, const ToolpathOptions& o) {
  const double hatch = hatchOf(process);
  std::vector<double> inside = distanceToSegments(s, boundaryParts(s).surface, 1e9);
  std::vector<char> isInterior(inside.size());
  for (std::size_t v = 0; v < inside.size(); ++v) {
    inside[v] -= o.walls * hatch;
    isInterior[v] = inside[v] > -0.5 * hatch;
  }
  if (std::ranges::none_of(inside, [&](double d) { return d > 0.5 * kMinSparse * hatch; }))
    return inside;
  const std::vector<char> skin = skinVertices(s, patch, layers, o, isInterior);
  if (std::ranges::find(skin, 1) != skin.end()) {
    const std::vector<double> off = distanceFromSkin(s, skin, 1e9);
    for (std::size_t v = 0; v < inside.size(); ++v)
      inside[v] = std::min(inside[v], off[v] - kSkinExtension * hatch);
  }
  return inside;
}

// Makes narrow sparse parts solid. Returns whether any sparse part is left.
bool dropNarrow(const PatchSurface& s, double minWidthMm, std::vector<double>& depth) {
  const Regions parts = regionsAbove(s, depth, 0.0);
  std::vector<double> deepest(at(parts.count), 0.0);
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (const int part = parts.ofVertex[v]; part >= 0)
      deepest[at(part)] = std::max(deepest[at(part)], depth[v]);
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (const int part = parts.ofVertex[v]; part >= 0 && 2.0 * deepest[at(part)] < minWidthMm)
      depth[v] = -1e-3;
  return std::ranges::any_of(deepest, [&](double d) { return 2.0 * d >= minWidthMm; });
}

layers::LevelSurface levelOf(const PatchSurface& s) {
  layers::LevelSurface level;
  level.surface.vertices = s.position;
  level.surface.triangles = s.triangles;
  level.thicknessMm = s.thicknessMm;
  level.direction = s.direction;
  level.clearDirection = s.clearDirection;
  level.innerRim = s.seam;
  level.chart = s.chart;
  return level;
}

// Returns the part of the surface with values >= 0, with the other properties of `patch`.
layers::Patch cutOut(const PatchSurface& s, const std::vector<double>& values,
                     const layers::Patch& patch) {
  layers::LevelSurface level = levelOf(s);
  layers::keepPositive(level, values);
  layers::Patch part;
  layers::setSurface(part, std::move(level));
  layers::takePlace(part, patch);
  return part;
}

void splitSurface(std::size_t i, const layers::Patch& patch, const LayerCount& count,
                  const process::Process& process, const ToolpathOptions& options,
                  SplitLayers& split) {
  const PatchSurface s = PatchSurface::refine(patch, options.edgeMm);
  std::vector<double> depth = sparseDepth(s, i, count, process, options);
  if (!dropNarrow(s, kMinSparse * hatchOf(process), depth))
    return;
  split.sparse[i] = cutOut(s, depth, patch);
  for (double& d : depth)
    d = -d;
  split.solid.patches[i] = cutOut(s, depth, patch);
}

// Returns the contours of a plane layer's solid part.
ClipperLib::Paths solidAround(const ClipperLib::Paths& area, const PlanePatch& plane,
                              const ToolpathOptions& options) {
  if (options.walls == 0)
    return geometry::combined(plane.outline, area, ClipperLib::ctDifference);
  // Inside the walls. All points of the outline stay, since widths of walls are found there.
  ClipperLib::Paths contours = plane.outline;
  contours.insert(contours.end(), area.begin(), area.end());
  return contours;
}

// A layer whose parts cannot be triangulated stays solid.
void splitPlane(std::size_t i, const layers::Patch& patch, const PlaneLevels& levels,
                const process::Process& process, const ToolpathOptions& options,
                SplitLayers& split) {
  const PlanePatch& plane = *levels.patch(i);
  ClipperLib::Paths area = sparseArea(levels, i, process, options);
  if (area.empty())
    return;
  auto sparse = patchOver(area, plane, patch);
  auto solid = patchOver(solidAround(area, plane, options), plane, patch);
  if (!sparse || !solid)
    return;
  split.sparse[i] = std::move(*sparse);
  split.solid.patches[i] = std::move(*solid);
  split.sparseAreas[i] = std::move(area);
}
} // namespace

SplitLayers splitLayers(const layers::LayerStack& stack, const StackLayers& layers,
                        std::span<const CoverRules> rules, const base::RunContext& ctx) {
  SplitLayers split{stack, {}, {}};
  split.sparse.resize(stack.patches.size());
  split.sparseAreas.resize(stack.patches.size());
  base::parallelChunks(ctx, stack.patches.size(), 1, [&](std::size_t i, std::size_t) {
    const layers::Patch& patch = stack.patches[i];
    if (patch.surface.empty() || patch.group == layers::kSupportGroup)
      return;
    const auto& [options, tooling] = rules[at(patch.region)];
    if (options.infillDensity >= 1.0 && options.infillTool < 0)
      return;
    const process::Process& process = tooling.at(patch.tool).process;
    if (layers.levels.isEven(i))
      splitPlane(i, patch, layers.levels, process, options, split);
    else {
      splitSurface(i, patch, *layers.count, process, options, split);
      if (layers.levels.patch(i) && split.sparse[i])
        if (const auto plane = planePatch(*split.sparse[i]))
          split.sparseAreas[i] = plane->contours();
    }
  });
  return split;
}

} // namespace voluta::toolpath
