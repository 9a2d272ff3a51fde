#include "toolpath/sparse/cover_layers.h"

#include "base/parallel.h"
#include "process/bead_model.h"
#include "toolpath/coverage/bead_volume.h"
#include "toolpath/feature_speeds.h"
#include "toolpath/first_layer.h"
#include "toolpath/infill/infill.h"
#include "toolpath/infill/strand_text.h"
#include "toolpath/plane/contours.h"
#include "toolpath/plane/same_patches.h"
#include "toolpath/sparse/branches.h"
#include "toolpath/sparse/patterns.h"
#include "toolpath/sparse/plane_sparse_lines.h"
#include "toolpath/sparse/sparse_lines.h"
#include "toolpath/sparse/split_layers.h"
#include "toolpath/sparse/stack_layers.h"
#include "toolpath/unsupported/bead_tip.h"
#include "toolpath/unsupported/bridge_direction.h"
#include "toolpath/unsupported/bridged_layers.h"
#include "toolpath/unsupported/supported_walls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using plan::PathKind;

// Share of a bead's points over sparse infill from which it is a bridge.
constexpr double kBridgeShare = 0.05;
// [beads] by which the shell of a plan is thinner than walls and skins: beads beside the sparse
// infill have round sides.
constexpr double kRoundSide = 0.5;

// Returns what distinguishes wall widths: one if they are all the same, else all of them.
std::vector<double> distinctOf(const std::vector<double>& widthMm) {
  const bool isOne =
      std::ranges::all_of(widthMm, [&](double width) { return width == widthMm.front(); });
  return isOne && !widthMm.empty() ? std::vector{widthMm.front()} : widthMm;
}

PatchCover moved(PatchCover cover, const Eigen::Vector3d& byMm) {
  for (Bead& bead : cover.beads)
    for (BeadPoint& point : bead.points)
      point.middle += byMm;
  for (ThinWall& wall : cover.thinWalls)
    wall.place += byMm;
  return cover;
}

void append(PatchCover& to, PatchCover more) {
  std::ranges::move(more.beads, std::back_inserter(to.beads));
  std::ranges::move(more.thinWalls, std::back_inserter(to.thinWalls));
  to.lacksField = to.lacksField || more.lacksField;
  to.areaMm2 += more.areaMm2;
  to.volumeMm3 += more.volumeMm3;
  to.beadVolumeMm3 += more.beadVolumeMm3;
  to.coveredMm2 += more.coveredMm2;
  to.overlapMm2 += more.overlapMm2;
}

// Returns the cover of a layer's bridges, whose lines fill them.
PatchCover coverOf(BridgedLayer layer) {
  PatchCover cover;
  cover.areaMm2 = cover.coveredMm2 = layer.areaMm2;
  cover.volumeMm3 = layer.volumeMm3;
  cover.beadVolumeMm3 = volumeOf(layer.beads);
  cover.beads = std::move(layer.beads);
  return cover;
}

bool isOfRegion(const layers::Patch& patch, std::size_t region) {
  return patch.region == static_cast<int>(region);
}

// Covers the patches of one region; the covers of the others are empty. `whole`: the layers that
// carry those of `stack`.
std::vector<PatchCover> coverSolid(const layers::LayerStack& stack, const layers::LayerStack& whole,
                                   const CoverRules& rules, std::size_t region, double share,
                                   const base::RunContext& ctx) {
  const auto& [options, tooling] = rules;
  const base::RunContext silent = ctx.quiet();
  const std::vector<char> isFirstLayer = firstLayerPatches(stack, options.platform);
  std::vector<std::vector<double>> wallWidths = carriedWallWidths(stack, tooling, silent);
  setWallWidths(stack, tooling, isFirstLayer, wallWidths);
  const auto processAt = [&](std::size_t i) {
    return processOf(stack.patches[i], tooling, isFirstLayer[i] != 0);
  };
  std::vector<std::optional<BridgedLayer>> bridged(stack.patches.size());
  if (!infillKind(options.infill).needsChart)
    bridged = bridgedLayers(stack, whole, processAt, wallWidths, options, silent);
  std::vector<const layers::Patch*> patches; // without bridges
  for (std::size_t i = 0; i < bridged.size(); ++i) {
    patches.push_back(bridged[i] ? &bridged[i]->rest : &stack.patches[i]);
    if (bridged[i])
      wallWidths[i] =
          wallWidthsOf(bridged[i]->rest, stack.patches[i], wallWidths[i], processAt(i).beadWidthMm);
  }
  const auto wallsOf = [&](std::size_t i) {
    return bridged[i] ? bridged[i]->walls : options.walls;
  };
  std::vector<std::optional<double>> directions(stack.patches.size());
  if (infillKind(options.infill).isStraightInside)
    directions = bridgeDirections(
        patches, whole, processAt,
        {options.infillAngleDeg, options.infillRotationDeg, options.walls}, silent);
  const bool changesWithHeight =
      options.infill == kFieldInfill && !isOneDirection(options.infillField);
  std::vector<std::vector<double>> choices(stack.patches.size());
  for (std::size_t i = 0; i < choices.size(); ++i) {
    choices[i] = distinctOf(wallWidths[i]);
    const int layer = stack.patches[i].layer;
    choices[i].insert(choices[i].end(), {isFirstLayer[i] != 0 ? 1.0 : 0.0,
                                         std::fmod(layer * options.infillRotationDeg, 180.0),
                                         directions[i] ? 1.0 : 0.0, directions[i].value_or(0.0),
                                         static_cast<double>(wallsOf(i)),
                                         static_cast<double>(stack.patches[i].region)});
    if (changesWithHeight)
      choices[i].push_back(static_cast<double>(i));
  }
  const std::vector<SameShape> same = sameShapes(patches, choices, silent);
  std::vector<std::size_t> shapes; // one patch each
  for (std::size_t i = 0; i < same.size(); ++i)
    if (same[i].patch == i && isOfRegion(stack.patches[i], region))
      shapes.push_back(i);
  std::vector<PatchCover> covers(stack.patches.size());
  base::parallelWithProgress(ctx, shapes.size(), share, "tool-paths"_text, [&](std::size_t s) {
    const std::size_t i = shapes[s];
    ToolpathOptions own = options;
    own.walls = wallsOf(i);
    covers[i] = coverPatch(*patches[i], processAt(i), own, silent, wallWidths[i], directions[i]);
  });
  for (std::size_t i = 0; i < same.size(); ++i)
    if (same[i].patch != i && isOfRegion(stack.patches[i], region))
      covers[i] = moved(covers[same[i].patch], same[i].shiftMm);
  for (std::size_t i = 0; i < bridged.size(); ++i)
    if (bridged[i] && isOfRegion(stack.patches[i], region))
      append(covers[i], coverOf(std::move(*bridged[i])));
  return covers;
}

double volumeOf(const layers::Patch& patch) {
  double mm3 = 0.0;
  for (const auto& t : patch.surface.triangles) {
    const auto v = [&](std::size_t k) { return static_cast<std::size_t>(t[k]); };
    const Eigen::Vector3d& a = patch.surface.vertices[v(0)];
    const double area =
        0.5 * (patch.surface.vertices[v(1)] - a).cross(patch.surface.vertices[v(2)] - a).norm();
    mm3 +=
        area / 3.0 * (patch.thicknessMm[v(0)] + patch.thicknessMm[v(1)] + patch.thicknessMm[v(2)]);
  }
  return mm3;
}

// Marks solid infill over sparse infill as bridges.
template <typename IsOverSparse>
void markBridges(PatchCover& cover, const IsOverSparse& isOverSparse) {
  for (Bead& bead : cover.beads) {
    if (bead.kind != PathKind::Infill && bead.kind != PathKind::GapFill)
      continue;
    const auto overSparse = std::ranges::count_if(bead.points, isOverSparse);
    if (static_cast<double>(overSparse) <= kBridgeShare * static_cast<double>(bead.points.size()))
      continue;
    bead.kind = PathKind::Bridge;
    if (cover.overSparse++ == 0)
      cover.firstOverSparse = bead.points.front().middle;
  }
}

// The sparse parts of a stack and their beads.
class SparseInfill {
public:
  SparseInfill(const layers::LayerStack& stack, const StackLayers& layers, const SplitLayers& split,
               std::span<const CoverRules> rules, const base::RunContext& ctx)
      : stack_(stack), layers_(layers), split_(split), rules_(rules), ctx_(ctx) {
    for (const CoverRules& own : rules)
      frames_.push_back(patternFrames(stack, own.options));
    if (layers.count)
      solid_.emplace(split.solid, ctx);
  }

  void markBridgesOf(std::size_t i, PatchCover& cover) const {
    if (layers_.levels.isEven(i)) {
      const PlanePatch& plane = *layers_.levels.patch(i);
      const auto below = sparseFrom(i, -1, 1);
      if (below.empty() || below.front().empty())
        return;
      const Contours sparse(below.front());
      markBridges(cover, [&](const BeadPoint& p) {
        return sparse.contains((plane.plane_R_work * p.middle).head<2>());
      });
    } else if (layers_.count) {
      // The layer below is there, but not its solid part.
      markBridges(cover, [&](const BeadPoint& p) {
        return layers_.count->patchBelow(i, p.middle, p.direction, p.heightMm) >= 0 &&
               solid_->patchBelow(i, p.middle, p.direction, p.heightMm) < 0;
      });
    }
  }

  // Is the interior of a patch sparse?
  bool isSparse(std::size_t i) const {
    return split_.sparse[i] && rulesOf(i).options.infillDensity < 1.0;
  }

  // Precondition: isSparse(i).
  std::vector<Bead> beads(std::size_t i) const {
    const ToolpathOptions& options = rulesOf(i).options;
    const int tool = options.infillTool < 0 ? stack_.patches[i].tool : options.infillTool;
    const process::Process& process = rulesOf(i).tooling.at(tool).process;
    const PatternFrame& frame = frames_[regionOf(i)][i];
    std::vector<Bead> made;
    if (layers_.levels.isEven(i) && !sparsePattern(options.sparsePattern).followsWalls)
      made = planeSparseBeads(*layers_.levels.patch(i), split_.sparseAreas[i], frame,
                              sparseFrom(i, 1, branchLayers(process, options)), process, options,
                              ctx_);
    else
      made = sparseBeads(*split_.sparse[i], {stack_, i, *layers_.count, frame}, process, options,
                         ctx_);
    for (Bead& bead : made)
      bead.tool = tool;
    return made;
  }

private:
  std::size_t regionOf(std::size_t i) const {
    return static_cast<std::size_t>(stack_.patches[i].region);
  }
  const CoverRules& rulesOf(std::size_t i) const { return rules_[regionOf(i)]; }

  static int branchLayers(const process::Process& process, const ToolpathOptions& options) {
    return options.topLayers == 0 ? 0 : branchesOf(process, options).layers();
  }

  // Returns the sparse parts of the levels that follow a patch.
  std::vector<ClipperLib::Paths> sparseFrom(std::size_t i, int sign, int count) const {
    std::vector<ClipperLib::Paths> areas;
    for (const PlaneLevels::Level* level : layers_.levels.from(i, sign, count)) {
      areas.emplace_back();
      for (const std::size_t patch : level->patches)
        if (isSparse(patch))
          std::ranges::copy(split_.sparseAreas[patch], std::back_inserter(areas.back()));
    }
    return areas;
  }

  const layers::LayerStack& stack_;
  const StackLayers& layers_;
  const SplitLayers& split_;
  std::span<const CoverRules> rules_; // by region
  const base::RunContext& ctx_;
  std::vector<std::vector<PatternFrame>> frames_; // by region, per patch
  std::optional<LayerCount> solid_;
};

// Returns the distance from the surface up to which all places are in walls or skins.
double shellOf(std::span<const CoverRules> rules) {
  double shell = INFINITY;
  for (const auto& [o, tooling] : rules) {
    if (o.infillDensity >= 1.0)
      continue;
    for (const process::Tool& tool : tooling.tools()) {
      const process::Process& p = tool.process;
      const double hatch = process::hatchOf(p.beadWidthMm, p.layerHeightMm);
      const int layers = std::min(o.topLayers, o.bottomLayers); // 0: no skin, however thick
      const double skin = layers == 0 ? 0.0 : std::max(o.skinMm, layers * p.layerHeightMm);
      shell = std::min({shell, o.walls * hatch - kRoundSide * p.beadWidthMm, skin});
    }
  }
  return std::max(0.0, shell);
}

// Is the interior of these patches covered apart from walls and skins?
bool isSplit(const ToolpathOptions& options) {
  return options.infillDensity < 1.0 || options.infillTool >= 0;
}

// Covers solid interiors that another tool fills: their beads follow those of the skin in the cover
// of the patch.
void coverSolidCores(const SplitLayers& split, const layers::LayerStack& stack,
                     const CoverRules& rules, std::size_t region, const base::RunContext& ctx,
                     std::vector<PatchCover>& covers) {
  if (rules.options.infillTool < 0 || rules.options.infillDensity < 1.0)
    return;
  layers::LayerStack core;
  core.layerCount = stack.layerCount;
  std::vector<std::size_t> of; // patch of the stack
  for (std::size_t i = 0; i < split.sparse.size(); ++i)
    if (split.sparse[i] && isOfRegion(stack.patches[i], region)) {
      core.patches.push_back(*split.sparse[i]);
      core.patches.back().tool = rules.options.infillTool;
      of.push_back(i);
    }
  CoverRules own = rules;
  own.options.walls = 0;
  std::vector<PatchCover> cores = coverSolid(core, stack, own, region, 1.0, ctx);
  for (std::size_t i = 0; i < cores.size(); ++i) {
    for (Bead& bead : cores[i].beads)
      bead.tool = rules.options.infillTool;
    append(covers[of[i]], std::move(cores[i]));
  }
}

void addSparse(const SparseInfill& infill, const layers::LayerStack& stack,
               const SplitLayers& split, std::span<const CoverRules> rules,
               const base::RunContext& ctx, LayerCovers& out) {
  std::vector<std::vector<Bead>> sparse(stack.patches.size());
  base::parallelChunks(ctx, stack.patches.size(), 1, [&](std::size_t i, std::size_t) {
    infill.markBridgesOf(i, out.covers[i]);
    if (infill.isSparse(i))
      sparse[i] = infill.beads(i);
  });
  for (std::size_t i = 0; i < sparse.size(); ++i) {
    if (infill.isSparse(i)) {
      const double mm3 = volumeOf(*split.sparse[i]);
      out.sparseMm3 += mm3;
      out.sparseAskedMm3 +=
          mm3 * rules[static_cast<std::size_t>(stack.patches[i].region)].options.infillDensity;
    }
    out.sparseBeadMm3 += volumeOf(sparse[i]);
    std::ranges::move(sparse[i], std::back_inserter(out.covers[i].beads));
  }
  if (out.sparseMm3 > 0.0)
    out.fill = {{shellOf(rules), std::max(0.0, out.sparseMm3 - out.sparseBeadMm3)}};
}

bool followsWalls(const CoverRules& rules) {
  return rules.options.infillDensity < 1.0 &&
         sparsePattern(rules.options.sparsePattern).followsWalls;
}
} // namespace

LayerCovers coverLayers(const layers::LayerStack& stack, std::span<const CoverRules> rules,
                        double share, const base::RunContext& ctx) {
  const base::RunContext silent = ctx.quiet();
  const bool anySplit =
      std::ranges::any_of(rules, [](const CoverRules& own) { return isSplit(own.options); });
  const bool anySparse = std::ranges::any_of(
      rules, [](const CoverRules& own) { return own.options.infillDensity < 1.0; });
  std::optional<StackLayers> layers;
  SplitLayers split;
  if (anySplit) {
    layers.emplace(stack, std::ranges::any_of(rules, followsWalls), silent);
    split = splitLayers(stack, *layers, rules, silent);
  }
  const layers::LayerStack& solid = anySplit ? split.solid : stack;
  LayerCovers out;
  out.covers.resize(stack.patches.size());
  for (std::size_t r = 0; r < rules.size(); ++r) {
    if (std::ranges::none_of(stack.patches,
                             [&](const layers::Patch& patch) { return isOfRegion(patch, r); }))
      continue;
    const double each = share / static_cast<double>(rules.size());
    const base::RunContext span =
        ctx.sub(each * static_cast<double>(r), each * (static_cast<double>(r) + 1.0));
    std::vector<PatchCover> own = coverSolid(solid, stack, rules[r], r, 1.0, span);
    coverSolidCores(split, stack, rules[r], r, silent, own);
    for (std::size_t i = 0; i < own.size(); ++i)
      if (isOfRegion(stack.patches[i], r))
        out.covers[i] = std::move(own[i]);
  }
  if (anySparse)
    addSparse(SparseInfill(stack, *layers, split, rules, silent), stack, split, rules, silent, out);
  return out;
}

} // namespace voluta::toolpath
