#include "pipeline/item_stages.h"

#include "base/error.h"
#include "base/key_text.h"
#include "curved/decomposition.h"
#include "geometry/measures.h"
#include "layers/stair_steps.h"
#include "layers/support_rules.h"
#include "layers/walled_support.h"
#include "modes/mode_table.h"
#include "modes/part_voxels.h"
#include "modes/planar_modes.h"
#include "modes/region_supports.h"
#include "pipeline/automatic.h"
#include "pipeline/given_paths.h"
#include "pipeline/items/named_errors.h"
#include "pipeline/part_ways.h"
#include "pipeline/planned_parameters.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_keys.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "pipeline/start_check.h"
#include "plan/finding_kinds.h"
#include "planar/flat.h"
#include "support/supports.h"
#include "toolpath/options.h"
#include "toolpath/plan_toolpaths.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace voluta::pipeline {

namespace {
using project::Stage;

std::shared_ptr<const project::LoadedPart> loadedOf(const RequestedItem& part, bool repair,
                                                    const base::RunContext& ctx) {
  return part.loaded ? project::withRepair(part.loaded, repair, ctx)
                     : project::loadPart(part.part, repair, ctx);
}

bool isOfOtherUnits(const SizeStage& size) {
  return std::ranges::any_of(size.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::TinyPart || f.kind == plan::FindingKind::HugePart;
  });
}

// Returns the stage with the tools of its patches; itself if they are all the first one.
std::shared_ptr<const modes::LayersStage> withTools(std::shared_ptr<const modes::LayersStage> stage,
                                                    const layers::ToolAssignment& tools) {
  if (tools.used() == std::vector<int>{0} || !stage->layers)
    return stage;
  layers::LayerStack stack = *stage->layers;
  layers::assignTools(stack, tools);
  auto assigned = std::make_shared<modes::LayersStage>(*stage);
  assigned->layers = layers::kept(std::move(stack));
  return assigned;
}

std::shared_ptr<const modes::LayersStage> withSteps(std::shared_ptr<const modes::LayersStage> stage,
                                                    const geometry::TriangleMesh& part,
                                                    const base::RunContext& ctx) {
  if (!stage->layers)
    return stage;
  const layers::StepFigures steps = layers::stepsOf(*stage->layers, part, ctx);
  auto measured = std::make_shared<modes::LayersStage>(*stage);
  measured->report.stepMeanMm = steps.meanMm;
  measured->report.stepMaxMm = steps.maxMm;
  return measured;
}

// Flat layers make steps on gentle slopes, which layers along the surface would not.
std::shared_ptr<const modes::LayersStage>
withStaircase(std::shared_ptr<const modes::LayersStage> stage, const geometry::TriangleMesh& part,
              const base::RunContext& ctx) {
  constexpr double kFlattest = 0.9986, kSteepest = 0.7071; // cosines of 3 and 45 degrees
  constexpr double kWorthwhile = 0.1;                      // of the surface
  if (!stage->layers)
    return stage;
  std::vector<char> isGentle(part.triangles.size());
  double gentle = 0.0;
  for (std::size_t t = 0; t < isGentle.size(); ++t) {
    const double upward = geometry::triangleNormal(part, t).z();
    isGentle[t] = upward > kSteepest && upward < kFlattest ? 1 : 0;
    gentle += isGentle[t] ? geometry::triangleArea(part, t) : 0.0;
  }
  const double share = gentle / geometry::area(part);
  if (share < kWorthwhile)
    return stage;
  auto found = std::make_shared<modes::LayersStage>(*stage);
  found->findings.push_back(plan::makeFinding(
      plan::FindingKind::Staircase,
      {{"share", base::percent(100.0 * share)},
       {"mean", base::mm(layers::stepsOn(*stage->layers, part, isGentle, ctx).meanMm)}}));
  return found;
}

std::shared_ptr<const modes::LayersStage>
withWalledSupport(std::shared_ptr<const modes::LayersStage> stage,
                  const geometry::TriangleMesh& part) {
  if (!stage->layers)
    return stage;
  const std::optional<plan::Finding> walled = layers::walledSupport(*stage->layers, part);
  if (!walled)
    return stage;
  auto withFinding = std::make_shared<modes::LayersStage>(*stage);
  withFinding->findings.push_back(*walled);
  return withFinding;
}

// Returns the stage with the part moved down to z = 0.
std::shared_ptr<const modes::LoadStage> onPlate(const modes::LoadStage& placed) {
  auto lowered = std::make_shared<modes::LoadStage>(placed);
  auto part = std::make_shared<geometry::TriangleMesh>(*placed.part);
  const double lift = geometry::bounds(*part).min().z();
  for (Eigen::Vector3d& v : part->vertices)
    v.z() -= lift;
  lowered->part = std::move(part);
  return lowered;
}

// The tool-paths of a file are printed as they are.
void requireNoRegions(const project::Choices& choices) {
  if (!choices.item().regions.empty())
    throw base::Error(
        base::ErrorCode::Usage, "the tool-paths of a file have no regions"_text, {},
        "remove the regions, or plan layers of the part (`givenToolPaths=false`)"_text);
}

void append(plan::Findings& to, const plan::Findings& more) {
  to.insert(to.end(), more.begin(), more.end());
}

bool isOverhangOfSlices(const plan::Finding& finding) {
  using enum plan::FindingKind;
  return finding.kind == OverhangOfFlat || finding.kind == OverhangsOfFlat ||
         finding.kind == OverhangOfPieces || finding.kind == OverhangsOfPieces;
}

// Returns whether the part or one of its regions has supports.
bool asksForSupports(const Resolved& resolved) {
  return modes::supportsSomewhere(resolved.modeChoices());
}

bool hasLayerPlanes(const modes::Mode& mode, const Resolved& resolved) {
  return mode.requiresParameter("layerPlanes") && !resolved.values.text("layerPlanes").empty();
}
} // namespace

ItemStages::ItemStages(const StageContext& context, const project::Choices& given,
                       std::size_t index, const RequestedItem& part, PlanResult& result)
    : context_(context), given_(project::onlyItem(given, index)), index_(index), result_(result),
      resolved_(*result.item(index).resolved),
      mode_(modes::findMode(resolved_.choices.item().mode)) {
  report().decomposition.mode = resolved_.choices.item().mode;
  report().chosen = chosenReport();
  loaded_ = loadedOf(part, resolved_.choices.item().repair, context_.span(Stage::Load));
  item().loaded = loaded_;
  item().partName = loaded_->name;
  hasGivenPaths_ = takesGivenPaths(*loaded_, resolved_.values);
  if (hasGivenPaths_) {
    requireOwnSize(resolved_.choices);
    requireNoRegions(resolved_.choices);
  } else {
    namingPart(resolved_.isBesideOthers, loaded_->name, [&] { requireLoads(); });
  }
  keys_ = keysOf(*loaded_, resolved_);
}

void ItemStages::requireLoads() const {
  if (context_.until() >= Stage::Decompose)
    requireHeld(resolved_.choices.item().regions);
  if (context_.until() >= Stage::Toolpath)
    requireField(resolved_);
}

project::ChosenReport ItemStages::chosenReport() const {
  const project::ItemChoices& given = given_.item();
  return {.strategy = given.automatic ? given.automaticStrategy : std::string(),
          .name = nameOfStrategy(given_),
          .mode = resolved_.choices.item().mode,
          .platform = resolved_.choices.item().platform.text(),
          .supports = mode_.requiresParameter("supports") ? resolved_.values.text("supports")
                                                          : std::string(),
          .layerHeightMm = resolved_.process().layerHeightMm};
}

// Repairs made when the part was loaded and then to close it, and what the job does not take from
// its file, each once.
std::vector<base::Message> ItemStages::allRepairs() const {
  std::vector<base::Message> all = loaded_->notes;
  for (const base::Message& repair : placed_->report.repairs)
    if (std::ranges::find(all, repair) == all.end())
      all.push_back(repair);
  if (hasGivenPaths_) {
    std::ranges::copy(missingToolNotes(*loaded_->toolPaths, resolved_.tooling),
                      std::back_inserter(all));
    std::ranges::copy(noEffectNotes(resolved_), std::back_inserter(all));
  }
  return all;
}

const ShapedPart& ItemStages::shaped() {
  if (!shaped_.part)
    shaped_ = shapedPart(loaded_, resolved_, context_.span(Stage::Load).quiet());
  return shaped_;
}

ItemOutcome ItemStages::load() {
  const base::RunContext span = context_.span(Stage::Load);
  placed_ = context_.cachedOrMade<modes::LoadStage>(keyOf(Stage::Load), slot({}), [&] {
    if (shaped().ground)
      return loadStageOnGround(shaped(), resolved_, span);
    return withCutRegions(loadStage(*shaped().part, resolved_, span), *loaded_->mesh, resolved_,
                          fileUnitMm(), span.quiet());
  });
  result_.item(index_).placed = placed_;
  item().scale = placed_->scale;
  item().placement = placed_->placement;
  item().part = placed_->part;
  report().model = placed_->report;
  report().model.file = loaded_->name;
  report().model.repairs = allRepairs();
  ItemOutcome out;
  out.timings = placed_->timings;
  out.timings.load = loaded_->readS;
  out.timings.repair = loaded_->repairS;
  // A surface that encloses nothing cannot be measured.
  if (std::ranges::any_of(placed_->findings, &plan::Finding::blocking)) {
    out.findings = placed_->findings;
    out.continues = false;
    return out;
  }
  const auto size = context_.cachedOrMade<SizeStage>(
      keyOf(Stage::Load) + base::keyText(resolved_.choices.cell, resolved_.process().id,
                                         resolved_.process().beadWidthMinMm,
                                         resolved_.process().layerHeightMinMm),
      slot("size"), [&] { return sizeStage(*shaped().part, *placed_, resolved_, span.quiet()); });
  // A part that was drawn in other units is not planned.
  const bool isOdd = isOfOtherUnits(*size);
  out.findings = isOdd ? plan::Findings() : startFindings();
  out.continues = !isOdd && out.findings.empty();
  // Its other orientations are not worth the time and the memory if it is larger than the plates.
  const bool isTooLarge = std::ranges::any_of(out.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::LargerThanPlates;
  });
  const auto stand = context_.cachedOrMade<StandStage>(
      standKey(*loaded_, *placed_, resolved_) + base::keyText(hasGivenPaths_, isTooLarge),
      slot("stand"), [&] {
        return hasGivenPaths_ || isTooLarge ? std::make_shared<const StandStage>()
                                            : standStage(*placed_, resolved_, span.quiet());
      });
  append(out.findings, size->findings);
  append(out.findings, stand->findings);
  append(out.findings, remainingDefects(*loaded_));
  if (hasGivenPaths_)
    append(out.findings, amountFindings(*loaded_));
  append(out.findings, placed_->findings);
  return out;
}

// By the choices as they were given: in mode auto the platform may be the user's or not.
plan::Findings ItemStages::startFindings() {
  return context_
      .cachedOrMade<StartStage>(startKey(*placed_, given_, resolved_), slot("start"),
                                [&] {
                                  return startStage(*placed_, given_, resolved_,
                                                    context_.span(Stage::Load).quiet());
                                })
      ->findings;
}

// Most edits of a decomposition leave the voxels as they are.
std::shared_ptr<const modes::PartVoxels> ItemStages::voxels(double voxelMm,
                                                            const base::RunContext& ctx) {
  return context_.cachedOrMade<modes::PartVoxels>(
      placedPartKey(*loaded_, *placed_, resolved_) + base::keyText(voxelMm), slot("voxels"),
      [&] { return modes::partVoxels(*placed_, voxelMm, ctx); });
}

double ItemStages::fileUnitMm() const {
  return unitMm(*loaded_, resolved_.choices);
}

void ItemStages::makeRegions(std::shared_ptr<const geometry::TriangleMesh> whole) {
  if (!hasRegions(resolved_))
    return;
  regions_ = context_.cachedOrMade<RegionStage>(
      keyOf(Stage::Layers) + seamRegionsKey(resolved_), slot("regions"), [&] {
        return regionStage(*placed_, std::move(whole), *loaded_->mesh, resolved_, fileUnitMm(),
                           context_.span(Stage::Decompose).quiet());
      });
}

ItemOutcome ItemStages::decompose() {
  // Modes on a ground find no order or pieces, but the volume that the ground occupies.
  const bool isOnGround = mode_.result == project::ResultKind::OnGround;
  if (!isOnGround)
    makeRegions(placed_->part);
  decomposed_ =
      context_.cachedOrMade<modes::DecomposeStage>(keyOf(Stage::Decompose), slot({}), [&] {
        // Modes know no part above the plate; with given paths only the platform is used.
        const auto placed = shaped().ground ? onPlate(*placed_) : withoutLayeredRegions();
        modes::DecomposeInput in{*placed, [&](double voxelMm, const base::RunContext& ctx) {
                                   return placed != placed_
                                              ? modes::partVoxels(*placed, voxelMm, ctx)
                                              : voxels(voxelMm, ctx);
                                 }};
        if (regions_)
          in.supports = &regions_->supports;
        if (context_.observers().onPreview)
          in.onPreview = [&](std::shared_ptr<const curved::Decomposition> soFar) {
            context_.observers().onPreview(std::move(soFar), result_);
          };
        if (context_.isTrial())
          in.isRejected = [&](const plan::Findings& soFar) {
            return context_.reject(Stage::Decompose, soFar);
          };
        auto made = mode_.decompose(resolved_.modeChoices(), in, context_.span(Stage::Decompose));
        return hasGivenPaths_
                   ? onlyGround(*made,
                                shaped().ground
                                    ? placedGround(shaped(), resolved_.choices.item().placement)
                                    : nullptr)
                   : made;
      });
  item().platform = decomposed_->platform;
  item().result = decomposed_->result;
  if (isOnGround) {
    const auto* reduced = std::get_if<project::ReducedPlatform>(&decomposed_->result);
    makeRegions(reduced && reduced->part ? reduced->part : placed_->part);
  }
  report().decomposition = decomposed_->report;
  report().decomposition.mode = resolved_.choices.item().mode;
  return {decomposeFindings(), decomposed_->timings};
}

// Returns the findings with the overhangs of sliced layers that neither columns nor inserts carry;
// the layers report columns that have no base. Here and not in the mode, so that its pieces are not
// searched again for other supports.
plan::Findings ItemStages::decomposeFindings() const {
  plan::Findings findings = decomposed_->findings;
  const auto* pieces = std::get_if<project::Pieces>(&decomposed_->result);
  if (hasGivenPaths_ || !pieces || !*pieces || (!asksForSupports(resolved_) && inserts().empty()) ||
      hasLayerPlanes(mode_, resolved_))
    return findings;
  const auto own = std::ranges::stable_partition(
      findings, [](const plan::Finding& f) { return !isOverhangOfSlices(f); });
  const bool areFlat = mode_.id == modes::findMode("flat").id;
  const plan::Findings open = planar::openOverhangFindings(
      (*pieces)->pieces, modes::riskRule(resolved_.modeChoices()),
      areFlat ? planar::Overhangs::Flat : planar::Overhangs::Pieces,
      layers::SupportRules(regions_ ? regions_->supports.places
                                    : std::vector<layers::SupportPlace>(),
                           support::supportRule(resolved_.values)));
  findings.erase(own.begin(), own.end());
  append(findings, open);
  return findings;
}

ItemOutcome ItemStages::layers() {
  const auto stage = context_.cachedOrMade<modes::LayersStage>(keyOf(Stage::Layers), slot({}), [&] {
    if (hasGivenPaths_)
      return layersOfGiven(*loaded_->toolPaths);
    const base::RunContext span = context_.span(Stage::Layers);
    const geometry::TriangleMesh& printed = item().printed();
    const geometry::TriangleMesh& rest =
        regions_ && !regions_->layered.empty() ? *regions_->rest : printed;
    auto made = mode_.layers(resolved_.modeChoices(), *decomposed_,
                             {rest, regions_ ? regions_->supports : layers::SupportPlaces()},
                             span.sub(0.0, 0.9));
    made = withWalledSupport(std::move(made), printed);
    if (regions_)
      made = withRegionLayers(std::move(made), *regions_, resolved_, span.sub(0.9, 0.95));
    made = withTools(std::move(made), resolved_.tools);
    made = withSteps(std::move(made), printed, span.sub(0.95, 1.0).quiet());
    if (mode_.id == modes::findMode("flat").id && !(regions_ && !regions_->layered.empty()))
      made = withStaircase(std::move(made), printed, span.quiet());
    return regions_ ? dividedByRegions(std::move(made), *regions_, printed, resolved_, span.quiet())
                    : made;
  });
  item().layers = stage->layers;
  report().layers = stage->report;
  const std::vector<project::Region>& regions = resolved_.choices.item().regions;
  for (std::size_t i = 0; i < report().layers.regions.size() && i < regions.size(); ++i)
    if (!regions[i].name.empty())
      report().layers.regions[i].region = regions[i].name;
  report().decomposition.supportVolumeMm3 =
      decomposed_->report.supportVolumeMm3 + stage->supportVolumeMm3;
  plan::Findings findings = stage->findings;
  if (!hasGivenPaths_ && asksForSupports(resolved_) && hasLayerPlanes(mode_, resolved_))
    findings.push_back(plan::makeFinding(plan::FindingKind::PlanesWithoutSupports, {}));
  return {std::move(findings), stage->timings};
}

// Returns the placed part without the solids of regions that have layers of their own.
std::shared_ptr<const modes::LoadStage> ItemStages::withoutLayeredRegions() const {
  if (!regions_ || regions_->layered.empty())
    return placed_;
  auto rest = std::make_shared<modes::LoadStage>(*placed_);
  rest->part = regions_->rest;
  rest->voxels = nullptr;
  return rest;
}

toolpath::ItemLayers ItemStages::forToolpaths() const {
  toolpath::ItemLayers all{
      result_.job.item(index_).layers, coverRules(resolved_, regions_ ? regions_->load : nullptr),
      regions_ ? regions_->seams : nullptr, regions_ ? regions_->blockers : nullptr};
  if (hasGivenPaths_)
    all.options().spiral = false; // it is not covered
  return all;
}

} // namespace voluta::pipeline
