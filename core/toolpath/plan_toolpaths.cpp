#include "toolpath/plan_toolpaths.h"

#include "collision/growing_part.h"
#include "toolpath/brim.h"
#include "toolpath/feature_speeds.h"
#include "toolpath/first_layer.h"
#include "toolpath/idle_waypoints.h"
#include "toolpath/prime_path.h"
#include "toolpath/slow_overhangs.h"
#include "toolpath/slow_to_cool.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/stopwatch.h"
#include "layers/support_rules.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "toolpath/coverage/bead_scale.h"
#include "toolpath/fibre/add_tapes.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/nozzle_directions.h"
#include "toolpath/order/assemble.h"
#include "toolpath/order/order_to_cool.h"
#include "toolpath/order/seam.h"
#include "toolpath/order/spiral.h"
#include "toolpath/path_figures.h"
#include "toolpath/sparse/cover_layers.h"
#include "toolpath/stitching/add_shots.h"
#include "toolpath/unsupported/passes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

constexpr double kCoverShare = 0.6; // of the stage's progress
// Straight beads: of the chord tolerance of curves; a length over which no joint turns far
constexpr double kIdleChords = 0.25, kLongestMm = 10.0;

// Puts the brim before all other paths, and the prime before the brim.
void addWaste(Assembled& assembled, const layers::LayerStack& stack, const robot::Cell& cell,
              const process::Tooling& tooling, const ToolpathOptions& options,
              std::span<const Vector3d> others, plan::Findings& findings) {
  plan::ToolPlan& plan = assembled.plan;
  const std::size_t before = plan.waypointCount();
  if (auto cut = addBrim(plan, stack, tooling, options))
    findings.push_back(std::move(*cut));
  if (auto falls = addPrimePath(plan, cell, tooling, options, others))
    findings.push_back(std::move(*falls));
  assembled.clearDirection.insert(assembled.clearDirection.begin(), plan.waypointCount() - before,
                                  Vector3d::UnitZ());
}

// Returns the finding about skins that no infill carries.
std::optional<plan::Finding> hollowSkin(const std::vector<PatchCover>& covers) {
  std::size_t paths = 0;
  std::optional<Vector3d> first;
  for (const PatchCover& cover : covers)
    if (cover.overSparse > 0) {
      paths += cover.overSparse;
      first = first.value_or(cover.firstOverSparse);
    }
  if (!first)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::HollowSkin, {{"paths", paths}}, *first, paths);
}

// Returns the finding about sparse infill that fills another share of the interior than asked.
std::optional<plan::Finding> sparseShare(const LayerCovers& made) {
  constexpr double kApart = 0.03;
  if (made.sparseMm3 <= 0.0)
    return std::nullopt;
  const double found = made.sparseBeadMm3 / made.sparseMm3,
               asked = made.sparseAskedMm3 / made.sparseMm3;
  if (asked <= 0.0 || std::abs(found - asked) <= kApart)
    return std::nullopt;
  const base::Text reason =
      found > asked ? "its lines branch below skins that would sag between them"_text
                    : "the interior is too small for its lines, or they cannot lie any closer"_text;
  return plan::makeFinding(plan::FindingKind::SparseShare, {{"found", base::percent(100.0 * found)},
                                                            {"asked", base::percent(100.0 * asked)},
                                                            {"reason", base::Message(reason)}});
}

// Returns the finding about walls that are narrower than the narrowest bead.
std::optional<plan::Finding> thinWalls(const layers::LayerStack& stack,
                                       const std::vector<PatchCover>& covers,
                                       const process::Tooling& tooling, bool leftOut) {
  double lengthMm = 0.0, beadMm = 0.0;
  std::optional<ThinWall> thinnest;
  for (std::size_t i = 0; i < covers.size(); ++i)
    for (const ThinWall& wall : covers[i].thinWalls) {
      lengthMm += wall.lengthMm;
      if (thinnest && thinnest->widthMm <= wall.widthMm)
        continue;
      thinnest = wall;
      beadMm = tooling.at(stack.patches[i].tool).process.beadWidthMinMm;
    }
  if (!thinnest)
    return std::nullopt;
  return plan::makeFinding(leftOut ? plan::FindingKind::ThinWallsLeftOut
                                   : plan::FindingKind::ThinWallsWidened,
                           {{"length", base::mm(lengthMm)},
                            {"width", base::mm(thinnest->widthMm)},
                            {"bead", base::mm(beadMm)}},
                           thinnest->place);
}

// Returns the finding about patches to which a field of the infill is perpendicular.
std::optional<plan::Finding> fieldAcross(const layers::LayerStack& stack,
                                         const std::vector<PatchCover>& covers) {
  const auto first = std::ranges::find_if(covers, &PatchCover::lacksField);
  if (first == covers.end())
    return std::nullopt;
  const auto patches =
      static_cast<std::size_t>(std::ranges::count_if(covers, &PatchCover::lacksField));
  return plan::makeFinding(
      plan::FindingKind::SettingWithoutEffect,
      {{"key", "infill=field"_name},
       {"reason",
        base::message("the field is perpendicular to {patches} patch of the layers, "
                      "filled with straight lines|the field is perpendicular to "
                      "{patches} patches of the layers, filled with straight lines"_plural,
                      patches)},
       {"help", base::Message("turn the part, or choose another field or infill"_text)}},
      stack.patches[static_cast<std::size_t>(first - covers.begin())].surface.vertices.front(),
      patches);
}

plan::Findings coverFindings(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                             const process::Tooling& tooling, const ToolpathOptions& options) {
  plan::Findings findings;
  if (auto thin = thinWalls(stack, covers, tooling, options.thinWalls == "omit"))
    findings.push_back(std::move(*thin));
  if (auto across = fieldAcross(stack, covers))
    findings.push_back(std::move(*across));
  if (options.infillDensity <= 0.0)
    if (auto hollow = hollowSkin(covers))
      findings.push_back(std::move(*hollow));
  return findings;
}

// Adds the figures of the covers. Returns the finding about patches without a bead.
std::optional<plan::Finding> addCoverFigures(const layers::LayerStack& stack,
                                             const std::vector<PatchCover>& covers,
                                             plan::ToolpathStatistics& s) {
  double area = 0.0, covered = 0.0, overlap = 0.0, bareMm3 = 0.0;
  std::size_t bare = 0, firstBare = 0;
  for (std::size_t i = 0; i < covers.size(); ++i) {
    const PatchCover& c = covers[i];
    area += c.areaMm2;
    covered += c.coveredMm2;
    overlap += c.overlapMm2;
    s.layerVolumeMm3 += c.volumeMm3;
    s.simpleRegions += c.simple ? 1 : 0;
    if (c.beads.empty() && c.areaMm2 > 0) {
      firstBare = bare == 0 ? i : firstBare;
      ++bare;
      bareMm3 += c.volumeMm3;
    }
  }
  s.coveredFraction = area > 0 ? covered / area : 0.0;
  s.overlapFraction = area > 0 ? overlap / area : 0.0;
  if (bare == 0)
    return std::nullopt;
  plan::Finding f = plan::makeFinding(plan::FindingKind::PatchWithoutBead, {},
                                      stack.patches[firstBare].surface.vertices.front(), bare);
  f.blocking = bareMm3 > plan::kBlockingShare * s.layerVolumeMm3;
  return f;
}

// Covers the layers of several items and puts the covers in the order of the joined stack.
LayerCovers coverItems(std::span<const ItemLayers> items, const layers::LayerStack& joined,
                       double share, const base::RunContext& ctx) {
  LayerCovers all;
  std::vector<LayerCovers> own;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double count = static_cast<double>(items.size()), at = static_cast<double>(i);
    const base::RunContext span = ctx.sub(share * at / count, share * (at + 1.0) / count);
    own.push_back(items[i].stack->patches.empty()
                      ? LayerCovers{}
                      : coverLayers(*items[i].stack, items[i].rules, 1.0, span));
    all.fill.push_back(own.back().fill.empty() ? plan::FillIntent{} : own.back().fill.front());
    all.sparseMm3 += own.back().sparseMm3;
    all.sparseBeadMm3 += own.back().sparseBeadMm3;
  }
  std::vector<std::size_t> next(items.size());
  for (const layers::Patch& patch : joined.patches) {
    const auto item = static_cast<std::size_t>(patch.item);
    all.covers.push_back(std::move(own[item].covers[next[item]++]));
  }
  return all;
}

SeamsOfItems seamsOf(std::span<const ItemLayers> items) {
  SeamsOfItems seams;
  for (const ItemLayers& item : items)
    seams.push_back(item.seams);
  return seams;
}

// Returns whether a region of a path's item blocks supports at a place; null if no region does.
decltype(PassScene::isBlocked) blockedBy(std::span<const ItemLayers> items,
                                         const layers::LayerStack& stack) {
  if (std::ranges::none_of(items, [](const ItemLayers& item) { return item.blockers != nullptr; }))
    return nullptr;
  return [items, &stack](const plan::ToolPath& path, const Vector3d& at) {
    if (path.patch < 0)
      return false;
    const layers::Patch& patch = stack.patches[static_cast<std::size_t>(path.patch)];
    const auto& blockers = items[static_cast<std::size_t>(patch.item)].blockers;
    return blockers && !layers::wantsColumns(blockers->at(at));
  };
}

// Applies the factors of items and regions.
void scaleByRegion(plan::ToolPlan& plan, std::span<const ItemLayers> items,
                   const layers::LayerStack& stack, const process::Tooling& tooling,
                   const std::vector<char>& unsupported) {
  scaleSpeeds(
      plan, tooling,
      [&](const plan::ToolPath& path) {
        if (path.patch < 0)
          return 1.0;
        const layers::Patch& patch = stack.patches[static_cast<std::size_t>(path.patch)];
        return items[static_cast<std::size_t>(patch.item)]
            .rules.at(static_cast<std::size_t>(patch.region))
            .options.speedFactor;
      },
      unsupported);
}

// Completes the plan of the items, whose layers are covered.
ToolpathResult planCovered(LayerCovers made, std::span<const ItemLayers> items,
                           const layers::LayerStack& stack, const robot::Cell& cell,
                           const process::Tooling& tooling, const ToolpathOptions& options,
                           std::span<const Vector3d> others, base::Stopwatch watch,
                           const base::RunContext& ctx) {
  ToolpathResult r;
  const base::RunContext silent = ctx.quiet();
  const std::vector<char> isFirstLayer = firstLayerPatches(stack, options.platform);
  const std::vector<PatchCover>& covers = made.covers;
  if (options.spiral)
    made.fill = keepOuterWalls(stack, options.bottomLayers, options.spiralOuter, made.covers);
  Assembled assembled =
      assemble(stack, covers, tooling,
               {options.seam, options.orderIslands, options.cooling.minLayerTimeS > 0.0,
                options.spiral ? SeamsOfItems() : seamsOf(items)});
  if (options.cooling.minLayerTimeS > 0.0 && !options.spiral) {
    const bool movesSeams =
        seamKind(options.seam).place == nullptr &&
        std::ranges::none_of(items, [](const ItemLayers& item) { return item.seams != nullptr; });
    orderToCool(assembled, movesSeams, options.cooling.minLayerTimeS);
  }
  assembled.plan.fill = made.fill;
  r.findings = coverFindings(stack, covers, tooling, options);
  if (items.size() == 1)
    if (auto share = sparseShare(made))
      r.findings.push_back(std::move(*share));
  if (options.spiral)
    if (auto ends = joinSpiral(assembled, options.bottomLayers))
      r.findings.push_back(std::move(*ends));
  const bool hasBrim = options.brimWidthMm > 0.0;
  // Added here, so that the travel moves of the head account for the prime as for every bead.
  if (!hasBrim)
    addWaste(assembled, stack, cell, tooling, options, others, r.findings);
  const PassScene scene{cell,          tooling,         options.platform,
                        stack.pockets, options.canTilt, blockedBy(items, stack)};
  plan::Findings reported;
  std::shared_ptr<const collision::GrowingPart> grown;
  if (options.rimSupports) {
    PassedPlan passed =
        runUnsupportedPasses(PassPhase::BeforeDirections, assembled.plan,
                             std::move(assembled.clearDirection), nullptr, scene, silent);
    assembled.plan = std::move(passed.beads.plan);
    assembled.clearDirection = std::move(passed.beads.clearDirection);
    grown = std::move(passed.grown);
    r.statistics.rimSupportMm3 = passed.addedMm3;
    reported = std::move(passed.findings);
  }
  // A brim surrounds rim supports as well.
  if (hasBrim) {
    addWaste(assembled, stack, cell, tooling, options, others, r.findings);
    grown.reset();
  }
  r.seconds.toolpath = watch.seconds();

  watch = base::Stopwatch();
  // If a rim support cannot be printed it is dropped; the rim is then unsupported, as without it.
  const auto liesUnderRim = [&](const plan::ToolPath& path) {
    return path.kind == plan::PathKind::Support &&
           stack.patches[static_cast<std::size_t>(path.patch)].group != layers::kSupportGroup;
  };
  OrientResult oriented =
      orientDirections(assembled.plan, assembled.clearDirection, cell, tooling, options,
                       ctx.sub(kCoverShare, 1.0), liesUnderRim, std::move(grown));
  PassedPlan passed = runUnsupportedPasses(PassPhase::AfterDirections, oriented.plan, {},
                                           std::move(oriented.grown), scene, silent);
  r.seconds.orient = watch.seconds();
  r.plan = std::move(passed.beads.plan);
  if (!applyFeatures(r.plan, tooling, isFirstLayer, passed.beads.unsupported))
    r.grown = std::move(passed.grown);
  scaleByRegion(r.plan, items, stack, tooling, passed.beads.unsupported);
  slowOverhangs(r.plan, stack, tooling, silent);
  slowToCool(r.plan, options.cooling);
  if (options.fibre.everyLayers > 0) {
    std::ranges::move(addTapes(r.plan, stack, tooling, options.fibre, r.statistics, silent),
                      std::back_inserter(reported));
    r.grown.reset(); // without the tapes
  }
  if (!stack.pockets.empty()) {
    addShots(r.plan, stack.pockets, tooling, options.stitches);
    r.grown.reset(); // waypoints are numbered anew
  }
  // An arm loses the segment between two waypoints where it has to lift the nozzle, and waypoints
  // at which the head is not clear: those are better close together.
  if (!options.canTilt && oriented.gouges == 0 && r.plan.waypointCount() > 0 &&
      hasOneDirection(r.plan)) {
    const ResampleOptions spacing =
        ResampleOptions().scaled(largeBeadScaleOf(tooling.first().process));
    r.plan = withoutIdleWaypoints(r.plan, kIdleChords * spacing.chordMm, kLongestMm);
    r.grown.reset(); // waypoints are numbered anew
  }
  for (plan::Findings* findings : {&oriented.findings, &passed.findings, &reported})
    std::ranges::move(*findings, std::back_inserter(r.findings));

  r.statistics.sparseMm3 = made.sparseMm3;
  r.statistics.sparseBeadMm3 = made.sparseBeadMm3;
  r.statistics.gouges = oriented.gouges;
  r.statistics.maxRotationDeg = oriented.maxRotationDeg;
  setPathFigures(r.plan, items.size(), tooling, r.statistics);
  if (auto bare = addCoverFigures(stack, covers, r.statistics))
    r.findings.push_back(std::move(*bare));
  return r;
}

// Throws Error{Usage} for a spiral with regions.
std::vector<CoverRules> withSpiral(std::vector<CoverRules> rules, const layers::LayerStack& stack) {
  if (!rules.front().options.spiral)
    return rules;
  if (std::ranges::any_of(stack.patches, [](const layers::Patch& p) { return p.region > 0; }))
    throw base::Error(base::ErrorCode::Usage, "a spiral has no regions"_text, {},
                      "remove the regions, or set spiral to false"_text);
  rules.front().options = spiralOptions(rules.front().options);
  return rules;
}

} // namespace

ToolpathResult planToolpaths(const layers::LayerStack& stack, const robot::Cell& cell,
                             const process::Tooling& tooling, const ToolpathOptions& options,
                             const base::RunContext& ctx) {
  const std::shared_ptr<const layers::LayerStack> borrowed(&stack,
                                                           [](const layers::LayerStack*) {});
  const ItemLayers one{borrowed, {{options, tooling}}};
  return planToolpaths({&one, 1}, stack, cell, tooling, ctx);
}

ToolpathResult planToolpaths(std::span<const ItemLayers> items, const layers::LayerStack& joined,
                             const robot::Cell& cell, const process::Tooling& tooling,
                             const base::RunContext& ctx, std::span<const Vector3d> others) {
  const base::Stopwatch watch;
  if (items.size() == 1) {
    const std::vector<CoverRules> rules = withSpiral(items.front().rules, joined);
    return planCovered(coverLayers(joined, rules, kCoverShare, ctx), items, joined, cell, tooling,
                       rules.front().options, {}, watch, ctx);
  }
  for (const ItemLayers& item : items)
    if (item.options().spiral)
      throw base::Error(base::ErrorCode::Usage, "a spiral is printed alone"_text, {},
                        "remove the other parts, or set spiral to false"_text);
  return planCovered(coverItems(items, joined, kCoverShare, ctx), items, joined, cell, tooling,
                     items.front().options(), others, watch, ctx);
}

} // namespace voluta::toolpath
