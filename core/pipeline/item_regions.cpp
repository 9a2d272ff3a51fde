#include "pipeline/item_regions.h"

#include "base/error.h"
#include "base/key_text.h"
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "modes/level_choices.h"
#include "modes/platform_body.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "regions/region_figures.h"
#include "regions/region_patches.h"
#include "regions/region_uses.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace voluta::pipeline {

namespace {
using project::Region;

constexpr double kOnPlateMm = 1e-3;

const std::vector<Region>& regionsOf(const Resolved& resolved) {
  return resolved.choices.item().regions;
}

template <typename Is> bool any(const Resolved& resolved, const Is& is) {
  return std::ranges::any_of(regionsOf(resolved), [&](const Region& region) {
    return std::invoke(is, regions::findUse(region.use));
  });
}

regions::PlacedPart placedPart(const modes::LoadStage& placed, const geometry::TriangleMesh& whole,
                               const geometry::TriangleMesh& file, double unitMm) {
  const double scale = placed.scale * unitMm;
  return {whole, modes::motionOf(file, scale, placed.placement), scale};
}

// Keys of the regions for which `isMeant` holds; empty without any.
template <typename IsMeant> std::string keysOf(const Resolved& resolved, const IsMeant& isMeant) {
  std::string key;
  for (const Region& region : regionsOf(resolved))
    if (isMeant(regions::findUse(region.use))) {
      Region shape = region;
      shape.parameters.clear();
      key += "region " + keyOf(shape);
    }
  return key;
}

// Returns the choices of a region as those of an item.
Resolved resolvedRegion(const Resolved& item, const Region& region) {
  project::Choices own = item.choices;
  for (const auto& [key, value] : region.parameters)
    own.item().parameters[key] = value;
  // A skin or jacket is solid unless it is asked not to be.
  const regions::RegionLayers layers = regions::findUse(region.use).layers;
  if ((layers == regions::RegionLayers::Surface || layers == regions::RegionLayers::Around) &&
      !region.parameters.contains("infillDensity"))
    own.item().parameters["infillDensity"] = "1";
  return resolve(own);
}

toolpath::CoverRules rulesOf(const Resolved& resolved) {
  toolpath::ToolpathOptions options = toolpathOptionsOf(resolved.values, resolved.process());
  if (resolved.tools.infill != resolved.tools.part)
    options.infillTool = resolved.tools.infill;
  return {std::move(options), resolved.tooling};
}

} // namespace

bool hasRegions(const Resolved& resolved) {
  return !regionsOf(resolved).empty();
}

std::shared_ptr<const modes::LoadStage>
withCutRegions(std::shared_ptr<const modes::LoadStage> stage, const geometry::TriangleMesh& file,
               const Resolved& resolved, double unitMm, const base::RunContext& ctx) {
  if (!any(resolved, &regions::RegionUse::cuts) || !stage->part)
    return stage;
  auto cut = std::make_shared<modes::LoadStage>(*stage);
  cut->part = std::make_shared<geometry::TriangleMesh>(
      regions::withoutCuts(placedPart(*stage, *stage->part, file, unitMm), regionsOf(resolved),
                           modes::levelOptions(resolved.modeChoices()), ctx));
  const double floatsMm =
      geometry::bounds(*cut->part).min().z() - geometry::bounds(*stage->part).min().z();
  if (floatsMm > kOnPlateMm)
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("regions cut away what the part stands on: it would float "
                                    "{gap:.3g} above its place"_text,
                                    base::mm(floatsMm)),
                      {}, "cut the part in two instead, or leave a part of its foot"_text);
  cut->voxels = nullptr;
  project::ModelReport report = modelReport(*cut->part);
  report.scale = cut->report.scale;
  cut->report = std::move(report);
  return cut;
}

std::shared_ptr<const RegionStage> regionStage(const modes::LoadStage& placed,
                                               std::shared_ptr<const geometry::TriangleMesh> whole,
                                               const geometry::TriangleMesh& file,
                                               const Resolved& resolved, double unitMm,
                                               const base::RunContext& ctx) {
  const regions::PlacedPart part = placedPart(placed, *whole, file, unitMm);
  const substrate::LevelOptions levels = modes::levelOptions(resolved.modeChoices());
  const std::vector<Region>& all = regionsOf(resolved);
  auto stage = std::make_shared<RegionStage>();
  stage->rest = whole;
  if (any(resolved, &regions::RegionUse::hasLayers)) {
    regions::PartRegions made = regions::divided(part, all, levels, ctx);
    stage->layered = std::move(made.layered);
    if (!stage->layered.empty())
      stage->rest = std::make_shared<geometry::TriangleMesh>(std::move(made.rest));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const regions::RegionUse& use = regions::findUse(all[i].use);
    stage->bodies.emplace_back();
    bool isInPart =
        use.cuts || std::ranges::find(stage->layered, i, &regions::LayeredRegion::index) !=
                        stage->layered.end();
    if (!use.cuts && !use.hasLayers()) {
      stage->bodies.back() = regions::bodyOf(all[i], part, levels, ctx);
      const auto shared = geometry::meshBoolean(geometry::BooleanOperation::Intersection, *whole,
                                                stage->bodies.back(), false);
      isInPart = !shared || !shared->empty();
    }
    if (!isInPart)
      stage->findings.push_back(
          plan::makeFinding(plan::FindingKind::RegionOutside,
                            {{"region", all[i].name.empty() ? all[i].shape : all[i].name}}));
  }
  return stage;
}

std::shared_ptr<const modes::LayersStage>
withRegionLayers(std::shared_ptr<const modes::LayersStage> stage, const RegionStage& regions,
                 const geometry::TriangleMesh& part, const Resolved& resolved,
                 const base::RunContext& ctx) {
  if (!stage->layers || regions.layered.empty())
    return stage;
  const base::Stopwatch watch;
  const substrate::LevelOptions levels = modes::levelOptions(resolved.modeChoices());
  auto made = std::make_shared<modes::LayersStage>(*stage);
  layers::LayerStack stack = *stage->layers;
  for (const regions::LayeredRegion& region : regions.layered) {
    substrate::StackedLevels own = regions::layersOf(
        regionsOf(resolved)[region.index], region.solid, {part, *regions.rest}, levels, ctx);
    for (layers::Patch& patch : own.stack.patches) {
      patch.layer += stack.layerCount;
      patch.region = static_cast<int>(region.index) + 1;
      stack.patches.push_back(std::move(patch));
    }
    stack.layerCount += own.stack.layerCount;
    std::ranges::move(own.findings, std::back_inserter(made->findings));
  }
  const process::Process& process = resolved.process();
  made->report =
      layers::layerStatistics(stack, {process.layerHeightMinMm, process.layerHeightMaxMm});
  made->layers = layers::kept(std::move(stack));
  made->timings.extract += watch.seconds();
  return made;
}

std::shared_ptr<const modes::LayersStage>
dividedByRegions(std::shared_ptr<const modes::LayersStage> stage, const RegionStage& regions,
                 const geometry::TriangleMesh& part, const Resolved& resolved,
                 const base::RunContext& ctx) {
  if (!stage->layers)
    return stage;
  const base::Stopwatch watch;
  const std::vector<Region>& all = regionsOf(resolved);
  std::vector<regions::SettingsRegion> dividing;
  for (std::size_t i = 0; i < regions.bodies.size(); ++i)
    if (!regions.bodies[i].empty())
      dividing.push_back({static_cast<int>(i) + 1, regions.bodies[i]});
  auto made = std::make_shared<modes::LayersStage>(*stage);
  layers::LayerStack stack =
      dividing.empty()
          ? *stage->layers
          : regions::dividedPatches(*stage->layers, dividing, resolved.process().beadWidthMm, ctx);
  std::vector<int> tools{resolved.tools.part};
  for (const Region& region : all)
    tools.push_back(resolvedRegion(resolved, region).tools.part);
  for (layers::Patch& patch : stack.patches)
    if (patch.region > 0)
      patch.tool = tools[static_cast<std::size_t>(patch.region)];
  made->report.patches = stack.patches.size();
  made->report.regions = regions::figuresOf(*stage->layers, stack, part, all, regions.bodies, ctx);
  made->layers = layers::kept(std::move(stack));
  made->timings.extract += watch.seconds();
  return made;
}

std::vector<toolpath::CoverRules> coverRules(const Resolved& resolved) {
  std::vector<toolpath::CoverRules> rules{rulesOf(resolved)};
  for (const Region& region : regionsOf(resolved))
    rules.push_back(rulesOf(resolvedRegion(resolved, region)));
  return rules;
}

std::string cutRegionsKey(const Resolved& resolved) {
  return keysOf(resolved, [](const regions::RegionUse& use) { return use.cuts; });
}

std::string layeredRegionsKey(const Resolved& resolved) {
  return keysOf(resolved, [](const regions::RegionUse& use) { return use.hasLayers(); });
}

std::string dividingRegionsKey(const Resolved& resolved) {
  return keysOf(resolved,
                [](const regions::RegionUse& use) { return !use.cuts && !use.hasLayers(); });
}

std::string regionRulesKey(const Resolved& resolved) {
  std::string key;
  for (const Region& region : regionsOf(resolved)) {
    const Resolved own = resolvedRegion(resolved, region);
    key += "region " + base::keyText(own.tools.part) + toolpath::optionsKey(rulesOf(own).options);
  }
  return key;
}

} // namespace voluta::pipeline
