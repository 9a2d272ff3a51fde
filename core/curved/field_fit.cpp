#include "curved/field_fit.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace voluta::curved {

namespace {

constexpr std::size_t kGrain = 8192;

template <typename Body>
void eachVoxel(const VoxelGraph& graph, const base::RunContext& ctx, Body&& body) {
  base::parallelChunks(ctx, graph.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      body(v);
  });
}

// Rotates the unit vector d onto the cone d . n >= -limit, in the plane of d and n.
Eigen::Vector3f tiltOffOverhang(const Eigen::Vector3f& d, const Eigen::Vector3f& n, float limit) {
  const float along = d.dot(n);
  if (along >= -limit)
    return d;
  const Eigen::Vector3f across = d - along * n;
  const float length = across.norm();
  if (length < 1e-3f)
    return d;
  return -limit * n + std::sqrt(1.0f - limit * limit) / length * across;
}

} // namespace

std::vector<Eigen::Vector3f> fieldGradient(const VoxelGraph& graph, const std::vector<float>& field,
                                           const base::RunContext& ctx) {
  std::vector<Eigen::Vector3f> gradient(graph.size());
  eachVoxel(graph, ctx, [&](std::size_t v) {
    const auto value = [&](std::int32_t w) { return field[static_cast<std::size_t>(w)]; };
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t before = graph.neighbour[v][static_cast<std::size_t>(2 * axis)];
      const std::int32_t after = graph.neighbour[v][static_cast<std::size_t>(2 * axis + 1)];
      float slope = 0.0f;
      if (axis == 2 && graph.onPlatform[v])
        // Parabola through 0 at -1/2, the value here and the one above.
        slope = after >= 0 ? field[v] + value(after) / 3.0f : 2.0f * field[v];
      else if (before >= 0 && after >= 0)
        slope = 0.5f * (value(after) - value(before));
      else if (after >= 0)
        slope = value(after) - field[v];
      else if (before >= 0)
        slope = field[v] - value(before);
      gradient[v][axis] = slope;
    }
  });
  return gradient;
}

std::vector<Eigen::Vector3f> surfaceNormals(const VoxelGraph& graph, const base::RunContext& ctx) {
  const voxel::VoxelGrid& grid = graph.grid;
  // Blurred solid on the grid: cells outside are empty, cells below the plate equal those above it.
  std::vector<float> solid(grid.cellCount(), 0.0f), next(solid.size());
  for (std::size_t c = 0; c < solid.size(); ++c)
    solid[c] = graph.voxelAt[c] >= 0 ? 1.0f : 0.0f;
  const std::size_t stride[3] = {1, static_cast<std::size_t>(grid.size.x()),
                                 static_cast<std::size_t>(grid.size.x()) *
                                     static_cast<std::size_t>(grid.size.y())};
  const int plate = std::max(0, graph.plateLayer);
  const auto at = [&](const Eigen::Vector3i& cell, int axis, int step) {
    int c = cell[axis] + step;
    if (axis == 2)
      c = std::max(c, plate);
    if (c < 0 || c >= grid.size[axis])
      return 0.0f;
    return solid[grid.index(cell.x(), cell.y(), cell.z()) +
                 static_cast<std::size_t>(c) * stride[axis] -
                 static_cast<std::size_t>(cell[axis]) * stride[axis]];
  };
  const auto rows = static_cast<std::size_t>(grid.size.y() * grid.size.z());
  for (int pass = 0; pass < 2; ++pass)
    for (int axis = 0; axis < 3; ++axis) {
      base::parallelChunks(ctx, rows, 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
          Eigen::Vector3i cell(0, static_cast<int>(row) % grid.size.y(),
                               static_cast<int>(row) / grid.size.y());
          for (cell.x() = 0; cell.x() < grid.size.x(); ++cell.x())
            next[grid.index(cell.x(), cell.y(), cell.z())] =
                0.25f * (at(cell, axis, -1) + at(cell, axis, 1)) + 0.5f * at(cell, axis, 0);
        }
      });
      solid.swap(next);
    }

  std::vector<std::uint8_t> near(graph.size(), 0);
  for (std::size_t v = 0; v < graph.size(); ++v)
    for (std::size_t s = 0; s < 6; ++s)
      if (graph.neighbour[v][s] < 0 && !(s == 4 && graph.cell[v][2] == graph.plateLayer))
        near[v] = 1;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (near[v] == 1)
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = graph.neighbour[v][s];
            w >= 0 && !near[static_cast<std::size_t>(w)])
          near[static_cast<std::size_t>(w)] = 2;

  std::vector<Eigen::Vector3f> normals(graph.size(), Eigen::Vector3f::Zero());
  eachVoxel(graph, ctx, [&](std::size_t v) {
    if (!near[v])
      return;
    const Eigen::Vector3i cell(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2]);
    Eigen::Vector3f outward;
    for (int axis = 0; axis < 3; ++axis)
      outward[axis] = at(cell, axis, -1) - at(cell, axis, 1);
    if (outward.norm() > 0.02f)
      normals[v] = outward.normalized();
  });
  return normals;
}

FieldFit::FieldFit(const VoxelGraph& graph, const base::RunContext& ctx)
    : graph_(graph), solver_(graph), normals_(surfaceNormals(graph, ctx)) {}

void FieldFit::fit(std::vector<float>& field, const std::vector<float>& target,
                   const std::vector<float>& screen, const FitOptions& options,
                   const base::RunContext& ctx) {
  const std::size_t n = graph_.size();
  std::vector<Eigen::Vector3f> direction(n), wish(n);
  std::vector<float> rhs(n);
  solver_.setScreen(screen);
  for (int step = 0; step < options.steps; ++step) {
    const std::vector<Eigen::Vector3f> gradient = fieldGradient(graph_, field, ctx);
    eachVoxel(graph_, ctx, [&](std::size_t v) { direction[v] = gradient[v].normalized(); });
    eachVoxel(graph_, ctx, [&](std::size_t v) {
      Eigen::Vector3f sum = 2.0f * direction[v];
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = graph_.neighbour[v][s]; w >= 0)
          sum += direction[static_cast<std::size_t>(w)];
      Eigen::Vector3f d = sum.squaredNorm() > 1e-6f ? sum.normalized() : direction[v];
      if (normals_[v] != Eigen::Vector3f::Zero())
        d = tiltOffOverhang(d, normals_[v], options.overhang);
      wish[v] = d * std::clamp(gradient[v].norm(), options.slopeMin, options.slopeMax);
    });
    eachVoxel(graph_, ctx, [&](std::size_t v) {
      float sum = screen[v] * target[v];
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = graph_.neighbour[v][s]; w >= 0) {
          const int axis = static_cast<int>(s / 2);
          const float along = 0.5f * (wish[v][axis] + wish[static_cast<std::size_t>(w)][axis]);
          sum += s % 2 == 0 ? along : -along;
        }
      if (graph_.onPlatform[v])
        sum += wish[v].z();
      rhs[v] = sum;
    });
    solver_.solve(rhs, field, 1e-4, 6, ctx);
  }
}

} // namespace voluta::curved
