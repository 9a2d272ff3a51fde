#include "curved/smooth_field.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "curved/field_fit.h"
#include "curved/flood.h"
#include "curved/reverse_growth.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace voluta::curved {

namespace {

constexpr float kPitSlope = 0.15f; // least rise of the field from a voxel to one it carries
constexpr float kChanged = 0.3f;   // a growth that lowers the field by more holds it there
constexpr float kScreenMin = 0.003f, kScreenMax = 5.0f, kScreenStart = 0.05f;

// The screen grows where growth and field disagree and two rings round it, and decays elsewhere.
void adaptScreen(const VoxelGraph& graph, const std::vector<float>& field,
                 const std::vector<float>& target, std::vector<float>& screen) {
  std::vector<std::uint8_t> held(graph.size(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v)
    held[v] = std::abs(field[v] - target[v]) > kChanged;
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<std::uint8_t> inner = held;
    for (std::size_t v = 0; v < graph.size(); ++v)
      if (inner[v])
        for (const std::int32_t w : graph.neighbour[v])
          if (w >= 0)
            held[static_cast<std::size_t>(w)] = 1;
  }
  for (std::size_t v = 0; v < graph.size(); ++v)
    screen[v] = held[v] ? std::min(kScreenMax, std::max(screen[v], kScreenStart) * 4.0f)
                        : std::max(kScreenMin, screen[v] * 0.5f);
}

} // namespace

SmoothField smoothField(const VoxelGraph& graph, const LayerLimits& limits, int rounds,
                        const base::RunContext& ctx) {
  base::require(rounds >= 1 && graph.size() > 0, "smoothField: a round and a voxel or more");
  base::Stopwatch total;
  SmoothField out;
  ctx.report(0.0, "field");
  std::vector<float> field = geodesicDistance(graph, ctx);
  for (const float f : field)
    base::require(std::isfinite(f), "smoothField: every voxel is reached from the platform");
  FieldFit fit(graph, ctx);
  std::vector<float> screen(graph.size(), kScreenStart);
  FitOptions first;
  first.slopeMin = 0.85f;
  first.slopeMax = 1.15f;
  fit.fit(field, std::vector<float>(field), screen, first, ctx);

  PeelOptions peelOptions;
  peelOptions.tolerance = 0.25;
  peelOptions.sheet = 0.75;
  peelOptions.sacrifice = false;
  std::vector<float> best;
  for (int round = 0; round < rounds; ++round) {
    const double done = (round + 0.5) / (rounds + 0.5);
    ctx.report(done, "field");
    field = flood(graph, {}, field, kPitSlope, ctx, Steps::FacesFirst).value;
    const FieldScore score = scoreField(graph, field, fit.normals(), limits, ctx);
    out.rounds.push_back(score);
    if (best.empty() || score.total() < out.score.total()) {
      best = field;
      out.score = score;
    }
    if (round + 1 == rounds)
      break;
    base::Stopwatch growing;
    const Peeling grown = peel(graph, {}, field, peelOptions, ctx.sub(done, done));
    out.growSeconds += growing.seconds();
    std::vector<float> target(graph.size());
    for (std::size_t v = 0; v < graph.size(); ++v)
      target[v] = grown.rank[v] > 0 ? std::max(grown.level[v], 0.25f) : field[v];
    adaptScreen(graph, field, target, screen);
    fit.fit(field, target, screen, {}, ctx);
  }
  const auto toMm = static_cast<float>(out.score.scale * graph.grid.pitch);
  for (float& f : best)
    f *= toMm;
  out.field = std::move(best);
  out.smoothSeconds = total.seconds() - out.growSeconds;
  ctx.report(1.0, "field");
  return out;
}

} // namespace voluta::curved
