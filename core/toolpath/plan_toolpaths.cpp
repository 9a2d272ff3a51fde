#include "toolpath/plan_toolpaths.h"

#include "toolpath/brim.h"
#include "toolpath/feature_speeds.h"
#include "toolpath/first_layer.h"
#include "toolpath/prime_path.h"

#include "base/run_context.h"
#include "base/stopwatch.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "toolpath/directions.h"
#include "toolpath/order/assemble.h"
#include "toolpath/order/spiral.h"
#include "toolpath/sparse/cover_layers.h"
#include "toolpath/unsupported/passes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;
using plan::PathKind;

// Puts the brim before all other paths, and the prime before the brim.
void addWaste(Assembled& assembled, const layers::LayerStack& stack, const robot::Cell& cell,
              const process::Tooling& tooling, const ToolpathOptions& options,
              plan::Findings& findings) {
  plan::ToolPlan& plan = assembled.plan;
  const std::size_t before = plan.waypointCount();
  if (auto cut = addBrim(plan, stack, tooling, options))
    findings.push_back(std::move(*cut));
  if (auto falls = addPrimePath(plan, cell, tooling, options))
    findings.push_back(std::move(*falls));
  assembled.clearDirection.insert(assembled.clearDirection.begin(), plan.waypointCount() - before,
                                  Vector3d::UnitZ());
}

// Returns the finding about skins that no infill carries.
std::optional<plan::Finding> hollowSkin(const std::vector<PatchCover>& covers) {
  std::size_t paths = 0;
  std::optional<Vector3d> first;
  for (const PatchCover& cover : covers)
    for (const Bead& bead : cover.beads)
      if (bead.kind == PathKind::Bridge) {
        ++paths;
        first = first.value_or(bead.points.front().middle);
      }
  if (!first)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::HollowSkin, {{"paths", paths}}, *first, paths);
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

plan::Findings coverFindings(const layers::LayerStack& stack, const std::vector<PatchCover>& covers,
                             const process::Tooling& tooling, const ToolpathOptions& options) {
  plan::Findings findings;
  if (auto thin = thinWalls(stack, covers, tooling, options.thinWalls == "omit"))
    findings.push_back(std::move(*thin));
  if (options.infillDensity <= 0.0)
    if (auto hollow = hollowSkin(covers))
      findings.push_back(std::move(*hollow));
  return findings;
}

// Adds the figures of the finished plan.
void addPathFigures(const plan::ToolPlan& plan, plan::ToolpathStatistics& s) {
  s.paths = s.starts = plan.paths.size();
  s.waypoints = plan.waypointCount();
  for (std::size_t k = 0; k < plan.paths.size(); ++k) {
    const plan::ToolPath& path = plan.paths[k];
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const double length = (plan.position[i] - plan.position[i - 1]).norm();
      const auto section = [&](std::size_t j) {
        return process::beadArea(static_cast<double>(plan.widthMm[j]),
                                 static_cast<double>(plan.heightMm[j]));
      };
      s.lengthMm += length;
      if (plan::isWaste(path.kind))
        continue;
      s.materialMm3 += process::beadVolume(section(i - 1), section(i), length);
    }
    if (k > 0)
      s.travelMm += (plan.position[path.first] - plan.position[path.first - 1]).norm();
  }
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
} // namespace

ToolpathResult planToolpaths(const layers::LayerStack& stack, const robot::Cell& cell,
                             const process::Tooling& tooling, const ToolpathOptions& given,
                             const base::RunContext& ctx) {
  const ToolpathOptions options = given.spiral ? spiralOptions(given) : given;
  ToolpathResult r;
  base::Stopwatch watch;
  const base::RunContext silent = ctx.quiet();
  const std::vector<char> isFirstLayer = firstLayerPatches(stack, options.platform);
  LayerCovers made = coverLayers(stack, tooling, options, 0.6, ctx);
  const std::vector<PatchCover>& covers = made.covers;
  if (options.spiral)
    made.fill = keepOuterWalls(stack, options.bottomLayers, made.covers);
  Assembled assembled = assemble(stack, covers, tooling, {options.seam, options.orderIslands});
  assembled.plan.fill = made.fill;
  r.findings = coverFindings(stack, covers, tooling, options);
  if (options.spiral)
    if (auto ends = joinSpiral(assembled, options.bottomLayers))
      r.findings.push_back(std::move(*ends));
  const bool hasBrim = options.brimWidthMm > 0.0;
  // Added here, so that the travel moves of the head account for the prime as for every bead.
  if (!hasBrim)
    addWaste(assembled, stack, cell, tooling, options, r.findings);
  const PassScene scene{cell, tooling, options.platform};
  plan::Findings told;
  std::shared_ptr<const collision::GrowingPart> grown;
  if (options.rimSupports) {
    PassedPlan passed =
        runUnsupportedPasses(PassPhase::BeforeDirections, assembled.plan,
                             std::move(assembled.clearDirection), nullptr, scene, silent);
    assembled.plan = std::move(passed.beads.plan);
    assembled.clearDirection = std::move(passed.beads.clearDirection);
    grown = std::move(passed.grown);
    r.statistics.rimSupportMm3 = passed.addedMm3;
    told = std::move(passed.findings);
  }
  // A brim surrounds rim supports as well.
  if (hasBrim) {
    addWaste(assembled, stack, cell, tooling, options, r.findings);
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
                       ctx.sub(0.6, 1.0), liesUnderRim, std::move(grown));
  PassedPlan passed = runUnsupportedPasses(PassPhase::AfterDirections, oriented.plan, {},
                                           std::move(oriented.grown), scene, silent);
  r.seconds.orient = watch.seconds();
  r.plan = std::move(passed.beads.plan);
  if (!applyFeatures(r.plan, tooling, isFirstLayer, passed.beads.unsupported))
    r.grown = std::move(passed.grown);
  for (plan::Findings* findings : {&oriented.findings, &passed.findings, &told})
    std::ranges::move(*findings, std::back_inserter(r.findings));

  r.statistics.sparseMm3 = made.sparseMm3;
  r.statistics.sparseBeadMm3 = made.sparseBeadMm3;
  r.statistics.gouges = oriented.gouges;
  r.statistics.maxTurnDeg = oriented.maxTurnDeg;
  addPathFigures(r.plan, r.statistics);
  if (auto bare = addCoverFigures(stack, covers, r.statistics))
    r.findings.push_back(std::move(*bare));
  return r;
}

} // namespace voluta::toolpath
