#include "pipeline/item_regions.h"

#include "base/error.h"
#include "base/key_text.h"
#include "base/stopwatch.h"
#include "geometry/formats/threemf_parts.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "layers/layer_checks.h"
#include "layers/layer_stack.h"
#include "layers/tool_assignment.h"
#include "modes/level_choices.h"
#include "modes/mode.h"
#include "modes/mode_table.h"
#include "modes/platform_body.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "regions/region_figures.h"
#include "regions/region_kinds.h"
#include "regions/region_patches.h"
#include "regions/region_uses.h"
#include "support/supports.h"
#include "toolpath/infill/infill.h"
#include "toolpath/infill/strand_text.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

namespace voluta::pipeline {

namespace {
using project::Region;

constexpr double kOnPlateMm = 1e-3;
// Settings that say something about places, and by which patches are not divided.
constexpr std::array<std::string_view, 2> kMarks{"supports", "seamHere"};

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

// Returns shapes and uses of all regions in their order, names of inserts, and the sizes of layers
// that their bodies follow; settings are not among them.
std::string shapesKey(const Resolved& resolved) {
  std::string key;
  for (const Region& region : regionsOf(resolved)) {
    Region shape = region;
    shape.parameters.clear();
    key += "region " + keyOf(shape);
    if (regions::findUse(region.use).isInsert) // the pause says its name
      key += base::keyText(region.name);
  }
  const substrate::LevelOptions levels = modes::levelOptions(resolved.modeChoices());
  return key + base::keyText(levels.layerHeightMm, levels.heightMinMm, levels.heightMaxMm,
                             levels.beadWidthMm);
}

// Returns the tool that a region states; nullopt: that of the part. Throws Error{Usage} if the job
// has no such tool, or it cannot print the layers of the part.
std::optional<int> toolOf(const Resolved& resolved, const Region& region) {
  const auto stated = region.parameters.find("tool");
  if (stated == region.parameters.end())
    return std::nullopt;
  base::ParameterValues values = resolved.values;
  values.set("tool", stated->second);
  const int tool = layers::toolAssignment(values, resolved.tooling.tools().size()).part;
  requirePrints(resolved.tooling, tool, resolved.process().layerHeightMm);
  return tool;
}

// Returns how a region is covered: by its own settings, with the layers of its item.
toolpath::CoverRules rulesOf(const Resolved& item, const Region* region) {
  base::ParameterValues values = item.values;
  int interior = item.tools.infill, whole = item.tools.part;
  if (region) {
    for (const auto& [key, value] : region->parameters)
      values.set(key, value);
    // A skin or jacket is solid unless it is asked not to be.
    const regions::RegionLayers layers = regions::findUse(region->use).layers;
    if ((layers == regions::RegionLayers::Surface || layers == regions::RegionLayers::Around) &&
        !region->parameters.contains("infillDensity"))
      values.set("infillDensity", "1");
    const layers::ToolAssignment tools =
        layers::toolAssignment(values, item.tooling.tools().size());
    interior = tools.infill;
    whole = tools.part;
    for (const int tool : {whole, interior})
      requirePrints(item.tooling, tool, item.process().layerHeightMm);
  }
  toolpath::ToolpathOptions options = toolpathOptionsOf(values, item.process());
  if (interior != whole)
    options.infillTool = interior;
  // Only layers around an axis have one to wind around.
  if (region && regions::findUse(region->use).hasLayers() &&
      !region->parameters.contains("infill") && toolpath::infillKind(options.infill).needsChart)
    options.infill = toolpath::ToolpathOptions().infill;
  return {std::move(options), item.tooling};
}

// Returns the field that the infill follows; none for other infills.
toolpath::StrandDyads strandsFor(const toolpath::ToolpathOptions& options,
                                 const std::shared_ptr<const ItemLoad>& load) {
  if (options.infill != toolpath::kFieldInfill)
    return {};
  if (!options.infillField.empty())
    return toolpath::strandsOf(options.infillField);
  if (load)
    return [load](const Eigen::Vector3d& place) { return load->principal.dyadsAt(place); };
  return {};
}

double interlockMm(const Resolved& resolved, const Region& region) {
  base::ParameterValues values = resolved.values;
  if (const auto own = region.parameters.find("interlockMm"); own != region.parameters.end())
    values.set(own->first, own->second);
  return values.number("interlockMm");
}

bool isMark(std::string_view key) {
  return std::ranges::find(kMarks, key) != kMarks.end();
}
bool hasMarks(const Region& region) {
  return std::ranges::any_of(region.parameters,
                             [](const auto& setting) { return isMark(setting.first); });
}
// Returns whether a region with the layers of its item has only marks.
bool onlyMarks(const Region& region) {
  return !region.parameters.empty() &&
         std::ranges::all_of(region.parameters,
                             [](const auto& setting) { return isMark(setting.first); });
}

// Returns the region with a painted surface at least as deep as a bead is wide: overhangs and walls
// are that far from the surface.
Region withDepthOfMarks(const Region& region, double beadWidthMm) {
  const regions::Shape shape = regions::parsedShape(region.shape);
  Region deep = region;
  if (shape.kind->mesh == regions::ShapeMesh::Painted && shape.numbers[0] < beadWidthMm)
    deep.shape = fmt::format("{}:{}", shape.kind->word, beadWidthMm);
  return deep;
}

// Adds what a region says about supports and seams.
void addMarks(const Resolved& resolved, const Region& region, const geometry::TriangleMesh& body,
              RegionStage& stage, std::vector<toolpath::SeamPlaceBody>& seams) {
  base::ParameterValues values = resolved.values;
  for (const auto& [key, value] : region.parameters)
    values.set(key, value);
  if (region.parameters.contains("supports"))
    stage.supports.places.push_back({support::supportRule(values), body});
  const std::string seam = values.text("seamHere");
  if (region.parameters.contains("seamHere"))
    seams.push_back({seam == "always"  ? toolpath::SeamRule::Always
                     : seam == "never" ? toolpath::SeamRule::Never
                                       : toolpath::SeamRule::Auto,
                     body});
}

// Adds what is put in at a region. It carries what is up to a layer above it.
void addInsert(const Region& region, geometry::TriangleMesh body, double layerMm,
               RegionStage& stage) {
  for (const double share : {0.0, 0.5, 1.0}) {
    geometry::TriangleMesh raised = body;
    for (Eigen::Vector3d& vertex : raised.vertices)
      vertex.z() += share * layerMm;
    stage.supports.places.push_back({layers::SupportRule::Carried, std::move(raised)});
  }
  stage.supports.printedLater.push_back(body);
  stage.inserts.push_back(
      {region.name, region.shape, regions::layerOf(region.use), std::move(body)});
}

bool isOnGround(const Resolved& resolved) {
  return modes::findMode(resolved.choices.item().mode).result == project::ResultKind::OnGround;
}

// Throws Error{UnusableInput} if a part that stands on a plate lost what it stands on.
void requireFoot(const geometry::TriangleMesh& left, const geometry::TriangleMesh& whole,
                 const Resolved& resolved) {
  const double floatsMm = geometry::bounds(left).min().z() - geometry::bounds(whole).min().z();
  if (floatsMm > kOnPlateMm && !isOnGround(resolved))
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("regions take away what the part stands on: the rest of it "
                                    "begins {gap:.3g} above its place"_text,
                                    base::mm(floatsMm)),
                      {}, "make the regions smaller, or move them up"_text);
}

// Layers of regions are not corrected for the sizes of the machine, by which the part is judged.
void requireNoCorrection(const process::Process& p) {
  if (p.scaleX != 1.0 || p.scaleY != 1.0 || p.outlineOffsetMm != 0.0 || p.holeOffsetMm != 0.0)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("process {process} corrects sizes: layers of regions have no "
                                    "corrections"_text,
                                    p.id),
                      {}, "choose a process without corrections, or remove the regions"_text);
}
} // namespace

bool hasRegions(const Resolved& resolved) {
  return !regionsOf(resolved).empty();
}

std::shared_ptr<const ItemLoad> loadOf(const modes::LoadStage& placed,
                                       const geometry::TriangleMesh& file, const Resolved& resolved,
                                       double unitMm, const base::RunContext& ctx) {
  const regions::PlacedPart part = placedPart(placed, *placed.part, file, unitMm);
  const substrate::LevelOptions levels = modes::levelOptions(resolved.modeChoices());
  std::vector<geometry::TriangleMesh> bodies;
  for (const Region& region : regionsOf(resolved))
    bodies.push_back(regions::findUse(region.use).load == regions::RegionLoad::None
                         ? geometry::TriangleMesh()
                         : regions::bodyOf(region, part, levels, ctx));
  return itemLoad(*placed.part, regionsOf(resolved), bodies, part.work_T_file.linear(), ctx);
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
  requireFoot(*cut->part, *stage->part, resolved);
  cut->voxels = nullptr;
  project::ModelReport report = modelReport(*cut->part);
  report.scale = cut->report.scale;
  report.repairs = cut->report.repairs;
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
  stage->whole = stage->rest = whole;
  if (any(resolved, &regions::RegionUse::hasLayers)) {
    requireNoCorrection(resolved.process());
    regions::PartRegions made = regions::divided(part, all, levels, ctx);
    stage->layered = std::move(made.layered);
    if (!stage->layered.empty())
      stage->rest = std::make_shared<geometry::TriangleMesh>(std::move(made.rest));
    requireFoot(*stage->rest, *whole, resolved);
  }
  std::vector<toolpath::SeamPlaceBody> seams;
  for (const regions::LayeredRegion& region : stage->layered)
    stage->supports.printedLater.push_back(region.solid);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const regions::RegionUse& use = regions::findUse(all[i].use);
    stage->bodies.emplace_back();
    geometry::TriangleMesh marked;
    if (hasMarks(all[i]) && !use.cuts) {
      marked = regions::bodyOf(withDepthOfMarks(all[i], resolved.process().beadWidthMm), part,
                               levels, ctx);
      if (!marked.empty())
        addMarks(resolved, all[i], marked, *stage, seams);
    }
    const auto layered = std::ranges::find(stage->layered, i, &regions::LayeredRegion::index);
    bool isInPart = layered != stage->layered.end();
    if (use.cuts) { // The part ends at the body.
      geometry::TriangleMesh body = regions::bodyOf(all[i], part, levels, ctx);
      isInPart = !body.empty() && geometry::touch(*whole, body);
      if (use.isInsert && isInPart)
        addInsert(all[i], std::move(body), resolved.process().layerHeightMm, *stage);
    } else if (!use.hasLayers()) {
      if (!onlyMarks(all[i]))
        stage->bodies.back() = regions::bodyOf(all[i], part, levels, ctx);
      const geometry::TriangleMesh& body = onlyMarks(all[i]) ? marked : stage->bodies.back();
      if (!body.empty()) {
        const auto shared =
            geometry::meshBoolean(geometry::BooleanOperation::Intersection, *whole, body, false);
        isInPart = !shared || !shared->empty();
      }
    }
    stage->isOutside.push_back(!isInPart);
    if (!isInPart)
      stage->findings.push_back(
          plan::makeFinding(plan::FindingKind::RegionOutside, {{"region", all[i].shape}}));
  }
  stage->load = itemLoad(*whole, all, stage->bodies, part.work_T_file.linear(), ctx);
  auto rules = std::make_shared<const layers::SupportRules>(stage->supports.places,
                                                            layers::SupportRule::Auto);
  if (rules->has(layers::SupportRule::None) || rules->has(layers::SupportRule::Carried))
    stage->blockers = std::move(rules);
  if (!seams.empty())
    stage->seams = std::make_shared<const toolpath::SeamPlaces>(seams);
  return stage;
}

std::shared_ptr<const modes::LayersStage>
withRegionLayers(std::shared_ptr<const modes::LayersStage> stage, const RegionStage& regions,
                 const Resolved& resolved, const base::RunContext& ctx) {
  if (!stage->layers || regions.layered.empty())
    return stage;
  const base::Stopwatch watch;
  const substrate::LevelOptions levels = modes::levelOptions(resolved.modeChoices());
  auto made = std::make_shared<modes::LayersStage>(*stage);
  layers::LayerStack stack = *stage->layers;
  for (const regions::LayeredRegion& region : regions.layered) {
    substrate::StackedLevels own = regions::layersOf(regionsOf(resolved)[region.index], region,
                                                     {*regions.whole, *regions.rest}, levels, ctx);
    for (layers::Patch& patch : own.stack.patches) {
      patch.layer += stack.layerCount;
      patch.region = static_cast<int>(region.index) + 1;
      patch.group = layers::kRegionGroups + static_cast<int>(region.index);
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

namespace {
plan::Finding withoutEffect(const Region& region, base::Message reason, base::Message help) {
  return plan::makeFinding(
      plan::FindingKind::RegionWithoutEffect,
      {{"region", region.shape}, {"reason", std::move(reason)}, {"help", std::move(help)}});
}

// Returns the finding about a region within the part whose settings or layers have no effect.
std::optional<plan::Finding> withoutEffect(const Region& region, std::size_t patches,
                                           const regions::LayersMet* met,
                                           const Resolved& resolved) {
  if (met && met->crossed > 0)
    return withoutEffect(region,
                         base::message("its interlock of {width} reaches through it in {crossed} "
                                       "of {layers} layers"_text,
                                       base::mm(interlockMm(resolved, region)), met->crossed,
                                       met->layers),
                         "set a smaller `interlockMm`, or make the region larger"_text);
  if (patches > 0)
    return std::nullopt;
  if (met && met->narrow > 0)
    return withoutEffect(region,
                         base::message("it is narrower than half a bead of {width}"_text,
                                       base::mm(resolved.process().beadWidthMm)),
                         "make it wider, or use a finer nozzle"_text);
  if (met && met->layers > 0)
    return withoutEffect(region, "later regions hold in all of it"_text,
                         "move it down the list of regions"_text);
  return withoutEffect(region,
                       met ? base::Message("it is too thin to meet a layer"_text)
                           : base::Message("it is too thin for a layer of its own"_text),
                       "make it larger, or the layers thinner"_text);
}

// `dividing` and how they meet the layers: of the regions with settings.
plan::Findings regionsWithoutEffect(const RegionStage& stage,
                                    std::span<const regions::SettingsRegion> dividing,
                                    std::span<const regions::LayersMet> met,
                                    std::span<const plan::RegionStatistics> figures,
                                    const Resolved& resolved) {
  std::vector<const regions::LayersMet*> metBy(figures.size(), nullptr);
  std::vector<bool> isTold = stage.isOutside; // or has neither settings nor layers
  for (std::size_t i = 0; i < isTold.size(); ++i)
    isTold[i] = isTold[i] || std::ranges::find(stage.layered, i, &regions::LayeredRegion::index) ==
                                 stage.layered.end();
  for (std::size_t d = 0; d < dividing.size(); ++d) {
    const auto i = static_cast<std::size_t>(dividing[d].number) - 1;
    metBy[i] = &met[d];
    isTold[i] = stage.isOutside[i];
  }
  plan::Findings findings;
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (!isTold[i])
      if (auto finding =
              withoutEffect(regionsOf(resolved)[i], figures[i].patches, metBy[i], resolved))
        findings.push_back(std::move(*finding));
  return findings;
}
} // namespace

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
    if (!regions.bodies[i].empty() && regions::findUse(all[i].use).hasSettings())
      dividing.push_back(
          {static_cast<int>(i) + 1, regions.bodies[i], interlockMm(resolved, all[i])});
  auto made = std::make_shared<modes::LayersStage>(*stage);
  regions::DividedLayers divided =
      dividing.empty()
          ? regions::DividedLayers{*stage->layers, {}}
          : regions::dividedPatches(*stage->layers, dividing, resolved.process().beadWidthMm, ctx);
  layers::LayerStack& stack = divided.stack;
  std::vector<std::optional<int>> tools{std::nullopt};
  for (const Region& region : all)
    tools.push_back(toolOf(resolved, region));
  for (layers::Patch& patch : stack.patches)
    patch.tool = tools[static_cast<std::size_t>(patch.region)].value_or(patch.tool);
  std::vector<geometry::TriangleMesh> places = regions.bodies;
  for (const regions::LayeredRegion& region : regions.layered)
    places[region.index] = region.solid;
  std::ranges::copy(regions.findings, std::back_inserter(made->findings));
  made->report.patches = stack.patches.size();
  made->report.regions = regions::figuresOf(*stage->layers, stack, part, all, places, ctx);
  std::ranges::move(
      regionsWithoutEffect(regions, dividing, divided.met, made->report.regions, resolved),
      std::back_inserter(made->findings));
  made->layers = layers::kept(std::move(stack));
  made->timings.extract += watch.seconds();
  return made;
}

std::vector<toolpath::CoverRules> coverRules(const Resolved& resolved,
                                             const std::shared_ptr<const ItemLoad>& load) {
  std::vector<toolpath::CoverRules> rules{rulesOf(resolved, nullptr)};
  for (const Region& region : regionsOf(resolved))
    rules.push_back(rulesOf(resolved, &region));
  for (toolpath::CoverRules& rule : rules)
    rule.options.strands = strandsFor(rule.options, load);
  return rules;
}

plan::Findings unusedFields(const Resolved& resolved) {
  const auto follows = [](const toolpath::ToolpathOptions& options) {
    return options.infill == toolpath::kFieldInfill;
  };
  const auto unused = [](base::Message reason) {
    return plan::makeFinding(plan::FindingKind::SettingWithoutEffect,
                             {{"key", "infillField"_name},
                              {"reason", std::move(reason)},
                              {"help", "set `infill=field`, or remove the field"_text}});
  };
  const toolpath::ToolpathOptions ofPart = rulesOf(resolved, nullptr).options;
  bool isFollowed = follows(ofPart);
  plan::Findings findings;
  for (const Region& region : regionsOf(resolved)) {
    if (!regions::findUse(region.use).hasSettings())
      continue;
    const toolpath::ToolpathOptions options = rulesOf(resolved, &region).options;
    const bool hasOwn = region.parameters.contains("infillField");
    isFollowed = isFollowed || (follows(options) && !hasOwn);
    if (hasOwn && !options.infillField.empty() && !follows(options))
      findings.push_back(unused(
          base::message("the infill of region {region} is not along a field"_text, region.shape)));
  }
  if (!ofPart.infillField.empty() && !isFollowed)
    findings.push_back(unused("the infill is not along a field"_text));
  return findings;
}

void requireField(const Resolved& resolved) {
  const std::vector<Region>& all = regionsOf(resolved);
  const auto check = [&](const toolpath::ToolpathOptions& options) {
    if (!options.infillField.empty())
      static_cast<void>(toolpath::strandsOf(options.infillField));
    else if (options.infill == toolpath::kFieldInfill && !isPushed(all))
      throw base::Error(base::ErrorCode::Usage,
                        "there is no field of directions for the infill"_text, "infillField"_name,
                        "give a direction x,y,z or samples x,y,z,dx,dy,dz, or the part regions "
                        "that hold it and regions with a force"_text);
  };
  check(rulesOf(resolved, nullptr).options);
  for (const Region& region : all)
    if (regions::findUse(region.use).hasSettings())
      check(rulesOf(resolved, &region).options);
}

namespace {
// Returns what the figures of a part under its forces depend on beside its beads.
std::string loadedMaterialsKey(const Resolved& resolved) {
  std::string key;
  if (!any(resolved,
           [](const regions::RegionUse& use) { return use.load == regions::RegionLoad::Force; }))
    return key;
  for (const process::Tool& tool : resolved.tooling.tools()) {
    const process::Elasticity e =
        tool.process.material.elasticity.value_or(process::Elasticity{0.0, 0.0, 0.0, 0.0});
    const process::Tape tape = tool.process.tape.value_or(process::Tape());
    key += base::keyText(e.alongMPa, e.acrossMPa, e.shearMPa, e.poisson, tape.fibreMPa,
                         tape.fibreShare);
  }
  return key;
}
} // namespace

std::string cutRegionsKey(const Resolved& resolved) {
  return any(resolved, &regions::RegionUse::cuts) ? shapesKey(resolved) : std::string();
}

std::string loadRegionsKey(const Resolved& resolved) {
  return resolved.values.text("orient") == "leastTension" ? shapesKey(resolved) : std::string();
}

std::string layeredRegionsKey(const Resolved& resolved) {
  return any(resolved, &regions::RegionUse::hasLayers) ? shapesKey(resolved) : std::string();
}

std::string supportRegionsKey(const Resolved& resolved) {
  std::string rules;
  for (const Region& region : regionsOf(resolved)) {
    const auto own = region.parameters.find("supports");
    rules += own == region.parameters.end() ? "-" : " " + own->second;
  }
  return rules.find(' ') == std::string::npos ? std::string()
                                              : shapesKey(resolved) + "supports " + rules + "\n";
}

std::string regionLayersKey(const Resolved& resolved) {
  if (!hasRegions(resolved))
    return {};
  std::string key = shapesKey(resolved) + supportRegionsKey(resolved);
  for (const Region& region : regionsOf(resolved))
    key +=
        base::keyText(toolOf(resolved, region).value_or(-1)) + (onlyMarks(region) ? "marks\n" : "");
  const std::vector<Region>& all = regionsOf(resolved);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (const double mm = interlockMm(resolved, all[i]); mm > 0.0)
      key += "interlock " + base::keyText(i, mm);
  return key;
}

std::string seamRegionsKey(const Resolved& resolved) {
  std::string key;
  for (const Region& region : regionsOf(resolved)) {
    const auto own = region.parameters.find("seamHere");
    key += own == region.parameters.end() ? "-" : " " + own->second;
  }
  return key;
}

std::string regionRulesKey(const Resolved& resolved) {
  std::string key = loadedMaterialsKey(resolved);
  for (const Region& region : regionsOf(resolved))
    key += "region " + toolpath::optionsKey(rulesOf(resolved, &region).options);
  return key;
}

} // namespace voluta::pipeline
