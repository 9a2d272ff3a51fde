#include "curved/smooth_field.h"

#include "base/error.h"
#include "curved/field_fit.h"
#include "curved/flood.h"
#include "curved/reverse_growth.h"

#include <algorithm>
#include <cmath>

namespace voluta::curved {

namespace {

constexpr float kChanged = 0.3f; // a growth that lowers the field by more holds it there
constexpr float kScreenStart = 0.001f, kScreenFree = 0.003f, kScreenHeld = 0.02f,
                kScreenPressed = 0.3f;
// Fewer voxels than this may be inaccessible, and more must be within the limits, for a field to be
// good enough; above it, layers may overhang more where that helps.
constexpr double kAccessible = 0.0012, kWithin = 0.9965, kDeepest = 1.4;
constexpr double kStalled = 0.6; // a round that leaves more than this share of them
constexpr float kOverhangFirst = 0.68f, kOverhangStep = 0.12f;

// Marks the neighbours of what is marked, and theirs.
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

// The screen grows where growth and field disagree and around that, and decays elsewhere; around
// what lies deep inside the front it is strong at once.
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

} // namespace

SmoothField smoothField(const VoxelGraph& graph, const std::vector<std::int32_t>& rank,
                        const LayerLimits& limits, int rounds,
                        const std::function<void(const std::vector<float>&)>& improved,
                        const base::RunContext& ctx) {
  base::require(rounds >= 1 && graph.size() > 0 && rank.size() == graph.size(),
                "smoothField: a round and a voxel or more, a rank each");
  SmoothField out;
  ctx.report(0.0, "field");
  std::vector<float> field = geodesicDistance(graph, rank, ctx);
  for (const float f : field)
    base::require(std::isfinite(f), "smoothField: every voxel is reached from the platform");
  FieldFit fit(graph, ctx);
  std::vector<float> screen(graph.size(), kScreenStart);
  FitOptions fitOptions;
  fitOptions.slopeMin = 0.85f;
  fitOptions.slopeMax = 1.15f;
  fitOptions.overhang = kOverhangFirst;
  fit.fit(field, std::vector<float>(field), screen, fitOptions, ctx);
  fitOptions.slopeMin = FitOptions{}.slopeMin;
  fitOptions.slopeMax = FitOptions{}.slopeMax;

  PeelOptions peelOptions;
  peelOptions.tolerance = 0.1;
  peelOptions.sheet = 0.75;
  peelOptions.levelSlack = 0.25;
  peelOptions.eases = true;
  peelOptions.sacrifice = false;
  peelOptions.reports = false;
  std::vector<std::int32_t> deep;
  for (int round = 0; round < rounds; ++round) {
    ctx.report((round + 0.5) / (rounds + 0.5), "field");
    field = flood(graph, {}, field, kPitSlope, ctx, Steps::FacesFirst).value;
    const FieldScore score = scoreField(graph, field, fit.normals(), limits, deep, ctx);
    const bool stalled = !out.rounds.empty() && score.inaccessible > kAccessible &&
                         score.inaccessible > kStalled * out.rounds.back().inaccessible;
    out.rounds.push_back(score);
    if (round == 0 || score.total() < out.score.total()) {
      out.score = score;
      out.field = field;
      const auto toMm = static_cast<float>(score.scale * graph.grid.pitch);
      for (float& f : out.field)
        f *= toMm;
      if (improved)
        improved(out.field);
    }
    if (round + 1 == rounds ||
        (score.inaccessible <= kAccessible && score.within >= kWithin && score.deepest <= kDeepest))
      break;
    if (stalled)
      fitOptions.overhang += kOverhangStep;
    const Peeling grown = peelGuided(graph, field, rank, peelOptions, ctx);
    std::vector<float> target(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v)
      target[v] = grown.rank[v] > 0 ? std::max(grown.level[v], 0.25f) : field[v];
    adaptScreen(graph, field, target, deep, screen);
    field = target;
    fit.fit(field, target, screen, fitOptions, ctx);
  }
  ctx.report(1.0, "field");
  return out;
}

} // namespace voluta::curved
