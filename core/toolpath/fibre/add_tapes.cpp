#include "toolpath/fibre/add_tapes.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/polyline.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "process/bead_model.h"
#include "toolpath/fibre/bare_tapes.h"
#include "toolpath/fibre/tape_curves.h"
#include "toolpath/fibre/tape_paths.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

// Longest edges of the surface on which tapes are planned, as a share of their width
constexpr double kEdge = 0.2;
// Waypoints that are closer to the place of the cut give way to it.
constexpr double kCutMm = 0.3;

int toolForTape(const process::Tooling& tooling) {
  const auto tools = tooling.tools();
  const auto tool = std::ranges::find_if(
      tools, [](const process::Tool& t) { return t.process.tape.has_value(); });
  if (tool == tools.end())
    throw base::Error(
        base::ErrorCode::Usage, "no tool of the job lays tape"_text, "fibreLayers"_name,
        "add a tool with a process for tape, such as tape-5, or set `fibreLayers=0`"_text);
  return static_cast<int>(tool - tools.begin());
}

// Returns per patch whether tapes are laid on it: its layer is one of the chosen ones, and not the
// last of its item.
std::vector<char> chosenPatches(const layers::LayerStack& stack, const FibreOptions& options) {
  std::map<int, int> lastLayer;
  for (const layers::Patch& patch : stack.patches)
    if (patch.group != layers::kSupportGroup)
      lastLayer[patch.item] = std::max(lastLayer[patch.item], patch.layer);
  std::vector<char> chosen;
  for (const layers::Patch& patch : stack.patches) {
    const int since = patch.layer + 1 - options.firstLayer;
    chosen.push_back(patch.group != layers::kSupportGroup && since >= 0 &&
                     since % options.everyLayers == 0 && patch.layer < lastLayer[patch.item]);
  }
  return chosen;
}

// Returns the points of a tape's path with one where it is cut.
std::vector<SurfacePoint> withCut(const PatchSurface& surface, const SurfaceCurve& curve,
                                  double cutAheadMm) {
  std::vector<SurfacePoint> points = curve.points;
  if (curve.closed)
    points.push_back(points.front());
  const std::size_t last = points.size() - 1;
  const auto place = geometry::placeAfter(cutAheadMm, points.size(),
                                          [&](std::size_t k) { return points[last - k].position; });
  if (!place)
    return points;
  const std::size_t i = last - place->segment;
  const Vector3d step = points[i - 1].position - points[i].position;
  const double length = step.norm(), left = place->share * length;
  const SurfacePoint cut =
      surface.project(points[i].position + place->share * step, points[i].triangle);
  if (left < kCutMm && i < last)
    points[i] = cut;
  else if (length - left < kCutMm && i > 1)
    points[i - 1] = cut;
  else
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(i), cut);
  return points;
}

// The tapes on one patch.
struct PatchTapes {
  PatchSurface surface;
  TapePaths tapes;
};

class TapeAdder {
public:
  TapeAdder(const plan::ToolPlan& before, const layers::LayerStack& stack,
            const process::Tooling& tooling, const FibreOptions& options)
      : before_(before), stack_(stack), options_(options), tool_(toolForTape(tooling)),
        process_(tooling.at(tool_).process), tape_(*process_.tape) {}

  plan::Findings add(plan::ToolPlan& out, plan::ToolpathStatistics& s,
                     const base::RunContext& ctx) {
    makeTapes(ctx);
    plan::ToolPlan plan;
    plan.fill = before_.fill;
    const std::vector<std::vector<std::size_t>> behind = patchesBehindPaths();
    for (std::size_t k = 0; k < before_.paths.size(); ++k) {
      copyPath(plan, before_.paths[k]);
      for (const std::size_t patch : behind[k])
        for (const SurfaceCurve& curve : made_[patch]->tapes.paths)
          addTape(plan, patch, curve);
    }
    addCoverFigures(s);
    plan::Findings findings = findingsOf(plan, s);
    out = std::move(plan);
    return findings;
  }

private:
  void makeTapes(const base::RunContext& ctx) {
    const std::vector<char> chosen = chosenPatches(stack_, options_);
    made_.resize(stack_.patches.size());
    const int every = options_.everyLayers;
    base::parallelChunks(ctx, stack_.patches.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (!chosen[i])
          continue;
        const layers::Patch& patch = stack_.patches[i];
        const int turns = (patch.layer + 1 - options_.firstLayer) / every;
        const TapeChoice choice{.paths = options_.paths,
                                .directionRad = base::degreesToRadians(
                                    options_.angleDeg + turns * options_.rotationDeg),
                                .maxCount = options_.maxPerLayer,
                                .endMm = options_.endMm,
                                .curves = tapeCurves(options_.curves),
                                .field = tapeField(options_.field)};
        PatchSurface surface = PatchSurface::refine(patch, kEdge * tape_.widthMm);
        TapePaths tapes = tapePaths(surface, tape_, choice, process_.stepMm, ctx.quiet());
        made_[i] = PatchTapes{std::move(surface), std::move(tapes)};
      }
    });
  }

  // Returns per path the patches whose tapes follow it: the end of the run of paths of one layer in
  // which the patch is finished, so that the tool changes once a layer.
  std::vector<std::vector<std::size_t>> patchesBehindPaths() const {
    const std::vector<plan::ToolPath>& paths = before_.paths;
    std::vector<std::optional<std::size_t>> lastOf(stack_.patches.size());
    for (std::size_t k = 0; k < paths.size(); ++k)
      if (!plan::isWaste(paths[k].kind))
        lastOf.at(static_cast<std::size_t>(paths[k].patch)) = k;
    const auto isSameLayer = [&](const plan::ToolPath& a, const plan::ToolPath& b) {
      return a.item == b.item && a.layer == b.layer && !plan::isWaste(b.kind);
    };
    std::vector<std::vector<std::size_t>> behind(paths.size());
    for (std::size_t i = 0; i < made_.size(); ++i) {
      if (!made_[i] || made_[i]->tapes.paths.empty() || !lastOf[i])
        continue;
      std::size_t k = *lastOf[i];
      while (k + 1 < paths.size() && isSameLayer(paths[k], paths[k + 1]))
        ++k;
      behind[k].push_back(i);
    }
    return behind;
  }

  void copyPath(plan::ToolPlan& plan, const plan::ToolPath& path) const {
    plan::ToolPath copy = path;
    copy.first = plan.waypointCount();
    for (std::size_t w = path.first; w < path.first + path.count; ++w)
      plan::appendWaypoint(plan, before_, w);
    plan.paths.push_back(copy);
  }

  void addTape(plan::ToolPlan& plan, std::size_t patchIndex, const SurfaceCurve& curve) const {
    const layers::Patch& patch = stack_.patches[patchIndex];
    const PatchSurface& surface = made_[patchIndex]->surface;
    const std::vector<SurfacePoint> points = withCut(surface, curve, tape_.cutAheadMm);
    plan.paths.push_back({.first = plan.waypointCount(),
                          .count = points.size(),
                          .kind = plan::PathKind::Tape,
                          .layer = patch.layer,
                          .patch = static_cast<int>(patchIndex),
                          .group = patch.group,
                          .closed = curve.closed,
                          .item = patch.item,
                          .tool = tool_});
    for (const SurfacePoint& p : points) {
      const Vector3d normal = surface.interpolate(surface.direction, p);
      const double above = 0.5 * surface.interpolate(surface.thicknessMm, p) + tape_.thicknessMm;
      plan.position.push_back(p.position + above * normal);
      plan.direction.push_back(normal);
      plan.widthMm.push_back(static_cast<float>(process_.beadWidthMm));
      plan.heightMm.push_back(static_cast<float>(tape_.thicknessMm));
      plan.speedMmPerS.push_back(static_cast<float>(process_.speedMmPerS));
    }
  }

  void addCoverFigures(plan::ToolpathStatistics& s) const {
    double region = 0.0, covered = 0.0, overlap = 0.0;
    for (const auto& made : made_)
      if (made) {
        region += made->tapes.regionMm2;
        covered += made->tapes.coveredMm2;
        overlap += made->tapes.overlapMm2;
      }
    s.tapeCoveredFraction = region > 0.0 ? covered / region : 0.0;
    s.tapeOverlapFraction = region > 0.0 ? overlap / region : 0.0;
  }

  plan::Findings findingsOf(const plan::ToolPlan& plan, plan::ToolpathStatistics& s) const {
    plan::Findings findings;
    double bent = 0.0, tooShort = 0.0;
    const layers::Patch* first = nullptr;
    for (std::size_t i = 0; i < made_.size(); ++i)
      if (made_[i]) {
        bent += made_[i]->tapes.bentMm;
        tooShort += made_[i]->tapes.shortMm;
        if (!first && made_[i]->tapes.bentMm + made_[i]->tapes.shortMm > 0.0)
          first = &stack_.patches[i];
      }
    if (std::ranges::find(plan.paths, plan::PathKind::Tape, &plan::ToolPath::kind) ==
        plan.paths.end())
      findings.push_back(
          plan::makeFinding(plan::FindingKind::NoTape, {{"width", base::mm(tape_.widthMm)},
                                                        {"length", base::mm(tape_.minLengthMm)}}));
    if (first)
      findings.push_back(plan::makeFinding(plan::FindingKind::TapesLeftOut,
                                           {{"bent", base::mm(bent)},
                                            {"radius", base::mm(tape_.minBendRadiusMm)},
                                            {"short", base::mm(tooShort)},
                                            {"length", base::mm(tape_.minLengthMm)}},
                                           first->surface.vertices.front()));
    const BareTapes bare = bareTapes(plan, tape_.widthMm);
    s.tapeBareMm = bare.lengthMm;
    if (bare.lengthMm > 0.0)
      findings.push_back(plan::makeFinding(plan::FindingKind::TapesBare,
                                           {{"length", base::mm(bare.lengthMm)},
                                            {"layer", static_cast<std::size_t>(bare.layer + 1)}},
                                           bare.where));
    return findings;
  }

  const plan::ToolPlan& before_;
  const layers::LayerStack& stack_;
  const FibreOptions& options_;
  int tool_;
  const process::Process& process_;
  const process::Tape& tape_;
  std::vector<std::optional<PatchTapes>> made_; // per patch
};

} // namespace

plan::Findings addTapes(plan::ToolPlan& plan, const layers::LayerStack& stack,
                        const process::Tooling& tooling, const FibreOptions& options,
                        plan::ToolpathStatistics& statistics, const base::RunContext& ctx) {
  if (options.everyLayers <= 0)
    return {};
  const plan::ToolPlan before = std::move(plan);
  return TapeAdder(before, stack, tooling, options).add(plan, statistics, ctx);
}

} // namespace voluta::toolpath
