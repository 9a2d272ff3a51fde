#include "curved/coarse_field.h"

#include "base/error.h"
#include "base/parallel.h"
#include "curved/field_fit.h"
#include "curved/flood.h"
#include "curved/reverse_growth.h"
#include "curved/smooth_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr float kUnset = std::numeric_limits<float>::infinity();

// The coarse grid: cells of `factor` fine cells per axis, an empty border, and the plate on a cell
// boundary.
struct Coarsening {
  int factor = 2;
  int plateLayer = 0;
  Eigen::Vector3i shift = Eigen::Vector3i::Zero(); // Fine cells to add before dividing
  voxel::VoxelGrid grid;

  explicit Coarsening(const VoxelGraph& graph) {
    while (static_cast<double>(graph.size()) / std::pow(factor, 3) >
           static_cast<double>(kFieldVoxels) / 2.0)
      ++factor;
    const int above = ((graph.plateLayer % factor) + factor) % factor;
    shift = Eigen::Vector3i(factor, factor, factor + (above == 0 ? 0 : factor - above));
    plateLayer = (graph.plateLayer + shift.z()) / factor;
    grid.pitch = graph.grid.pitch * factor;
    grid.origin = graph.grid.origin - graph.grid.pitch * shift.cast<double>();
    grid.size = ((graph.grid.size + shift).array() / factor + 2).matrix();
  }

  Eigen::Vector3i cellOf(const std::array<std::int16_t, 3>& fine) const {
    return {(fine[0] + shift.x()) / factor, (fine[1] + shift.y()) / factor,
            (fine[2] + shift.z()) / factor};
  }
};

// Extends the values from set voxels to unset ones, ring by ring, as means of the set neighbours.
void continueField(const VoxelGraph& graph, std::vector<float>& field) {
  std::vector<std::int32_t> open;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (field[v] == kUnset)
      open.push_back(static_cast<std::int32_t>(v));
  while (!open.empty()) {
    std::vector<std::pair<std::int32_t, float>> found;
    std::vector<std::int32_t> rest;
    for (const std::int32_t v : open) {
      float sum = 0.0f, count = 0.0f;
      for (const std::int32_t w : graph.neighbour[static_cast<std::size_t>(v)])
        if (w >= 0 && field[static_cast<std::size_t>(w)] != kUnset) {
          sum += field[static_cast<std::size_t>(w)];
          count += 1.0f;
        }
      if (count > 0.0f)
        found.emplace_back(v, sum / count);
      else
        rest.push_back(v);
    }
    base::require(!found.empty(), "coarseField: the voxels hang together");
    for (const auto& [v, value] : found)
      field[static_cast<std::size_t>(v)] = value;
    open = std::move(rest);
  }
}

} // namespace

std::vector<float> coarseField(const VoxelGraph& graph,
                               const std::vector<Eigen::Vector2d>& platform,
                               const LayerLimits& limits, int rounds,
                               const process::HeadShape* head, const base::RunContext& ctx) {
  const Coarsening coarsening(graph);
  const voxel::VoxelGrid& grid = coarsening.grid;
  std::vector<std::uint8_t> use(grid.cellCount(), 0);
  for (const auto& cell : graph.cell) {
    const Eigen::Vector3i c = coarsening.cellOf(cell);
    use[grid.index(c.x(), c.y(), c.z())] = 1;
  }
  std::vector<std::int32_t> rank;
  {
    const VoxelGraph all = voxelGraph(grid, use, coarsening.plateLayer, platform);
    const Peeling peeled = peelAll(all, {}, {}, ctx.quiet());
    for (std::size_t v = 0; v < all.size(); ++v) {
      use[all.cellOf(v)] = peeled.rank[v] > 0;
      if (peeled.rank[v] > 0)
        rank.push_back(peeled.rank[v]);
    }
  }
  const VoxelGraph coarse = voxelGraph(grid, use, coarsening.plateLayer, platform);
  base::require(coarse.size() > 0, "coarseField: something of the part stands on the platform");
  const std::vector<float> field =
      smoothField(coarse, rank, limits, rounds, head, {}, ctx.sub(0.0, 0.9)).field;
  const std::vector<Eigen::Vector3f> gradient = fieldGradient(coarse, field, ctx);

  ctx.report(0.9, "field"_text);
  std::vector<float> fine(graph.size(), kUnset);
  base::parallelChunks(ctx, graph.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Eigen::Vector3d fineCell(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2]);
      const Eigen::Vector3d at =
          (fineCell + coarsening.shift.cast<double>() + Eigen::Vector3d::Constant(0.5)) /
              coarsening.factor -
          Eigen::Vector3d::Constant(0.5);
      const Eigen::Vector3i low = at.array().floor().matrix().cast<int>();
      double sum = 0.0, weight = 0.0;
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i c = low + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
        if (!grid.contains(c.x(), c.y(), c.z()))
          continue;
        const std::int32_t u = coarse.voxelAt[grid.index(c.x(), c.y(), c.z())];
        if (u < 0)
          continue;
        const Eigen::Vector3d away = at - c.cast<double>();
        const double w =
            (1.0 - std::abs(away.x())) * (1.0 - std::abs(away.y())) * (1.0 - std::abs(away.z()));
        sum += w * (static_cast<double>(field[static_cast<std::size_t>(u)]) +
                    gradient[static_cast<std::size_t>(u)].cast<double>().dot(away));
        weight += w;
      }
      if (weight > 1e-3)
        fine[v] = static_cast<float>(std::max(0.0, sum / weight));
    }
  });
  continueField(graph, fine);
  const auto pitSlope = kPitSlope * static_cast<float>(graph.grid.pitch);
  return withoutPits(graph, fine, pitSlope, ctx);
}

} // namespace voluta::curved
