#include "curved/smooth_field.h"

#include "base/error.h"
#include "base/parallel.h"
#include "curved/field_fit.h"
#include "curved/flood.h"
#include "curved/reverse_growth.h"

#include <algorithm>
#include <cmath>

namespace voluta::curved {

namespace {

constexpr float kChanged = 0.3f; // a growth that lowers the field by more than this holds it there
constexpr float kScreenStart = 0.001f, kScreenFree = 0.003f, kScreenHeld = 0.02f,
                kScreenPressed = 0.3f;
// A field is good enough if a smaller share of voxels than kAccessible is inaccessible and a larger
// one than kWithin is within the limits. As long as more voxels are inaccessible, the overhang
// limit may be relaxed.
constexpr double kAccessible = 0.0012, kWithin = 0.9965, kDeepest = 1.4;
// a round that leaves more than this share of the inaccessible voxels
constexpr double kStalled = 0.6;
// Cells by which roofs may lag behind a flat front, and behind one of the head's shape; share of
// voxels under roofs flatter than 60 degrees above which the latter is worth its time.
constexpr float kRoofFlat = 0.65f, kRoofByHead = 1.2f;
constexpr double kRoofs = 0.012;
constexpr float kOverhangFirst = 0.66f, kOverhangStep = 0.12f;

// Marks the neighbours of marked voxels, and theirs.
void widen(const VoxelGraph& graph, std::vector<std::uint8_t>& marked) {
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<std::uint8_t> inner = marked;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (inner[v])
        for (const std::int32_t w : graph.neighbour[v])
          if (w >= 0)
            marked[static_cast<std::size_t>(w)] = 1;
  }
}

// Increases the screen where growth and field disagree and around it, and lets it decay elsewhere.
// Around voxels deep inside the front it is strong at once.
void adaptScreen(const VoxelGraph& graph, const std::vector<float>& field,
                 const std::vector<float>& target, const std::vector<std::int32_t>& deep,
                 std::vector<float>& screen) {
  std::vector<std::uint8_t> held(graph.size(), 0), pressed(graph.size(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v)
    held[v] = std::abs(field[v] - target[v]) > kChanged;
  for (const std::int32_t v : deep)
    pressed[static_cast<std::size_t>(v)] = 1;
  widen(graph, held);
  if (!deep.empty())
    widen(graph, pressed);
  for (std::size_t v = 0; v < graph.size(); ++v)
    screen[v] = pressed[v] ? kScreenPressed
                : held[v]  ? std::min(kScreenHeld, screen[v] * 4.0f)
                           : std::max(kScreenFree, screen[v] * 0.5f);
}

// Returns how far [cells] voxels may lag behind the front, by the slope of their surface: the full
// amount under roofs flatter than 32 degrees, zero at 53 degrees and steeper.
std::vector<float> roofAllowance(const std::vector<Eigen::Vector3f>& normals, float cells) {
  constexpr float kSteep = 0.6f, kFlat = 0.85f;
  std::vector<float> allowance(normals.size());
  for (std::size_t v = 0; v < normals.size(); ++v)
    allowance[v] = cells * std::clamp((-normals[v].z() - kSteep) / (kFlat - kSteep), 0.0f, 1.0f);
  return allowance;
}

struct Front {
  const process::HeadShape* head; // null: flat
  float roofCells;                // allowed lag of roofs
  bool relaxes;                   // relax the overhang while too much stays inaccessible,
  double maxRoofs;                // but not once it produces more than this share of roofs
};

class Rounds {
public:
  Rounds(const VoxelGraph& graph, const std::vector<std::int32_t>& rank, const LayerLimits& limits,
         int rounds, const std::function<void(const std::vector<float>&)>& improved,
         const base::RunContext& ctx)
      : graph_(graph), rank_(rank), limits_(limits), rounds_(rounds), improved_(improved),
        fit_(graph, ctx), start_(geodesicDistance(graph, rank, ctx)) {
    for (const float f : start_)
      base::require(std::isfinite(f), "smoothField: every voxel is reached from the platform");
    FitOptions options;
    options.slopeMin = 0.85f;
    options.slopeMax = 1.15f;
    options.overhang = kOverhangFirst;
    fit_.fit(start_, std::vector<float>(start_), std::vector<float>(graph.size(), kScreenStart),
             options, ctx);
  }

  void run(const Front& front, const base::RunContext& ctx) {
    std::vector<float> field = start_;
    std::vector<float> screen(graph_.size(), kScreenStart);
    FitOptions fitOptions;
    fitOptions.overhang = kOverhangFirst;
    const std::vector<float> allowance = roofAllowance(fit_.normals(), front.roofCells);
    PeelOptions peelOptions;
    peelOptions.tolerance = 0.1;
    peelOptions.sheet = 0.75;
    peelOptions.levelSlack = 0.25;
    peelOptions.eases = true;
    peelOptions.allowance = allowance;
    peelOptions.sacrifice = false;
    std::vector<std::int32_t> deep;
    double before = 0.0;
    for (int round = 0; round < rounds_; ++round) {
      ctx.report((round + 0.5) / (rounds_ + 0.5), "field"_text);
      field = withoutPits(graph_, field, kPitSlope, ctx);
      // Guided growth runs in parallel with the score, which may make it superfluous.
      FieldScore score;
      Peeling grown;
      const base::CancelToken ends;
      peelOptions.superseded = ends;
      const auto judge = [&] {
        score = scoreField(graph_, field, fit_.normals(), limits_, front.head, deep, ctx);
        const bool good = score.inaccessible <= kAccessible && score.within >= kWithin &&
                          score.deepest <= kDeepest && (front.relaxes || score.roofs <= kRoofs);
        if (good || round + 1 == rounds_ ||
            (fitOptions.overhang > kOverhangFirst && score.roofs > front.maxRoofs))
          ends.cancel();
      };
      const auto grow = [&] {
        if (round + 1 < rounds_)
          grown = peelGuided(graph_, field, rank_, peelOptions, ctx.quiet());
      };
      base::parallelChunks(ctx, 2, 1, [&](std::size_t begin, std::size_t) {
        if (begin == 0)
          judge();
        else
          grow();
      });
      const bool stalled =
          round > 0 && score.inaccessible > kAccessible && score.inaccessible > kStalled * before;
      before = score.inaccessible;
      keepIfBetter(field, score);
      if (ends.cancelled())
        break;
      if (stalled && front.relaxes)
        fitOptions.overhang += kOverhangStep;
      std::vector<float> target(graph_.size());
      for (std::size_t v = 0; v < graph_.size(); ++v)
        target[v] = grown.rank[v] > 0 ? std::max(grown.level[v], 0.25f) : field[v];
      adaptScreen(graph_, field, target, deep, screen);
      field = target;
      fit_.fit(field, target, screen, fitOptions, ctx);
    }
  }

  const FieldScore& last() const { return best_.rounds.back(); }
  SmoothField take() { return std::move(best_); }

private:
  void keepIfBetter(const std::vector<float>& field, const FieldScore& score) {
    const bool first = best_.rounds.empty();
    best_.rounds.push_back(score);
    if (!first && score.total() >= best_.score.total())
      return;
    best_.score = score;
    best_.field = field;
    const auto toMm = static_cast<float>(score.scale * graph_.grid.pitch);
    for (float& f : best_.field)
      f *= toMm;
    if (improved_)
      improved_(best_.field);
  }

  const VoxelGraph& graph_;
  const std::vector<std::int32_t>& rank_;
  const LayerLimits& limits_;
  int rounds_;
  const std::function<void(const std::vector<float>&)>& improved_;
  FieldFit fit_;
  std::vector<float> start_;
  SmoothField best_;
};

} // namespace

SmoothField smoothField(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                        const LayerLimits& limits, int rounds, const process::HeadShape* head,
                        const std::function<void(const std::vector<float>&)>& improved,
                        const base::RunContext& ctx) {
  base::require(rounds >= 1 && graph.size() > 0 && rank.size() == graph.size(),
                "smoothField: a round and a voxel or more, a rank each");
  ctx.report(0.0, "field"_text);
  Rounds all(graph, rank, limits, rounds, improved, ctx);
  const bool hasHead = head != nullptr;
  all.run({nullptr, kRoofFlat, true, hasHead ? kRoofs : 1.0}, ctx.sub(0.0, hasHead ? 0.6 : 1.0));
  if (hasHead && all.last().roofs > kRoofs)
    all.run({head, kRoofByHead, false, 1.0}, ctx.sub(0.6, 1.0));
  ctx.report(1.0, "field"_text);
  return all.take();
}

} // namespace voluta::curved
